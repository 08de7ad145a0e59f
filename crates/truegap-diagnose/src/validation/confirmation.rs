//! Two models that were fitted elsewhere, judged on a recording that took no part.
//!
//! Limits: blocks of one run share a history and are taken to be independent; a single wild reading costs power, it does not decide.

use crate::{
    data::{error::DiagnoseError, joint::Free, problem::Problem},
    noise::{
        response::{follows_nothing, from_misfit},
        several::measured,
    },
    seeds::SEEDS,
    stats::rms,
    validation::tuning::{CONFIRMATION_BLOCKS, EXACT_BLOCKS, SHORTEST_BLOCK, SIGN_DRAWS},
};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use serde::Serialize;
use std::ops::Range;

/// Probability with which two models of equal error would be told apart.
pub const LEVEL: f64 = 0.05;

/// Whether another recording bears out what was added to a base model.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Judgement {
    /// the augmented model is the better one
    Confirmed,
    /// the augmented model is the worse one
    Refuted,
    /// neither, at [`LEVEL`]
    CannotTell,
}

impl Judgement {
    /// `confirmed`, `refuted` or `cannot tell`.
    pub fn words(self) -> &'static str {
        match self {
            Self::Confirmed => "confirmed",
            Self::Refuted => "refuted",
            Self::CannotTell => "cannot tell",
        }
    }
}

/// Two predictions compared block by block.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Compared {
    /// blocks of rows
    pub blocks: usize,
    /// blocks in which the augmented model is the better one
    pub better_in: usize,
    /// mean squared error of the base model less that of the augmented model, square of the response's unit
    pub difference: f64,
    /// two-sided p-value: share of the sign flips of the blocks whose difference is at least as large
    pub p_value: f64,
    /// what follows
    pub judgement: Judgement,
}

/// Gain and offset of a reading against a prediction.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Reading {
    /// reading over prediction; 1 where it is not free
    pub gain: f64,
    /// in the response's unit; 0 where it is not free
    pub offset: f64,
}

impl Reading {
    /// The least-squares gain and offset, as far as they are free:
    ///
    /// $$ g = \frac{\sum (p - \bar p)(y - \bar y)}{\sum (p - \bar p)^2}, \quad o = \bar y - g \bar p $$
    ///
    /// A gain without an offset goes through zero. A prediction that does not move says nothing of the gain, which stays 1.
    pub fn fitted(prediction: &[f64], response: &[f64], Free { gain, offset }: Free) -> Self {
        let rows = response.len().max(1) as f64;
        let mean = |column: &[f64]| if offset { column.iter().sum::<f64>() / rows } else { 0.0 };
        let (p, y) = (mean(prediction), mean(response));
        let square: f64 = prediction.iter().map(|v| (v - p).powi(2)).sum();
        let product: f64 = prediction.iter().zip(response).map(|(v, r)| (v - p) * (r - y)).sum();
        let greatest = prediction.iter().fold(0.0f64, |m, v| m.max(v.abs()));
        let moves = square > rows * (1e-9 * greatest).powi(2);
        let gain = if gain && moves { product / square } else { 1.0 };
        Self { gain, offset: if offset { y - gain * p } else { 0.0 } }
    }

    /// What is read where the prediction is right.
    pub fn of(&self, prediction: &[f64]) -> Vec<f64> {
        prediction.iter().map(|p| self.gain * p + self.offset).collect()
    }
}

/// The noise of a recording.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct NoiseFloor {
    /// root mean square of one row's noise, response unit
    pub rmse: f64,
    /// whether it was measured apart from the misfit
    pub measured: bool,
    /// where it comes from, for a reader
    pub says: String,
}

/// The noise of a recording: at rest or from rows measured again, and where there are none from what the augmented model leaves over in short stretches, `left`
/// being what it leaves over of each row. (What the base model leaves there holds the physics that it lacks, as far as that is fast.)
///
/// What a model leaves that was not fitted to these rows holds their noise: the noise is never said to be larger.
///
/// # Errors
/// [`DiagnoseError`] where the base model has no answer.
pub fn noise_floor(problem: &Problem<'_>, left: &[f64]) -> Result<NoiseFloor, DiagnoseError> {
    let (inputs, noise) = measured(problem)?;
    let (mut rmse, mut says) = (noise.floor(), noise.says.clone());
    if !noise.measured {
        let still = Problem { inputs: &inputs, response: problem.response, simulator: problem.simulator };
        let fuller = from_misfit(&still, &follows_nothing(&inputs, left.to_vec()), &noise);
        if fuller.floor() < rmse {
            (rmse, says) = (fuller.floor(), fuller.says.replace("the calibrated model", "the augmented model"));
        }
    }
    let most = rms(left.iter().copied());
    if most < rmse {
        says += "; no more than the augmented model leaves in all rows";
    }
    Ok(NoiseFloor { rmse: rmse.min(most), measured: noise.measured, says })
}

/// Two predictions of one response, compared over the blocks of its runs.
///
/// Each block gives the sum over its rows of the squared errors of the base model less those of the augmented model. Were the two equally good, each sum could
/// as well have the other sign: the p-value is the share of all sign flips whose total is at least as far from 0. The total over all blocks is the difference of
/// the two mean squared errors, so the judgement never speaks against them.
///
/// **Source:** Good, Permutation, Parametric and Bootstrap Tests of Hypotheses, 3rd ed., section 3.2 (one-sample test by signs).
pub fn compared(base: &[f64], augmented: &[f64], response: &[f64], runs: &[Range<usize>]) -> Compared {
    compared_at(LEVEL, [base, augmented], response, runs)
}

/// The same at another level, as where several comparisons share one.
pub fn compared_at(level: f64, [base, augmented]: [&[f64]; 2], response: &[f64], runs: &[Range<usize>]) -> Compared {
    let gained = |row: usize| (response[row] - base[row]).powi(2) - (response[row] - augmented[row]).powi(2);
    let sums: Vec<f64> = blocks(runs).into_iter().map(|block| block.map(gained).sum()).collect();
    let difference = sums.iter().sum::<f64>() / response.len().max(1) as f64;
    let p_value = by_signs(&sums);
    let judgement = match p_value < level {
        true if difference > 0.0 => Judgement::Confirmed,
        true => Judgement::Refuted,
        false => Judgement::CannotTell,
    };
    Compared { blocks: sums.len(), better_in: sums.iter().filter(|sum| **sum > 0.0).count(), difference, p_value, judgement }
}

/// Runs, each cut into equal parts where there are fewer than [`CONFIRMATION_BLOCKS`] of them.
fn blocks(runs: &[Range<usize>]) -> Vec<Range<usize>> {
    let wanted = CONFIRMATION_BLOCKS.div_ceil(runs.len().max(1));
    let cut = |run: &Range<usize>| {
        let (first, rows) = (run.start, run.len());
        let parts = wanted.min(rows / SHORTEST_BLOCK).max(1);
        (0..parts).map(move |k| first + k * rows / parts..first + (k + 1) * rows / parts)
    };
    runs.iter().flat_map(cut).collect()
}

/// Two-sided p-value of a sum whose terms could as well have the other sign.
fn by_signs(terms: &[f64]) -> f64 {
    let size: f64 = terms.iter().map(|t| t.abs()).sum();
    // sums of the same terms in another order differ in their last digits
    let reached = terms.iter().sum::<f64>().abs() - 1e-12 * size;
    if size == 0.0 {
        return 1.0;
    }
    if terms.len() <= EXACT_BLOCKS {
        let flipped =
            |flips: usize| terms.iter().enumerate().map(|(k, t)| if flips >> k & 1 == 1 { -t } else { *t }).sum::<f64>();
        let ways = 1usize << terms.len();
        return (0..ways).filter(|flips| flipped(*flips).abs() >= reached).count() as f64 / ways as f64;
    }
    let mut random = ChaCha8Rng::seed_from_u64(SEEDS.confirmation);
    let mut flipped = || terms.iter().map(|t| if random.random_bool(0.5) { -t } else { *t }).sum::<f64>();
    let as_far = (0..SIGN_DRAWS).filter(|_| flipped().abs() >= reached).count();
    // the order that was recorded is one of the ways
    (as_far + 1) as f64 / (SIGN_DRAWS + 1) as f64
}

#[cfg(test)]
#[allow(clippy::single_range_in_vec_init)] // one run
mod tests {
    use super::*;
    use rand_distr::{Distribution, StandardNormal};

    fn noise(seed: u64, rows: usize) -> Vec<f64> {
        let mut random = ChaCha8Rng::seed_from_u64(seed);
        (0..rows).map(|_| StandardNormal.sample(&mut random)).collect()
    }

    /// A course, once with and once without what is planted, read with noise of unit variance.
    fn planted(size: f64) -> (Vec<f64>, Vec<f64>, Vec<f64>) {
        let without: Vec<f64> = (0..600).map(|row| 0.1 * f64::from(row)).collect();
        let with: Vec<f64> = without.iter().enumerate().map(|(row, v)| v + size * (row as f64 / 20.0).sin()).collect();
        let read = with.iter().zip(noise(7, 600)).map(|(v, n)| v + n).collect();
        (without, with, read)
    }

    #[test]
    fn what_is_planted_is_confirmed_and_the_other_way_round_refuted() {
        let (without, with, read) = planted(1.0);
        let whole = &[0..600];
        let found = compared(&without, &with, &read, whole);
        assert_eq!((found.judgement, found.blocks), (Judgement::Confirmed, 12));
        // E[(y - b)^2 - (y - a)^2] = mean of the planted course squared = 1/2; its sd over 600 rows is 2 sqrt(0.5 / 600) = 0.058
        assert!((found.difference - 0.5).abs() < 4.0 * 0.058, "{}", found.difference);
        let swapped = compared(&with, &without, &read, whole);
        assert_eq!((swapped.judgement, swapped.p_value), (Judgement::Refuted, found.p_value));
        assert_eq!(swapped.difference, -found.difference);
    }

    #[test]
    fn models_that_are_equal_or_equally_wrong_cannot_be_told_apart() {
        let (without, with, read) = planted(1.0);
        let same = compared(&with, &with, &read, &[0..300, 300..600]);
        assert_eq!((same.judgement, same.p_value, same.better_in), (Judgement::CannotTell, 1.0, 0));
        let level = 0.05 * 200.0;
        let mut wrong = 0;
        for seed in 0..200 {
            // two models that are wrong by courses of the same law, so that neither is better: at most the stated share may be told apart
            let (a, b) = (noise(1000 + seed, 600), noise(5000 + seed, 600));
            let off = |by: &[f64]| without.iter().zip(by).map(|(v, n)| v + n).collect::<Vec<f64>>();
            wrong += usize::from(compared(&off(&a), &off(&b), &without, &[0..600]).judgement != Judgement::CannotTell);
        }
        // binomial: mean 10, sd 3.1
        assert!((1..=20).contains(&wrong), "{wrong} of 200, {level} expected");
    }

    #[test]
    fn p_values_are_those_that_are_counted_by_hand() {
        // of 8 ways, +++ and --- reach 3; ++- and the like give 1
        assert_eq!(by_signs(&[1.0, 1.0, 1.0]), 0.25);
        // 4 - 1 = 3 is reached by 4 of 4 ways but those with |sum| < 3: none
        assert_eq!(by_signs(&[4.0, -1.0]), 1.0);
        assert_eq!(by_signs(&[4.0, 1.0]), 0.5);
        // drawn: of 20 equal terms 2 of 2^20 ways are as far, so none of the draws
        assert_eq!(by_signs(&[1.0; 20]), 1e-4);
    }

    #[test]
    fn few_runs_are_cut_and_many_are_left_whole() {
        assert_eq!(blocks(&[0..24, 24..30]).len(), 7); // 6 parts of 4 rows, and one of 6 rows
        let many: Vec<Range<usize>> = (0..20).map(|k| 10 * k..10 * (k + 1)).collect();
        assert_eq!(blocks(&many), many);
        let cut = blocks(&[5..105]);
        assert_eq!((cut.len(), cut[0].start, cut[11].end), (12, 5, 105));
        assert!(cut.windows(2).all(|w| w[0].end == w[1].start));
    }

    fn free(gain: bool, offset: bool) -> Free {
        Free { gain, offset }
    }

    #[test]
    fn gain_and_offset_are_exact_where_the_reading_is_a_line() {
        let prediction: Vec<f64> = (0..50).map(|row| (f64::from(row) * 0.3).sin()).collect();
        let read: Vec<f64> = prediction.iter().map(|p| 1.25 * p - 3.0).collect();
        let both = Reading::fitted(&prediction, &read, free(true, true));
        assert!((both.gain - 1.25).abs() < 1e-12 && (both.offset + 3.0).abs() < 1e-12, "{both:?}");
        assert_eq!(Reading::fitted(&prediction, &read, free(false, false)), Reading { gain: 1.0, offset: 0.0 });
        let through_zero: Vec<f64> = prediction.iter().map(|p| 0.8 * p).collect();
        assert!((Reading::fitted(&prediction, &through_zero, free(true, false)).gain - 0.8).abs() < 1e-12);
        let level = Reading::fitted(&[2.0; 50], &read, free(true, true));
        assert_eq!(level.gain, 1.0);
        assert!((level.of(&[2.0])[0] - read.iter().sum::<f64>() / 50.0).abs() < 1e-12);
    }
}
