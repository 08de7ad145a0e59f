//! The noise of the other rows, where some are louder.
//!
//! Limits: which rows are louder is given ([`crate::noise::louder`]).

use crate::{
    data::{context::load_column, problem::Problem},
    noise::{
        louder::Louder,
        reml::estimate,
        rescale::not_above,
        response::{blocks, follows_nothing, no_finer_than_read},
        tuning::UNSEEN,
    },
    whitening::noise_model::NoiseModel,
};

/// The noise beside rows that are louder: estimated again from the others.
pub fn beside_louder_rows(problem: &Problem<'_>, noise: &NoiseModel, found: Louder) -> NoiseModel {
    let load = load_column(problem.inputs, problem.simulator);
    let (blocks, ..) = blocks(problem, load.as_deref(), &noise.inputs, noise.load_wanders());
    let clean = if noise.measured {
        found.clean
    } else {
        // as it was estimated before, from what follows nothing
        follows_nothing(problem.inputs, found.clean)
    };
    let (response, uncertainty) = estimate(&clean, &blocks);
    let mut input_error = noise.input_error.clone();
    input_error.louder.resize(found.variance.len(), 0.0);
    input_error.louder.iter_mut().zip(&found.variance).for_each(|(known, new)| *known = known.max(*new));
    let louder = NoiseModel {
        response: no_finer_than_read(response, problem),
        uncertainty: if noise.measured { uncertainty } else { uncertainty.max(UNSEEN) },
        says: format!("{}; {}", noise.says, found.says),
        input_error,
        ..noise.clone()
    };
    // where noise is taken from what a model leaves over, wild rows were taken for noise as well
    if noise.measured { louder } else { not_above(problem, &clean, louder) }
}

/// The same where the noise of the others is no louder than it was taken: without the rows that are louder a noise is no louder, and what a model leaves of the others may be its form. A noise that lasts stays as it is.
pub fn not_louder_beside(problem: &Problem<'_>, noise: &NoiseModel, found: Louder) -> NoiseModel {
    let size = |noise: &NoiseModel| noise.response.white_sd.hypot(noise.response.ar_sd);
    let quieter = beside_louder_rows(problem, noise, found);
    if size(&quieter) <= size(noise) && !noise.lasts() {
        quieter
    } else {
        NoiseModel { response: noise.response, uncertainty: noise.uncertainty, ..quieter }
    }
}
