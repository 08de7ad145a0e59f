//! White noise of a recorded input, from what is left of it after taking out straight lines.
//!
//! Limits: an input that is not straight over three rows in most places would look noisy.

use crate::{
    noise::denoise::crookedness,
    noise::tuning::{CLEARLY_SMALLER, LEAST_LEFT, LONG_RUN, MOSTLY_CURVED, SCATTER_STRETCH, STRAIGHT},
    stats::{MEDIAN_NORMAL, median},
};
use std::ops::Range;

/// Standard deviation of white noise on a column, robust against corners and steps of a profile.
///
/// Differences of order k of white noise have `C(2k, k)` times its variance; their median absolute value ignores corners. A profile that bends all the time
/// leaves less in differences of higher order, so the least of three orders is believed where it is clearly less; a straight one on uneven moments leaves less about
/// lines over time. Where most rows lie on curves, the quieter quarter of short stretches says much less than the median of all, and is believed.
pub fn scatter(column: &[f64], time: Option<&[f64]>, runs: &[Range<usize>]) -> f64 {
    let second = of_order(column, runs, 1).unwrap_or(0.0);
    let [fourth, sixth] = [2, 3].map(|pairs| of_order(column, runs, pairs).unwrap_or(f64::INFINITY));
    let about_lines = (crookedness(column, time, runs, 1.0) / STRAIGHT).sqrt();
    let enough = runs.iter().any(|r| r.len() > LONG_RUN);
    let least = if enough { about_lines } else { f64::INFINITY }.min(fourth).min(sixth);
    if least < CLEARLY_SMALLER * second { least } else { second }
}

/// The noise of a column that bends all the time: an upper limit from differences, and what is left of it when the bends are taken out.
///
/// Where the speed is pushed at random, differences of order k hold the noise and the push in the ratio `C(2k, k)` to `C(2k - 4, k - 2)`; two orders tell them
/// apart. Where higher differences are no smaller, nothing bends, and the two are the same.
pub fn bent(column: &[f64], runs: &[Range<usize>]) -> (f64, f64) {
    let orders = [1, 2, 3, 4, 5, 6].map(|pairs| of_order(column, runs, pairs));
    let most = orders.into_iter().flatten().fold(f64::INFINITY, f64::min);
    let (Some(second), Some(last)) = (orders[0], orders[5]) else { return (most, most) };
    let (second, last) = (second.powi(2), last.powi(2));
    let share = |k: usize| binomial(2 * k - 4) / binomial(2 * k);
    let push = ((second - last) / (share(2) - share(12))).max(0.0);
    let unbent = (last - share(12) * push).max(0.0).sqrt();
    (most, unbent.clamp(LEAST_LEFT * most, most))
}

/// `C(n, n / 2)`.
fn binomial(n: usize) -> f64 {
    (1..=n / 2).map(|i| (n / 2 + i) as f64 / i as f64).product()
}

/// The estimate from differences of order `2 pairs`; `None` where no run is long enough for one.
fn of_order(column: &[f64], runs: &[Range<usize>], pairs: usize) -> Option<f64> {
    let mut differences: Vec<f64> = Vec::new();
    for run in runs {
        let mut part = column[run.clone()].to_vec();
        for _ in 0..pairs {
            part = part.windows(3).map(|w| w[0] - 2.0 * w[1] + w[2]).collect();
        }
        differences.extend(part.iter().map(|d| d.abs()));
    }
    let factor = binomial(4 * pairs).sqrt();
    let mut stretches: Vec<f64> =
        differences.chunks(SCATTER_STRETCH).filter(|c| c.len() == SCATTER_STRETCH).map(median).collect();
    stretches.sort_by(f64::total_cmp);
    let all = median(&differences);
    let quiet = stretches.get(stretches.len() / 4).copied().unwrap_or(all);
    let typical = if quiet < MOSTLY_CURVED * all { quiet } else { all };
    (!differences.is_empty()).then(|| typical / MEDIAN_NORMAL / factor)
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
        approx::assert_relative_eq!(scatter(&column, None, &[0..4000]), 0.005, max_relative = 0.08);
        let clean: Vec<f64> = (0..400).map(|i| f64::from(i / 60)).collect();
        assert_eq!(scatter(&clean, None, &[0..400]), 0.0);
    }

    /// A load that wanders in waves of twelve rows: second differences see its curvature, which is three times the noise.
    #[test]
    fn a_profile_that_bends_all_the_time_does_not_pass_for_noise() {
        let mut rng = rand_chacha::ChaCha8Rng::seed_from_u64(5);
        let normal = rand_distr::Normal::new(0.0, 0.005).unwrap();
        let wave = |i: i32| 0.1 * (f64::from(i) * 0.5).sin() + 0.07 * (f64::from(i) * 0.31).cos();
        let column: Vec<f64> = (0..3000).map(|i| wave(i) + normal.sample(&mut rng)).collect();
        assert!(of_order(&column, &[0..3000], 1).unwrap() > 0.007);
        approx::assert_relative_eq!(scatter(&column, None, &[0..3000]), 0.005, max_relative = 0.15);
    }

    #[test]
    fn a_profile_that_is_mostly_curved_does_not_pass_for_noise() {
        let mut rng = rand_chacha::ChaCha8Rng::seed_from_u64(2);
        let normal = rand_distr::Normal::new(0.0, 0.005).unwrap();
        let curved = |i: i32| if i % 100 < 60 { (f64::from(i) * 0.9).sin() } else { 0.5 };
        let column: Vec<f64> = (0..1000).map(|i| curved(i) + normal.sample(&mut rng)).collect();
        // a quarter of the stretches is at rest; the quartile of medians of 12 is low by up to a third
        approx::assert_relative_eq!(scatter(&column, None, &[0..1000]), 0.005, max_relative = 0.4);
    }
}
