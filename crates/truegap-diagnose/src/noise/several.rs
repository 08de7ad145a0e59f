//! Inputs without their noise, and the noise itself: of one recording, or of each of several by itself.
//!
//! Limits: as [`crate::noise::response`]; recordings share no noise.

use crate::{
    data::{error::DiagnoseError, problem::Problem},
    fit::{
        model::Model,
        several_starts::{LOOSE, lowest},
    },
    noise::{
        follows_drivers::without_what_follows_drivers,
        quiet::{Quiet, quiet},
        rescale::not_above,
        response::{from_misfit, noise_model},
        switching::load_switches,
    },
    whitening::noise_model::{NoiseModel, RecordingNoise},
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
    let Quiet { inputs, noise, load_left, temperature_left, load_shapes } =
        quiet(problem.inputs, problem.simulator, load_switches(problem));
    let still = Problem { inputs: &inputs, response: problem.response, simulator: problem.simulator };
    let noise = noise_model(&still, &still.simulator.centre(), noise, (&load_left, &temperature_left), &load_shapes)?;
    let noise = without_rest(&still, noise)?;
    Ok((inputs, noise))
}

fn of_several(problem: &Problem<'_>, joined: &dyn Joined) -> Result<(Inputs, NoiseModel), DiagnoseError> {
    let mut quiet = problem.inputs.clone();
    let mut all: Option<NoiseModel> = None;
    let mut shapes: Vec<Vec<f64>> = Vec::new();
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
            joint.input_error.variance.extend(&noise.input_error.variance);
            joint.input_error.level.extend(&noise.input_error.level);
            joint.uncertainty = joint.uncertainty.max(noise.uncertainty);
            joint.measured &= noise.measured;
            joint.says += "; ";
        }
        shapes.extend(noise.input_error.shapes.iter().map(|own| {
            let mut whole = vec![0.0; problem.response.len()];
            whole[rows.clone()].copy_from_slice(own);
            whole
        }));
        joint.rows += noise.rows;
        joint.says += &format!("recording {}: {}", index + 1, noise.says);
        joint.recordings.push(RecordingNoise { rows, response: noise.response, inputs: noise.inputs, says: noise.says });
    }
    if let Some(noise) = &mut all {
        noise.input_error.shapes = shapes;
    }
    all.map(|noise| (quiet, noise)).ok_or(DiagnoseError::TooFewRows { rows: 0, needed: crate::data::error::FEWEST_ROWS })
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

/// Where noise could not be measured at rest, it is taken from what the calibrated base model leaves over inside short stretches; never more than what it
/// leaves over in all.
fn without_rest(problem: &Problem<'_>, noise: NoiseModel) -> Result<NoiseModel, DiagnoseError> {
    if noise.measured {
        return Ok(noise);
    }
    let context = problem.context(problem.span(), noise.floor());
    let model = Model::new(problem, &context, Vec::new());
    let runs = problem.runs();
    let calibrated =
        |noise: &NoiseModel| lowest(&model, &noise.whitener(&runs, None), &noise.scaled(LOOSE).whitener(&runs, None));
    let mut known = noise;
    for _ in 0..2 {
        let misfit = without_what_follows_drivers(problem.inputs, model.misfit(&calibrated(&known)?.z)?);
        known = from_misfit(problem, &misfit, &known);
    }
    Ok(not_above(problem, &model.misfit(&calibrated(&known)?.z)?, known))
}
