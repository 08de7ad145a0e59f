//! The passes: what was added is taken from the reading at the input that the last pass has estimated.
//!
//! Limits: what a sensor has lost, as a lag loses quick changes, comes back only as far as the noise allows.

use super::{inverse::Inverse, models::Models};
use crate::stats::rms;
use truegap_core::ends;

/// What is left may stand above what the noise alone would leave by this factor: a bias of a third of the noise.
const ABOVE_NOISE: f64 = 1.05;
/// Part of the range of the readings at which nothing is left.
const NOTHING: f64 = 1e-9;
/// What is left must fall by this part with a pass; below it no longer falls.
const FALLS: f64 = 1e-3;
/// Shortest part of a step that is tried where a whole one makes what is left larger.
const SHORTEST: f64 = 0.125;
/// Noise that is drawn where the noise is not known, over the range of the readings: small enough for a straight line.
const TRIAL: f64 = 1e-6;

/// Where the passes end.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Limits {
    /// noise of a reading, in its unit; 0 where it is not known
    pub noise_sd: f64,
    /// most passes
    pub passes: usize,
    /// most that the noise may grow
    pub noise_growth: f64,
}

impl Limits {
    /// Those of this program, at a noise.
    pub fn of(noise_sd: f64) -> Self {
        Self { noise_sd, passes: 200, noise_growth: 10.0 }
    }
}

/// Why the passes ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Stopped {
    /// what is left is what the noise alone would leave, or nothing
    AtNoise,
    /// a further pass would bring more noise than it takes error away
    Balanced,
    /// what is left no longer falls
    NoLongerFalls,
    /// a further pass would make the noise grow beyond its limit
    NoiseGrows,
    /// the last pass that is allowed
    LastPass,
}

/// Corrected readings.
#[derive(Clone, Debug, PartialEq)]
pub struct Compensated {
    /// readings without the added physics
    pub corrected: Vec<f64>,
    /// input of the base model that gives them
    pub input: Vec<f64>,
    /// passes that were made
    pub passes: usize,
    /// root mean square of the reading less what the augmented model gives at that input
    pub left: f64,
    /// noise of a corrected reading over that of a reading, where it is white
    pub noise_growth: f64,
    /// why there was no further pass
    pub stopped: Stopped,
    /// rows that no input of the base model gives: what was added is taken at the nearest
    pub outside: usize,
}

/// A step of one column of readings.
struct Step {
    input: Vec<f64>,
    outside: usize,
    /// what is to be added to the corrected readings
    change: Vec<f64>,
}

/// The readings without the added physics.
///
/// With y the readings, A and B the two models and c_k the corrected readings of pass k:
///
/// $$ c_0 = y, \quad c_{k+1} = y - \left( A(x_k) - B(x_k) \right), \quad B(x_k) = c_k $$
///
/// A step that leaves more than the one before is halved. Passes end at the latest by the discrepancy principle: where what is left, y - A(x_k), is as large as
/// what the noise alone would leave. They end before that where the next one would bring more noise, squared, than there is error left above the noise. What the
/// noise leaves, and how much it has grown, is found by a second column beside the first, the readings with noise added: the difference of the two columns is
/// noise alone.
///
/// **Source:** van Cittert, Z. Phys. 69 (1931) 298; Jansson, Deconvolution of Images and Spectra, 2nd ed., ch. 3; Morozov, Methods for Solving Incorrectly Posed
/// Problems (1984).
///
/// # Errors
/// Those of the models.
pub fn compensated<E>(readings: &[f64], models: &Models<'_, E>, inverse: &Inverse, limits: &Limits) -> Result<Compensated, E> {
    let (low, high) = ends(readings.iter().copied());
    let range = (high - low).max(f64::MIN_POSITIVE);
    let sd = if limits.noise_sd > 0.0 { limits.noise_sd } else { TRIAL * range };
    let noisy: Vec<f64> = readings.iter().enumerate().map(|(row, reading)| reading + sd * sign(row)).collect();
    let step = |readings: &[f64], corrected: &[f64]| step(readings, corrected, models, inverse);
    let left = |at: &Step| rms(at.change.iter().copied());

    let mut columns = [readings.to_vec(), noisy.clone()];
    let mut steps = [step(readings, &columns[0])?, step(&noisy, &columns[1])?];
    let (mut share, mut passes) = (1.0, 0);
    let stopped = loop {
        let noise = rms(difference(&steps[1].change, &steps[0].change));
        let least = if limits.noise_sd > 0.0 { ABOVE_NOISE * noise } else { 0.0 };
        if left(&steps[0]) <= least.max(NOTHING * range) {
            break Stopped::AtNoise;
        }
        if passes == limits.passes {
            break Stopped::LastPass;
        }
        let further = [0, 1].map(|k| moved(&columns[k], &steps[k].change, share));
        let [now, then] = [&columns, &further].map(|columns| rms(difference(&columns[1], &columns[0])));
        // what stands above the noise is error; a pass takes no more than that away
        if limits.noise_sd > 0.0 && left(&steps[0]).powi(2) - noise.powi(2) < then.powi(2) - now.powi(2) {
            break Stopped::Balanced;
        }
        if then > limits.noise_growth * sd {
            break Stopped::NoiseGrows;
        }
        let next = [step(readings, &further[0])?, step(&noisy, &further[1])?];
        let (before, after) = (left(&steps[0]), left(&next[0]));
        if after > before && share > SHORTEST {
            share *= 0.5;
            continue;
        }
        if after > (1.0 - FALLS * share) * before || after.is_nan() {
            break Stopped::NoLongerFalls;
        }
        (columns, steps, passes) = (further, next, passes + 1);
    };
    let noise_growth = rms(difference(&columns[1], &columns[0])) / sd;
    let left = left(&steps[0]);
    let ([corrected, _], [Step { input, outside, .. }, _]) = (columns, steps);
    Ok(Compensated { corrected, input, passes, left, noise_growth, stopped, outside })
}

fn step<E>(readings: &[f64], corrected: &[f64], models: &Models<'_, E>, inverse: &Inverse) -> Result<Step, E> {
    let (input, outside) = inverse.input(models.base, corrected)?;
    let (base, augmented) = ((models.base)(&input)?, (models.augmented)(&input)?);
    let change = |row: usize| readings[row] - (augmented[row] - base[row]) - corrected[row];
    Ok(Step { change: (0..readings.len()).map(change).collect(), input, outside })
}

fn moved(column: &[f64], change: &[f64], share: f64) -> Vec<f64> {
    column.iter().zip(change).map(|(value, change)| value + share * change).collect()
}

fn difference<'a>(a: &'a [f64], b: &'a [f64]) -> impl Iterator<Item = f64> + Clone + 'a {
    a.iter().zip(b).map(|(a, b)| a - b)
}

/// 1 or -1 by the number of a row, without an order: white noise of unit variance that needs no seed.
///
/// **Source:** the mixer of Steele, Lea & Flood, Fast splittable pseudorandom number generators, OOPSLA (2014) 453.
fn sign(row: usize) -> f64 {
    let mut bits = (row as u64 + 1).wrapping_mul(0x9e37_79b9_7f4a_7c15);
    bits = (bits ^ (bits >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    bits = (bits ^ (bits >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    if (bits ^ (bits >> 31)) & 1 == 0 { 1.0 } else { -1.0 }
}
