//! Slow noise as a rival of the noise that was measured: stretches at rest are often too short to tell, and the whole recording decides.
//!
//! Limits: one recording with a clock; what rest does allow is not weighed here (`crate::pipeline`).

use crate::{
    data::{context::load_column, problem::Problem},
    noise::{
        response::{blocks, no_finer_than_read},
        slow::{Slow, allowed, beside},
        tones::without_tones,
    },
    whitening::{noise_model::NoiseModel, whitener::Noise},
};

/// The noise with each slow noise that rest allows in place of its one memory; `misfit`, what some model leaves, stands for a rest that was not recorded. Empty
/// where the noise lasts already.
pub fn slow_rivals(problem: &Problem<'_>, misfit: &[f64], noise: &NoiseModel) -> Vec<NoiseModel> {
    if noise.lasts() || problem.inputs.time_s.is_none() || problem.simulator.joined().is_some() {
        return Vec::new();
    }
    let load = load_column(problem.inputs, problem.simulator);
    let (blocks, at_rest, _) = blocks(problem, load.as_deref(), &noise.inputs, noise.load_wanders());
    let left = if at_rest { problem.response.to_vec() } else { without_tones(problem.inputs, misfit.to_vec()) };
    allowed(&left, &blocks, &noise.response).into_iter().map(|slow| with(problem, noise, slow)).collect()
}

/// The noise with this slow noise in place of its one memory.
fn with(problem: &Problem<'_>, noise: &NoiseModel, slow: Slow) -> NoiseModel {
    let mut input_error = noise.input_error.clone();
    beside(&mut input_error, problem.response.len(), slow);
    let response = no_finer_than_read(Noise { white_sd: slow.white_sd, ar_sd: 0.0, ar_correlation: 0.0 }, problem);
    let says = format!("{}; slow like 1/f, as the whole recording has it", noise.says);
    NoiseModel { response, input_error, says, ..noise.clone() }
}
