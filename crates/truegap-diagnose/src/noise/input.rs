//! White noise of a recorded input, from what is left of it after taking out straight lines.
//!
//! Limits: an input that is not straight over three rows in most places would look noisy.

use std::ops::Range;

/// Standard deviation of white noise on a column, robust against corners and steps of a profile.
///
/// The second difference of white noise has six times its variance; its median absolute value ignores corners.
pub fn scatter(column: &[f64], runs: &[Range<usize>]) -> f64 {
    let mut second: Vec<f64> = Vec::new();
    for run in runs {
        let part = &column[run.clone()];
        second.extend(part.windows(3).map(|w| (w[0] - 2.0 * w[1] + w[2]).abs()));
    }
    if second.is_empty() {
        return 0.0;
    }
    let middle = second.len() / 2;
    let (_, median, _) = second.select_nth_unstable_by(middle, f64::total_cmp);
    *median / 0.674_489_750_196_081_7 / 6f64.sqrt()
}

#[cfg(test)]
#[allow(clippy::single_range_in_vec_init)]
mod tests {
    use super::*;
    use rand::SeedableRng;
    use rand_distr::Distribution;

    #[test]
    fn corners_of_a_staircase_do_not_count_as_noise() {
        let mut rng = rand_chacha::ChaCha8Rng::seed_from_u64(1);
        let normal = rand_distr::Normal::new(0.0, 0.005).unwrap();
        let column: Vec<f64> = (0..4000).map(|i| f64::from(i / 60 % 5) + normal.sample(&mut rng)).collect();
        // 4000 rows: the median of 4000 correlated absolute values is good to about 3 %
        approx::assert_relative_eq!(scatter(&column, &[0..4000]), 0.005, max_relative = 0.08);
        let clean: Vec<f64> = (0..400).map(|i| f64::from(i / 60)).collect();
        assert_eq!(scatter(&clean, &[0..400]), 0.0);
    }
}
