//! A noise that was taken too loud, lowered to what some model leaves over.
//!
//! Limits: lowers, never raises.

use crate::{
    data::{context::load_column, problem::Problem},
    noise::tuning::{CLEARLY_TOO_LOUD, LEAST_OF_INPUTS, LOWER_NOISE, TOO_LOUD},
    noise::{
        reml::estimate,
        response::{blocks, from_misfit, no_finer_than_read},
    },
    whitening::{noise_model::NoiseModel, whitener::Whitener},
};

/// The noise estimated again where `misfit`, what some model leaves over, is quieter than `noise`: what was taken for noise was something that the model knows.
/// `None` where it is not.
///
/// A model with a handful of numbers can take physics out of thousands of rows, but not their noise.
pub fn quieter_than(problem: &Problem<'_>, misfit: &[f64], noise: &NoiseModel) -> Option<NoiseModel> {
    (share_left(problem, misfit, noise) < too_loud(noise)).then(|| {
        let again = if noise.lasts() {
            noise.clone()
        } else if noise.measured {
            let load = load_column(problem.inputs, problem.simulator);
            let (blocks, _, says) = blocks(problem, load.as_deref(), &noise.inputs, noise.load_wanders());
            let (response, uncertainty) = estimate(&noise.with_rows_alike(misfit), &blocks);
            let says = format!("{says}, beside what a model explains");
            NoiseModel { response: no_finer_than_read(response, problem), uncertainty, says, ..noise.clone() }
        } else {
            from_misfit(problem, misfit, noise)
        };
        not_above(problem, misfit, again)
    })
}

/// The filter of a noise, and the misfit behind it.
fn whitened(problem: &Problem<'_>, misfit: &[f64], noise: &NoiseModel) -> (Whitener, Vec<f64>) {
    let whitener = noise.whitener(&problem.runs(), None);
    let mut column = misfit.to_vec();
    whitener.apply(&mut column);
    (whitener, column)
}

/// Mean square of the whitened misfit: 1 where the noise is as loud as taken, and nothing else is left.
fn share_left(problem: &Problem<'_>, misfit: &[f64], noise: &NoiseModel) -> f64 {
    let (_, column) = whitened(problem, misfit, noise);
    column.iter().map(|v| v * v).sum::<f64>() / misfit.len() as f64
}

/// The noise, lowered where `misfit` shows that it is too loud: of response and inputs by the factors under which the misfit is likeliest.
pub fn not_above(problem: &Problem<'_>, misfit: &[f64], noise: NoiseModel) -> NoiseModel {
    if share_left(problem, misfit, &noise) >= TOO_LOUD {
        return noise;
    }
    let deviance = |noise: &NoiseModel| {
        let (whitener, column) = whitened(problem, misfit, noise);
        whitener.deviance(&column)
    };
    let likeliest = |factors: Vec<(f64, f64)>| {
        let tried = factors.into_iter().map(|(response, inputs)| noise.with_parts_scaled(response, inputs));
        tried.map(|noise| (deviance(&noise), noise)).min_by(|a, b| a.0.total_cmp(&b.0))
    };
    let alike = likeliest(LOWER_NOISE.map(|factor| (factor, factor)).to_vec());
    // what denoised inputs err by is alike over many rows, and short stretches say nothing of it: only a load that keeps its noise is weighed by itself
    let inputs = LOWER_NOISE.into_iter().filter(|inputs| noise.load_wanders() && *inputs >= LEAST_OF_INPUTS);
    let apart = likeliest(inputs.flat_map(|inputs| LOWER_NOISE.map(|response| (response, inputs))).collect());
    let clearly = |apart: &(f64, NoiseModel)| alike.as_ref().is_none_or(|alike| apart.0 < alike.0 - CLEARLY_TOO_LOUD);
    apart.filter(clearly).or(alike).map_or_else(|| noise.clone(), |(_, likeliest)| likeliest)
}

/// The same for a noise to be estimated once more: one that was not measured at rest is not known that well.
pub fn too_loud(noise: &NoiseModel) -> f64 {
    if noise.measured { TOO_LOUD } else { 0.5 }
}
