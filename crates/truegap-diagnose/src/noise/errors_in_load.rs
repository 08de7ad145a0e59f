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

/// Middle coefficients of the second, fourth and sixth difference, less the sign: what each has in common with the noise of its row, in variances of the noise.
const COMMON: [f64; 3] = [2.0, 6.0, 20.0];

/// Differences of even order of a column within its runs, 0 at the ends of runs, each times what its weight may be: the weight that would be best if the difference stood alone,
/// the noise's share of it over its mean square. Large bends show that little smoothing is right, as on a square wave of a few rows.
pub fn error_shapes(column: &[f64], runs: &[Range<usize>], sd: f64) -> Vec<Vec<f64>> {
    let mut differences = column.to_vec();
    COMMON
        .iter()
        .enumerate()
        .map(|(order, common)| {
            differences = second_difference(&differences, runs, order + 1);
            let square = differences.iter().map(|d| d * d).sum::<f64>() / differences.len().max(1) as f64;
            let weight = if square > 0.0 { common * sd * sd / square } else { 0.0 };
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
    use rand::SeedableRng;
    use rand_distr::{Distribution, Normal};

    /// A parabola has a second difference of 2 and none beyond; a cosine is multiplied by 2 cos w - 2 each time.
    #[test]
    fn error_shapes_are_differences_of_even_order_inside_runs() {
        let parabola: Vec<f64> = (0..20).map(|i| f64::from(i * i)).collect();
        let [second, fourth, _] = <[Vec<f64>; 3]>::try_from(error_shapes(&parabola, &[0..9, 9..20], 0.1)).unwrap();
        // 16 of 20 rows have one; weight 2 x 0.01 over 4 x 16 / 20
        assert_eq!((second[0], second[8], second[9]), (0.0, 0.0, 0.0));
        approx::assert_relative_eq!(second[4], 2.0 * 0.02 / 3.2, max_relative = 1e-12);
        assert!(fourth.iter().all(|f| f.abs() < 1e-12));
        let wave: Vec<f64> = (0..20).map(|i| (0.7 * f64::from(i)).cos()).collect();
        let sixth = &error_shapes(&wave, &[0..20], 1.0)[2];
        let factor = sixth[10] / ((2.0 * 0.7f64.cos() - 2.0).powi(3) * wave[10]);
        approx::assert_relative_eq!(sixth[9], factor * (2.0 * 0.7f64.cos() - 2.0).powi(3) * wave[9], max_relative = 1e-10);
    }

    /// The best weight of a second difference: what a regression of the noise on it finds.
    #[test]
    fn the_weight_is_that_of_the_best_smoothing() {
        let mut rng = rand_chacha::ChaCha8Rng::seed_from_u64(21);
        let (noise, push) = (Normal::new(0.0, 0.005).unwrap(), Normal::new(0.0, 0.02).unwrap());
        let (mut x, mut speed) = (0.0, 0.0);
        let (clean, noisy): (Vec<f64>, Vec<f64>) = (0..20_000)
            .map(|_| {
                speed = 0.9 * speed + push.sample(&mut rng);
                x += speed;
                (x, x + noise.sample(&mut rng))
            })
            .unzip();
        let second = &error_shapes(&noisy, &[0..20_000], 0.005)[0];
        let along: f64 = second.iter().zip(clean.iter().zip(&noisy)).map(|(s, (c, n))| s * (c - n)).sum();
        // 20 000 rows: the regression is good to about 3 %
        approx::assert_relative_eq!(along / second.iter().map(|s| s * s).sum::<f64>(), 1.0, max_relative = 0.1);
    }
}
