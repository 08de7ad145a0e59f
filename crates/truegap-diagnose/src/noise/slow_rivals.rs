//! Rivals of the noise that was measured: slow noise, and noise with another memory. Stretches at rest are often too short to tell, and the whole recording decides.
//!
//! Limits: one recording with a clock; which of them the recording has is not weighed here (`crate::pipeline`).

use crate::{
    data::{context::load_column, problem::Problem},
    noise::{
        reml::{Block, estimate},
        response::{blocks, no_finer_than_read},
        slow::{Slow, allowed, allowed_memories, beside},
        tones::without_tones,
    },
    whitening::{noise_model::NoiseModel, whitener::Noise},
};

/// The noise with each slow noise that rest allows in place of its one memory; `misfit`, what some model leaves, stands for a rest that was not recorded. Empty
/// where the noise lasts already.
pub fn slow_rivals(problem: &Problem<'_>, misfit: &[f64], noise: &NoiseModel) -> Vec<NoiseModel> {
    let Some((blocks, left)) = readings(problem, misfit, noise) else { return Vec::new() };
    allowed(&left, &blocks, &noise.response).into_iter().map(|slow| of_slow(problem, noise, slow)).collect()
}

/// The noise with each other memory that rest allows; `misfit` as for slow noise. Empty where the noise lasts already, or was not measured: a misfit that stands for rest has any memory itself.
pub fn memory_rivals(problem: &Problem<'_>, misfit: &[f64], noise: &NoiseModel) -> Vec<NoiseModel> {
    let Some((blocks, left)) = noise.measured.then(|| readings(problem, misfit, noise)).flatten() else { return Vec::new() };
    allowed_memories(&left, &blocks, &noise.response).into_iter().map(|other| of_response(problem, noise, other)).collect()
}

/// Where rest is like slow noise: the noise with each memory in its place that rest allows. Empty where the noise was not measured, does not last, or lasts as the steps of a converter do.
pub fn lasting_rivals(problem: &Problem<'_>, noise: &NoiseModel) -> Vec<NoiseModel> {
    if !noise.measured || !noise.lasts() || noise.step > 0.0 || !problem.is_one_with_a_clock() {
        return Vec::new();
    }
    let (blocks, _, says) = stretches(problem, noise);
    let mut of_one_memory = NoiseModel { says, ..noise.clone() };
    of_one_memory.input_error.lasting.retain(|lasting| !lasting.of_reading);
    let (chosen, _) = estimate(problem.response, &blocks);
    let rivals = allowed_memories(problem.response, &blocks, &chosen).into_iter();
    rivals.map(|other| of_response(problem, &of_one_memory, other)).collect()
}

/// The stretches that tell a noise which does not last, and what is read there; `None` where it has no rivals.
fn readings(problem: &Problem<'_>, misfit: &[f64], noise: &NoiseModel) -> Option<(Vec<Block>, Vec<f64>)> {
    if noise.lasts() || !problem.is_one_with_a_clock() {
        return None;
    }
    let (blocks, at_rest, _) = stretches(problem, noise);
    let left = if at_rest { problem.response.to_vec() } else { without_tones(problem.inputs, misfit.to_vec()) };
    Some((blocks, left))
}

/// The stretches that tell a noise, as [`blocks`] has them.
fn stretches(problem: &Problem<'_>, noise: &NoiseModel) -> (Vec<Block>, bool, String) {
    let load = load_column(problem.inputs, problem.simulator);
    blocks(problem, load.as_deref(), &noise.inputs, noise.load_wanders())
}

/// The noise with this slow noise in place of its one memory.
fn of_slow(problem: &Problem<'_>, noise: &NoiseModel, slow: Slow) -> NoiseModel {
    let mut input_error = noise.input_error.clone();
    beside(&mut input_error, problem.response.len(), slow);
    let response = no_finer_than_read(Noise { white_sd: slow.white_sd, ar_sd: 0.0, ar_correlation: 0.0 }, problem);
    let says = format!("{}; slow like 1/f, as the whole recording has it", noise.says);
    NoiseModel { response, input_error, says, ..noise.clone() }
}

/// The noise with another one of the response.
fn of_response(problem: &Problem<'_>, noise: &NoiseModel, response: Noise) -> NoiseModel {
    let says = format!("{}; its memory from the whole recording", noise.says);
    NoiseModel { response: no_finer_than_read(response, problem), says, ..noise.clone() }
}
