//! Noise whose level changes: waves in a storm, a gust, a machine nearby.
//!
//! How loud a row is is told from rows about it, those next to it left out, so that the likelihood of what is left there is that of a prediction and pays for itself. Noise of one level, taken from the quieter stretches, would make
//! a jump or a wander of each loud hour.
//!
//! **Source:** Dawid, Present position and potential developments, J. R. Stat. Soc. A 147 (1984) 278, for likelihoods of predictions.
//!
//! Limits: one recording with a clock; white noise; a level that changes over some tens of rows and more.

use crate::{
    data::problem::Problem,
    noise::{
        apart::apart,
        learned_again::of_rows_alike,
        response::no_finer_than_read,
        tuning::{BESIDE, FAILS, LEAST_LEVEL, LEVEL_ROWS},
    },
    stats::{median, rms},
    whitening::{noise_model::NoiseModel, whitener::Noise},
};
use std::ops::Range;

/// The noises that `misfit` may have, each with a level that changes over as many rows of its kind; none where it has no scatter.
pub(crate) fn changing_levels(problem: &Problem<'_>, misfit: &[f64], noise: &NoiseModel) -> Vec<NoiseModel> {
    let alike = of_rows_alike(noise);
    let of = |rows: usize| {
        let sd = levels(misfit, &problem.runs(), rows).filter(|sd| !fails(sd))?;
        let least = sd.iter().copied().fold(f64::INFINITY, f64::min);
        let response = no_finer_than_read(Noise { white_sd: least, ar_sd: 0.0, ar_correlation: 0.0 }, problem);
        let mut input_error = alike.input_error.clone();
        input_error.louder.resize(sd.len(), 0.0);
        let louder = |sd: f64| (sd * sd - response.white_sd.powi(2)).max(0.0);
        input_error.louder.iter_mut().zip(&sd).for_each(|(known, sd)| *known = known.max(louder(*sd)));
        let says = format!("{}; noise whose level changes: louder rows weigh less", noise.says);
        Some(NoiseModel { response, input_error, says, ..alike.clone() })
    };
    LEVEL_ROWS.into_iter().filter_map(of).collect()
}

/// Whether rows are so much louder than the usual ones that something failed there: a storm has waves of a few times the height.
fn fails(sd: &[f64]) -> bool {
    sd.iter().copied().fold(0.0, f64::max) > FAILS * median(sd)
}

/// Standard deviation at each row, from as many rows before and after it, those next to it left out.
fn levels(misfit: &[f64], runs: &[Range<usize>], rows: usize) -> Option<Vec<f64>> {
    let squares: Vec<f64> = apart(misfit, runs).into_iter().map(|a| a.about.powi(2)).collect();
    let all = rms(misfit.iter().copied());
    let mean = squares.iter().sum::<f64>() / squares.len().max(1) as f64;
    if mean <= 0.0 {
        return None;
    }
    let mut sd = vec![all; misfit.len()];
    for run in runs {
        for row in run.clone() {
            let before = row.saturating_sub(BESIDE + rows).max(run.start)..row.saturating_sub(BESIDE).max(run.start);
            let after = (row + 1 + BESIDE).min(run.end)..(row + 1 + BESIDE + rows).min(run.end);
            let count = (before.len() + after.len()) as f64;
            let sum = squares[before].iter().chain(&squares[after]).sum::<f64>();
            // what few rows say is as sure as they are many
            let told = (sum + LEAST_LEVEL * mean) / (count + LEAST_LEVEL);
            sd[row] = all * (told / mean).sqrt();
        }
    }
    Some(sd)
}

#[cfg(test)]
#[allow(clippy::single_range_in_vec_init)] // one run
mod tests {
    use super::*;
    use rand::SeedableRng;
    use rand_chacha::ChaCha8Rng;
    use rand_distr::{Distribution, StandardNormal};

    const ROWS: usize = 2000;

    /// Twice the log likelihood of a prediction of each row's level over that of one level for all.
    fn gained(level: impl Fn(usize) -> f64, seed: u64) -> f64 {
        let random = &mut ChaCha8Rng::seed_from_u64(seed);
        let mut drawn = || -> f64 { StandardNormal.sample(random) };
        let misfit: Vec<f64> = (0..ROWS).map(|row| level(row) * drawn()).collect();
        let deviance = |sd: &[f64]| misfit.iter().zip(sd).map(|(m, sd)| (m / sd).powi(2) + 2.0 * sd.ln()).sum::<f64>();
        let one = vec![rms(misfit.iter().copied()); ROWS];
        let best = LEVEL_ROWS.into_iter().filter_map(|rows| levels(&misfit, &[0..ROWS], rows));
        deviance(&one) - best.map(|sd| deviance(&sd)).fold(f64::INFINITY, f64::min)
    }

    /// A cell that fails in a twelfth of the rows by 50 times the noise was told as a loud hour; waves of `exp(sin)` are 2.7 times as high as the usual ones at most.
    #[test]
    fn what_is_far_louder_than_usual_has_failed() {
        let random = &mut ChaCha8Rng::seed_from_u64(6);
        let mut told = |level: &dyn Fn(usize) -> f64| {
            let misfit: Vec<f64> = (0..ROWS)
                .map(|row| level(row) * <StandardNormal as Distribution<f64>>::sample(&StandardNormal, random))
                .collect();
            LEVEL_ROWS.map(|rows| levels(&misfit, &[0..ROWS], rows).is_some_and(|sd| fails(&sd)))
        };
        assert!(told(&|row| if (700..860).contains(&row) { 50.0 } else { 1.0 }).iter().all(|fails| *fails));
        assert!(!told(&|row| (row as f64 / 40.0).sin().exp()).iter().any(|fails| *fails));
    }

    /// Of a level that goes as `exp(sin)` the true one gains `2 n ln I0(2)^(1/2)` = 0.82 a row, the mean of the logarithm being 0.
    #[test]
    fn a_level_that_changes_predicts_rows_and_one_level_is_left_alone() {
        for seed in 0..5 {
            let storm = gained(|row| (row as f64 / 40.0).sin().exp(), seed);
            assert!((0.6..0.9).contains(&(storm / ROWS as f64)), "{storm}");
            let calm = gained(|_| 0.3, seed);
            assert!(calm < 10.0, "{calm}");
        }
    }
}
