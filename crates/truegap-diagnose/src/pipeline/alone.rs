//! The base model as well as it can be calibrated by itself, where something is missing from it.
//!
//! A fit under the noise follows what the noise lets it see: where noise is correlated over many rows these are the changes from row to row, and the level of a model that lacks
//! something may end far from the recording. What is added must not be praised for mending that. So the base model alone is calibrated by least squares, under white noise
//! as large as what it leaves over; what is known of its numbers counts as before.
//!
//! Limits: one size of the misfit for the whole recording; what the search compares is the fit under the noise.

use crate::{
    fit::{model::Model, optimum::Fit, tuning::LOOSE},
    noise::scout::{from_start, scouted},
    pipeline::prepare::Prepared,
    selection::candidates::{Search, Tried},
    stats::rms,
    validation::all_rows::AllRows,
    whitening::{
        noise_model::{NoiseModel, RecordingNoise},
        whitener::{InputError, Noise},
    },
};

/// Share by which the error must fall for another calibration to be told.
const LOWER: f64 = 1e-3;

/// Times that the size of the misfit is taken anew.
const ROUNDS: usize = 4;

/// The base model calibrated by least squares, and the noise under which that is so.
#[derive(Clone)]
pub(crate) struct Alone {
    /// no effects, its fit
    pub tried: Tried,
    /// white noise as large as what it leaves over
    pub noise: NoiseModel,
}

/// The base model calibrated by itself; `None` where `base`, its fit under the noise, is as near to the recording.
pub(crate) fn alone(prepared: &Prepared<'_>, search: &Search<'_>, all: AllRows<'_>, base: &Tried) -> Option<Alone> {
    let model = search.model(&[]);
    let runs = search.problem.runs();
    let every = Model::new(all.problem, search.context, Vec::new());
    let error = |z: &[f64]| left_over(&every, z);
    let before = error(&base.fit.z)?;
    let mut best: Option<(f64, Alone)> = None;
    let mut size = before;
    for _ in 0..ROUNDS {
        let noise = white(&prepared.searched_noise, size);
        let whitener = noise.whitener(&runs, None);
        let fit = match &best {
            // another size of the same noise: the optimum hardly moves
            Some((_, last)) => from_start(&model, &whitener, &last.tried.fit.z),
            None => {
                let loose = noise.scaled(LOOSE).whitener(&runs, None);
                scouted(&model, &whitener, &loose, prepared.scout.as_ref(), |noise| white(noise, size))
            }
        };
        let fit = fit.ok()?;
        let found = error(&fit.z)?;
        let converged = (found - size).abs() <= LOWER * size;
        if best.as_ref().is_none_or(|(least, _)| found < *least) {
            best = Some((found, Alone { tried: Tried { effects: Vec::new(), fit }, noise }));
        }
        if converged || found == 0.0 {
            break;
        }
        size = found;
    }
    best.filter(|(found, _)| *found < (1.0 - LOWER) * before).map(|(_, alone)| alone)
}

/// A fuller model calibrated by least squares, for one that predicts rows left out better so. Its errors hold the difference between both calibrations: a number that depends on how rows are
/// weighed is not known better than that. Beside it the errors that least squares alone would tell. `None` where it has no such fit, or one that is no nearer to the recording.
pub(crate) fn by_squares(
    prepared: &Prepared<'_>,
    search: &Search<'_>,
    all: AllRows<'_>,
    tried: &Tried,
) -> Option<(Tried, Vec<f64>)> {
    let model = search.model(&tried.effects);
    let every = Model::new(all.problem, search.context, model.effects.clone());
    let before = left_over(&every, &tried.fit.z)?;
    let runs = search.problem.runs();
    let (mut size, mut z, mut own) = (before, tried.fit.z.clone(), Vec::new());
    for _ in 0..ROUNDS {
        let fit = from_start(&model, &white(&prepared.searched_noise, size).whitener(&runs, None), &z).ok()?;
        let found = left_over(&every, &fit.z)?;
        (z, own) = (fit.z, fit.sd);
        if (found - size).abs() <= LOWER * size || found == 0.0 {
            break;
        }
        size = found;
    }
    let nearer = left_over(&every, &z)? < before;
    let sd = tried.fit.sd.iter().zip(z.iter().zip(&tried.fit.z)).map(|(sd, (a, b))| sd.hypot(a - b)).collect();
    nearer.then(|| (Tried { effects: tried.effects.clone(), fit: Fit { z, sd, ..tried.fit.clone() } }, own))
}

/// Root mean square of what a model leaves over.
pub(crate) fn left_over(model: &Model<'_>, z: &[f64]) -> Option<f64> {
    Some(rms(model.misfit(z).ok()?.iter().copied()))
}

/// White noise of this size in place of what the reading and its inputs have; rows that are louder stay so.
pub(crate) fn white(noise: &NoiseModel, size: f64) -> NoiseModel {
    let response = Noise { white_sd: size, ar_sd: 0.0, ar_correlation: 0.0 };
    let recordings = noise.recordings.iter().map(|r| RecordingNoise { response, ..r.clone() }).collect();
    let input_error =
        InputError { louder: noise.input_error.louder.clone(), ..InputError::white(vec![0.0; noise.input_error.variance.len()]) };
    NoiseModel { response, recordings, input_error, ..noise.clone() }
}
