//! Bursts: stretches of some rows in which the residual is louder than the noise.
//!
//! Limits: bursts of about ten to thirty rows; judged on every row, since means of rows silence them.

use crate::adequacy::tuning::{BURST_LEVEL, BURST_WINDOWS};
use crate::stats::{log_upper_tail, upper_tail};
use std::ops::Range;

/// Rows in which the residual is louder than the noise.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize)]
pub struct Burst {
    /// first row
    pub row: usize,
    /// number of rows
    pub rows: usize,
    /// root-mean-square of the whitened residual there; 1 for noise
    pub loudness: f64,
    /// probability of one as loud, with all windows counted
    pub p_value: f64,
}

impl Burst {
    /// The loudest of overlapping windows of a whitened residual, by its chi-squared; `slack` is the factor by which the noise may be larger than taken.
    pub fn loudest(residual: &[f64], runs: &[Range<usize>], slack: f64) -> Self {
        let starts = |rows: usize| runs.iter().flat_map(move |r| r.clone().step_by(rows / 2).filter(move |s| s + rows <= r.end));
        let windows: usize = BURST_WINDOWS.iter().map(|rows| starts(*rows).count()).sum();
        let of = |rows: usize, row: usize| {
            let squares = residual[row..row + rows].iter().map(|r| r * r).sum::<f64>();
            let p_value = (upper_tail(squares / slack, rows) * windows as f64).min(1.0);
            Self { row, rows, loudness: (squares / rows as f64).sqrt(), p_value }
        };
        let all = BURST_WINDOWS.iter().flat_map(|rows| starts(*rows).map(|row| of(*rows, row)));
        // of bursts beyond the least number that there is, and of windows in noise, the loudest by its logarithm
        let log = |found: &Self| log_upper_tail(found.loudness.powi(2) * found.rows as f64 / slack, found.rows / 2);
        let rarer = |a: &Self, b: &Self| a.p_value.total_cmp(&b.p_value).then_with(|| log(a).total_cmp(&log(b)));
        all.min_by(rarer).unwrap_or(Self { row: 0, rows: 0, loudness: 1.0, p_value: 1.0 })
    }

    /// Whether it is there.
    pub fn is_significant(&self) -> bool {
        self.p_value < BURST_LEVEL
    }
}

#[cfg(test)]
#[allow(clippy::single_range_in_vec_init)] // one run
mod tests {
    use super::*;
    use rand::SeedableRng;
    use rand_chacha::ChaCha8Rng;
    use rand_distr::{Distribution, StandardNormal};

    fn noise(seed: u64) -> Vec<f64> {
        let random = &mut ChaCha8Rng::seed_from_u64(seed);
        (0..2000).map(|_| StandardNormal.sample(random)).collect()
    }

    #[test]
    fn a_burst_is_found_where_it_is_and_noise_is_not_one() {
        let runs = [0..900, 900..2000];
        for seed in 0..20 {
            // one in a million a recording
            assert!(!Burst::loudest(&noise(seed), &runs, 1.0).is_significant(), "{seed}");
            let mut residual = noise(seed);
            (1207..1232).for_each(|row| residual[row] += 4.0 * (1.9 * row as f64).sin());
            let found = Burst::loudest(&residual, &runs, 1.0);
            // a tone of amplitude 4 brings the scatter to sqrt(1 + 8); windows overlap by half, so that one holds three quarters of it
            assert!(found.is_significant() && found.row.abs_diff(1207) <= 24 && (found.loudness - 3.0).abs() < 0.9, "{found:?}");
        }
    }

    /// A thousand times the noise has no probability that a number can hold, and a burst of sixty before it has none either.
    #[test]
    fn the_loudest_of_bursts_beyond_all_numbers_is_told() {
        let mut residual = noise(4);
        (200..224).for_each(|row| residual[row] = 60.0);
        (1208..1216).for_each(|row| residual[row] = 1000.0);
        let found = Burst::loudest(&residual, &[0..2000], 1.0);
        assert_eq!((found.row, found.rows, found.p_value), (1208, 8, 0.0));
    }

    #[test]
    fn noise_that_is_louder_throughout_is_no_burst_where_its_level_is_not_known() {
        let louder: Vec<f64> = noise(3).iter().map(|v| 1.3 * v).collect();
        assert!(!Burst::loudest(&louder, &[0..900, 900..2000], 2.0).is_significant());
    }
}
