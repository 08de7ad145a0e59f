//! A noise that was read from a misfit, read once more from what a better model leaves.
//!
//! Where nothing rests, the noise of a recording is what the calibrated base model leaves within short stretches. A lag or a late clock that is missing there makes it loud, steep and louder where the reading is
//! quick, and all of that goes with the misfit once a model explains it. A filter for a steep noise makes white noise look like noise of the right size, so that mean squares do not tell: likelihoods do.
//!
//! Limits: what may be lowered is proposed here; whether it is likelier is asked of a model ([`crate::fit::under_noise`]).

use crate::{
    data::problem::Problem,
    noise::{
        response::{follows_nothing, from_misfit},
        several::with_louder_rows_beside,
        tuning::{LESS_SLOW, STILL_AS_LOUD},
    },
    whitening::{
        noise_model::{NoiseModel, tells},
        whitener::{InputError, Lasting},
    },
};

/// The noises that `misfit`, what a model leaves, may have in place of `noise`, each clearly quieter: read from it as one that was never measured is. None where the noise was measured, or where the steps of the reading last.
pub(crate) fn learned_again(problem: &Problem<'_>, misfit: &[f64], noise: &NoiseModel) -> Vec<NoiseModel> {
    if noise.measured || noise.step > 0.0 {
        return Vec::new();
    }
    let alike = of_rows_alike(noise);
    let learned = |misfit: &[f64]| with_louder_rows_beside(problem, misfit, from_misfit(problem, misfit, &alike));
    // what follows the drivers is no noise where a model lacks it, and some of its freedom where none does
    let both = [learned(misfit), learned(&follows_nothing(problem.inputs, misfit.to_vec()))];
    let says = |noise: NoiseModel| NoiseModel { says: format!("{}, beside what a model explains", noise.says), ..noise };
    both.into_iter().map(says).filter(|new| new.floor() < STILL_AS_LOUD * noise.floor()).collect()
}

/// The same noise with less of what lasts in it, down to none.
pub(crate) fn less_slow(noise: &NoiseModel) -> Vec<NoiseModel> {
    let with = |factor: f64| {
        let less = |lasting: &Lasting| {
            let factor = if lasting.of_reading { factor * factor } else { 1.0 };
            Lasting { variance: lasting.variance.iter().map(|v| v * factor).collect(), ..lasting.clone() }
        };
        let lasting = noise.input_error.lasting.iter().map(less).collect();
        NoiseModel { input_error: InputError { lasting, ..noise.input_error.clone() }, ..noise.clone() }
    };
    LESS_SLOW.map(with).into_iter().filter(|new| new.floor() < STILL_AS_LOUD * noise.floor()).collect()
}

/// The noise without what makes rows louder beside a misfit, and without what was slow there; rows that tell nothing stay as they are.
pub(crate) fn of_rows_alike(noise: &NoiseModel) -> NoiseModel {
    let kept = |(row, variance): (usize, &f64)| if tells(&noise.untold, row) { 0.0 } else { *variance };
    let louder = noise.input_error.louder.iter().enumerate().map(kept).collect();
    let lasting = noise.input_error.lasting.iter().filter(|lasting| !lasting.of_reading).cloned().collect();
    NoiseModel { input_error: InputError { louder, lasting, ..noise.input_error.clone() }, ..noise.clone() }
}
