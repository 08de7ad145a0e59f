//! An input that bends all the time: no straight line holds for more than a few rows.
//!
//! Such a column keeps its noise, since any smoothing of it would flatten its bends, and flattened bends look like physics: a load too smooth by its second
//! derivative is what a late reading and a late clock make together. But noise that is kept does the same with the opposite sign: given a noisy load, the best
//! guess at the true one is a smoothed one, and a response often knows the load better than the load cell does. So the response is left to say how the load should
//! have been smoothed: the error follows the bends of even order with weights that are not known.
//!
//! Limits: one smoothing for the whole column, symmetric, over seven rows.
//!
//! **Source:** the regression of a true input on a noisy one, Fuller, Measurement Error Models (1987), section 1.2, applied to the neighbours of a row.

use std::ops::Range;

/// Standard deviations of the weights of the second, fourth and sixth differences; smoothing by (1, 2, 1) / 4 is a quarter of the second.
const WEIGHTS: [f64; 3] = [0.3, 0.1, 0.03];

/// Differences of even order of a column within its runs, each times what its weight may be; 0 at the ends of runs.
pub fn bends(column: &[f64], runs: &[Range<usize>]) -> Vec<Vec<f64>> {
    let mut differences = column.to_vec();
    WEIGHTS
        .iter()
        .enumerate()
        .map(|(order, weight)| {
            differences = second_difference(&differences, runs, order + 1);
            differences.iter().map(|d| weight * d).collect()
        })
        .collect()
}

/// Second difference of each row that lies at least `margin` rows inside its run.
fn second_difference(column: &[f64], runs: &[Range<usize>], margin: usize) -> Vec<f64> {
    let mut out = vec![0.0; column.len()];
    for run in runs.iter().filter(|r| r.len() > 2 * margin) {
        for row in run.start + margin..run.end - margin {
            out[row] = column[row - 1] - 2.0 * column[row] + column[row + 1];
        }
    }
    out
}

#[cfg(test)]
#[allow(clippy::single_range_in_vec_init)]
mod tests {
    use super::*;

    /// A parabola has a second difference of 2 and none beyond; a cosine is multiplied by 2 cos w - 2 each time.
    #[test]
    fn bends_are_differences_of_even_order_inside_runs() {
        let parabola: Vec<f64> = (0..20).map(|i| f64::from(i * i)).collect();
        let [second, fourth, _] = <[Vec<f64>; 3]>::try_from(bends(&parabola, &[0..9, 9..20])).unwrap();
        assert_eq!((second[0], second[8], second[9], second[4]), (0.0, 0.0, 0.0, 2.0 * WEIGHTS[0]));
        assert!(fourth.iter().all(|f| f.abs() < 1e-12));
        let wave: Vec<f64> = (0..20).map(|i| (0.7 * f64::from(i)).cos()).collect();
        let sixth = &bends(&wave, &[0..20])[2];
        let factor = (2.0 * 0.7f64.cos() - 2.0).powi(3);
        approx::assert_relative_eq!(sixth[10], WEIGHTS[2] * factor * wave[10], max_relative = 1e-12);
    }
}
