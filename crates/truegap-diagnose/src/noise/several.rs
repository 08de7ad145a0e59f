//! Inputs without their noise, and the noise itself: of one recording, or of each of several by itself.
//!
//! Limits: as [`crate::noise::response`]; recordings share no noise.

use crate::{
    data::{context::load_column, error::DiagnoseError, problem::Problem},
    fit::model::Model,
    noise::{
        beside_louder::{beside_louder_rows, not_louder_beside},
        denoised_inputs::{DenoisedInputs, denoised_inputs},
        grows::Beside,
        input_error::Left,
        louder::{Louder, louder},
        louder_neighbours::louder_neighbours,
        rescale::not_above,
        response::{follows_nothing, from_misfit, groups_alike, noise_model},
        scout::calibrated,
        switching::load_switches,
        tuning::{CARRIED_ANEW, KNOWN_TO_BE_WILD},
    },
    whitening::{
        noise_model::{InputNoise, NoiseModel, RecordingNoise},
        whitener::Lasting,
    },
};
use std::ops::Range;
use truegap_core::{Inputs, Joined};

/// The denoised inputs, and the noise of every row.
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
    let DenoisedInputs { inputs, noise, load_left, temperature_left, load_shapes, load_steps, temperature_steps } =
        denoised_inputs(problem.inputs, problem.response, problem.simulator, load_switches(problem));
    let still = Problem { inputs: &inputs, response: problem.response, simulator: problem.simulator };
    let left = Left {
        load: &load_left,
        temperature: &temperature_left,
        shapes: &load_shapes,
        load_steps: load_steps.as_ref(),
        temperature_steps: temperature_steps.as_ref(),
    };
    let inputs_noise = noise;
    let noise = noise_model(&still, &still.simulator.centre(), inputs_noise, &left)?;
    let noise = match far_from_the_prior(&still, &noise)? {
        // a model that has no answer beside its calibrated numbers keeps what was foreseen
        Some(values) => noise_model(&still, &values, inputs_noise, &left).unwrap_or(noise),
        None => noise,
    };
    let noise = without_rest(&still, noise)?;
    let noise = with_louder_rows(&still, noise)?;
    Ok((inputs, noise))
}

/// The calibrated numbers of the base model, where calibration drives one far: the error of the inputs is then carried through another slope than foreseen.
fn far_from_the_prior(problem: &Problem<'_>, noise: &NoiseModel) -> Result<Option<Vec<f64>>, DiagnoseError> {
    if noise.inputs == InputNoise::default() {
        return Ok(None);
    }
    let context = problem.context(problem.span(), noise.floor());
    let model = Model::new(problem, &context, Vec::new());
    let calibrated = calibrated(&model, noise)?;
    let far = calibrated.z.iter().any(|z| z.abs() > CARRIED_ANEW);
    Ok(far.then(|| model.values(&calibrated.z)))
}

fn of_several(problem: &Problem<'_>, joined: &dyn Joined) -> Result<(Inputs, NoiseModel), DiagnoseError> {
    let mut denoised = problem.inputs.clone();
    let mut all: Option<NoiseModel> = None;
    let mut shapes: Vec<Vec<f64>> = Vec::new();
    let (mut lasting, mut louder): (Vec<Lasting>, Vec<f64>) = (Vec::new(), Vec::new());
    for index in 0..joined.count() {
        let rows = joined.rows(index, problem.inputs);
        if rows.is_empty() {
            continue;
        }
        let inputs = joined.inputs(index, problem.inputs);
        let response = &problem.response[rows.clone()];
        let (own, noise) = of_one(&Problem { inputs: &inputs, response, simulator: joined.model(index) })?;
        put(&mut denoised, &rows, &own);
        let first = all.is_none();
        let joint = all.get_or_insert_with(|| NoiseModel { rows: 0, says: String::new(), ..noise.clone() });
        if !first {
            joint.input_error.variance.extend(&noise.input_error.variance);
            joint.input_error.level.extend(&noise.input_error.level);
            joint.uncertainty = joint.uncertainty.max(noise.uncertainty);
            joint.step = joint.step.max(noise.step);
            joint.measured &= noise.measured;
            joint.input_error.wanders |= noise.input_error.wanders;
            joint.says += "; ";
        }
        shapes.extend(noise.input_error.shapes.iter().map(|own| {
            let mut whole = vec![0.0; problem.response.len()];
            whole[rows.clone()].copy_from_slice(own);
            whole
        }));
        for own in &noise.input_error.lasting {
            let mut whole = Lasting {
                variance: vec![0.0; problem.response.len()],
                memory: vec![0.0; problem.response.len()],
                of_reading: own.of_reading,
            };
            whole.variance[rows.clone()].copy_from_slice(&own.variance);
            whole.memory[rows.clone()].copy_from_slice(&own.memory);
            lasting.push(whole);
        }
        louder.extend(own_or_none(&noise.input_error.louder, rows.len()));
        joint.rows += noise.rows;
        joint.says += &format!("recording {}: {}", index + 1, noise.says);
        joint.recordings.push(RecordingNoise { rows, response: noise.response, inputs: noise.inputs, says: noise.says });
    }
    if let Some(noise) = &mut all {
        noise.input_error.shapes = shapes;
        noise.input_error.lasting = together(lasting);
        noise.input_error.louder = louder;
    }
    all.map(|noise| (denoised, noise)).ok_or(DiagnoseError::TooFewRows { rows: 0, needed: crate::data::error::FEWEST_ROWS })
}

/// A column, or as many zeros.
fn own_or_none(column: &[f64], rows: usize) -> Vec<f64> {
    if column.is_empty() { vec![0.0; rows] } else { column.to_vec() }
}

/// Errors that last, those that have no row in common put into one.
fn together(all: Vec<Lasting>) -> Vec<Lasting> {
    let mut found: Vec<Lasting> = Vec::new();
    for one in all {
        let apart = |other: &&mut Lasting| {
            let rows = other.variance.iter().zip(&one.variance);
            other.of_reading == one.of_reading && rows.into_iter().all(|(a, b)| *a == 0.0 || *b == 0.0)
        };
        match found.iter_mut().find(apart) {
            None => found.push(one),
            Some(other) => {
                other.variance.iter_mut().zip(&one.variance).for_each(|(a, b)| *a += b);
                other.memory.iter_mut().zip(&one.memory).for_each(|(a, b)| *a += b);
            }
        }
    }
    found
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

/// The noise with rows that are louder than others, seen beside the calibrated base model.
fn with_louder_rows(problem: &Problem<'_>, noise: NoiseModel) -> Result<NoiseModel, DiagnoseError> {
    if !rows_can_be_louder(&noise) {
        return Ok(noise);
    }
    let context = problem.context(problem.span(), noise.floor());
    let model = Model::new(problem, &context, Vec::new());
    let misfit = model.misfit(&calibrated(&model, &noise)?.z)?;
    Ok(with_louder_rows_beside(problem, &misfit, noise))
}

/// The same beside a model that leaves `misfit`.
pub(crate) fn with_louder_rows_beside(problem: &Problem<'_>, misfit: &[f64], noise: NoiseModel) -> NoiseModel {
    if !rows_can_be_louder(&noise) {
        return noise;
    }
    match louder_rows(problem, misfit, &noise).filter(|found| !found.only_wild) {
        Some(found) => beside_louder_rows(problem, &noise, found),
        None => noise,
    }
}

/// The noise where rows are wild beside a model that explains more than the base model does, which leaves `misfit`; `None` where no row is wild that was not known to be.
///
/// What the base model leaves may change faster from row to row than a wild row stands out; and what is wild beside it may be what it lacks.
pub fn with_wild_rows(problem: &Problem<'_>, misfit: &[f64], noise: &NoiseModel) -> Option<NoiseModel> {
    // without a clock nothing says that the rows about a wild one are read beside it
    if !problem.is_one_with_a_clock() || !rows_can_be_louder(noise) {
        return None;
    }
    let found = louder_rows(problem, misfit, noise)?;
    let known = |row: &usize| noise.input_error.louder.get(*row).copied().unwrap_or(0.0);
    let new = found.wild.iter().any(|row| known(row) < KNOWN_TO_BE_WILD * found.variance[*row]);
    new.then(|| not_louder_beside(problem, noise, found.wild_only()))
}

/// A row is told from its neighbours in time, or without a clock from those at neighbouring inputs.
fn rows_can_be_louder(noise: &NoiseModel) -> bool {
    !noise.lasts()
}

fn louder_rows(problem: &Problem<'_>, misfit: &[f64], noise: &NoiseModel) -> Option<Louder> {
    if problem.inputs.time_s.is_none() {
        return louder_neighbours(&groups_alike(problem, noise), problem.inputs, misfit, problem.response);
    }
    let runs = problem.runs();
    let load = load_column(problem.inputs, problem.simulator);
    let value: Vec<f64> = problem.response.iter().zip(misfit).map(|(reading, misfit)| reading - misfit).collect();
    let beside = Beside { inputs: problem.inputs, runs: &runs, value: &value, misfit, reading: problem.response };
    let drivers = problem.inputs.drivers.iter().map(|driver| driver.values.as_slice());
    let jumping: Vec<&[f64]> = drivers.chain(load.as_deref()).chain(problem.inputs.simulated.as_deref()).collect();
    louder(&beside, &jumping)
}

/// Where noise could not be measured at rest, it is taken from what the calibrated base model leaves over inside short stretches; never more than what it
/// leaves over in all.
fn without_rest(problem: &Problem<'_>, noise: NoiseModel) -> Result<NoiseModel, DiagnoseError> {
    if noise.measured {
        return Ok(noise);
    }
    let context = problem.context(problem.span(), noise.floor());
    let model = Model::new(problem, &context, Vec::new());
    let mut known = noise;
    for _ in 0..2 {
        let misfit = follows_nothing(problem.inputs, model.misfit(&calibrated(&model, &known)?.z)?);
        known = from_misfit(problem, &misfit, &known);
    }
    Ok(not_above(problem, &model.misfit(&calibrated(&model, &known)?.z)?, known))
}
