//! White noise of a recorded input, from what is left of it after taking out straight lines.
//!
//! Limits: an input that is not straight over three rows in most places would look noisy.

use std::ops::Range;

/// Standard deviation of white noise on a column, robust against corners and steps of a profile.
///
/// The second difference of white noise has six times its variance; its median absolute value ignores corners. Where most rows lie on curves, the quieter
/// quarter of short stretches says much less than the median of all, and is believed.
pub fn scatter(column: &[f64], runs: &[Range<usize>]) -> f64 {
    let mut second: Vec<f64> = Vec::new();
    for run in runs {
        let part = &column[run.clone()];
        second.extend(part.windows(3).map(|w| (w[0] - 2.0 * w[1] + w[2]).abs()));
    }
    let mut stretches: Vec<f64> =
        second.chunks(STRETCH).filter(|c| c.len() == STRETCH).map(|c| median(&mut c.to_vec())).collect();
    stretches.sort_by(f64::total_cmp);
    let all = median(&mut second);
    let quiet = stretches.get(stretches.len() / 4).copied().unwrap_or(all);
    let typical = if quiet < MOSTLY_CURVED * all { quiet } else { all };
    typical / 0.674_489_750_196_081_7 / 6f64.sqrt()
}

/// Rows of a short stretch.
const STRETCH: usize = 12;
/// Share of the median of all below which the quieter stretches are believed; noise alone gives about 0.8.
const MOSTLY_CURVED: f64 = 0.5;

/// Median of absolute values; 0 of none.
fn median(values: &mut [f64]) -> f64 {
    if values.is_empty() {
        return 0.0;
    }
    let middle = values.len() / 2;
    *values.select_nth_unstable_by(middle, f64::total_cmp).1
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

    #[test]
    fn a_profile_that_is_mostly_curved_does_not_pass_for_noise() {
        let mut rng = rand_chacha::ChaCha8Rng::seed_from_u64(2);
        let normal = rand_distr::Normal::new(0.0, 0.005).unwrap();
        let curved = |i: i32| if i % 100 < 60 { (f64::from(i) * 0.9).sin() } else { 0.5 };
        let column: Vec<f64> = (0..1000).map(|i| curved(i) + normal.sample(&mut rng)).collect();
        // a quarter of the stretches is at rest; the quartile of medians of 12 is low by up to a third
        approx::assert_relative_eq!(scatter(&column, &[0..1000]), 0.005, max_relative = 0.4);
    }
}
