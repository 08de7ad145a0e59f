//! Inputs without their noise, and the noise itself: of one recording, or of each of several by itself.
//!
//! Limits: as [`crate::noise`]; recordings share no noise.

use crate::{
    fit::{FitOptions, Model, fit},
    issues::DiagnoseError,
    noise::{input_noise, noise_model, quiet_inputs},
    problem::{NoiseModel, Problem, RecordingNoise},
};
use std::ops::Range;
use truegap_core::{Inputs, Joined};

/// The inputs made quiet, and the noise of every row.
///
/// # Errors
/// [`DiagnoseError`] where the base model has no answer.
pub fn measured(problem: &Problem<'_>) -> Result<(Inputs, NoiseModel), DiagnoseError> {
    match problem.simulator.joined() {
        None => of_one(problem),
        Some(joined) => of_several(problem, joined),
    }
}

fn of_one(problem: &Problem<'_>) -> Result<(Inputs, NoiseModel), DiagnoseError> {
    let input_noise = input_noise(problem.inputs, problem.simulator);
    let (quiet, load_left, temperature_left) = quiet_inputs(problem.inputs, problem.simulator, &input_noise);
    let still = Problem { inputs: &quiet, response: problem.response, simulator: problem.simulator };
    let noise = noise_model(&still, &centre(&still), input_noise, (&load_left, &temperature_left))?;
    let noise = no_more_than_misfit(&still, noise)?;
    Ok((quiet, noise))
}

fn of_several(problem: &Problem<'_>, joined: &dyn Joined) -> Result<(Inputs, NoiseModel), DiagnoseError> {
    let mut quiet = problem.inputs.clone();
    let mut all: Option<NoiseModel> = None;
    for index in 0..joined.count() {
        let rows = joined.rows(index, problem.inputs);
        if rows.is_empty() {
            continue;
        }
        let inputs = joined.inputs(index, problem.inputs);
        let response = &problem.response[rows.clone()];
        let (own, noise) = of_one(&Problem { inputs: &inputs, response, simulator: joined.model(index) })?;
        put(&mut quiet, &rows, &own);
        let first = all.is_none();
        let joint = all.get_or_insert_with(|| NoiseModel { rows: 0, says: String::new(), ..noise.clone() });
        if !first {
            joint.extra_variance.extend(&noise.extra_variance);
            joint.measured &= noise.measured;
            joint.says += "; ";
        }
        joint.rows += noise.rows;
        joint.says += &format!("recording {}: {}", index + 1, noise.says);
        joint.recordings.push(RecordingNoise { rows, response: noise.response, inputs: noise.inputs, says: noise.says });
    }
    all.map(|noise| (quiet, noise)).ok_or(DiagnoseError::TooFewRows { rows: 0, needed: crate::issues::FEWEST_ROWS })
}

/// Writes the columns of one recording back to its rows.
fn put(all: &mut Inputs, rows: &Range<usize>, own: &Inputs) {
    let columns = [
        (&mut all.force_n, &own.force_n),
        (&mut all.pressure_pa, &own.pressure_pa),
        (&mut all.temperature_c, &own.temperature_c),
    ];
    for (to, from) in columns {
        if let (Some(to), Some(from)) = (to, from) {
            to[rows.clone()].copy_from_slice(from);
        }
    }
}

/// Where noise could not be measured at rest, it is no more than what the calibrated base model leaves over: steps of a profile inside the short
/// stretches would otherwise pass for noise, and everything would seem to agree.
fn no_more_than_misfit(problem: &Problem<'_>, noise: NoiseModel) -> Result<NoiseModel, DiagnoseError> {
    if noise.measured {
        return Ok(noise);
    }
    let context = problem.context(problem.span(), noise.floor());
    let model = Model::new(problem, &context, Vec::new());
    let mut bounded = noise;
    for _ in 0..3 {
        let whitener = bounded.whitener(&problem.runs(), None);
        let base = fit(&model, &whitener, &vec![0.0; model.parameters.len()], &FitOptions::default())?;
        let ratio = base.chi2 / problem.response.len() as f64;
        if ratio > 0.7 {
            break;
        }
        bounded = bounded.scaled(ratio.sqrt());
        bounded.says = format!(
            "{}; no more than what the calibrated model leaves over",
            bounded.says.split("; no more").next().unwrap_or_default()
        );
    }
    Ok(bounded)
}

/// The centre of the base model's prior.
fn centre(problem: &Problem<'_>) -> Vec<f64> {
    problem.simulator.parameters().iter().map(truegap_core::Parameter::centre).collect()
}
