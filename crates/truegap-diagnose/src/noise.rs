//! Noise before anything else: of the inputs, and of the response, from rest or replicates; never from what a model leaves over a slow change.
//!
//! Limits: one noise for the whole recording.

pub mod denoise;
mod input;
mod likelihood;
mod rest;

use crate::context::load_column;
use crate::problem::{InputNoise, NoiseModel, Problem};
pub use input::scatter;
use likelihood::{Block, estimate, without_outliers};
use truegap_core::{Inputs, SimulationError, Simulator};

/// Fewest rows at rest that a noise model may rest on.
const ENOUGH: usize = 120;
/// Most rows at rest that are used; more would not change the figures.
const PLENTY: usize = 6000;

/// Noise of the recorded load (over the full load) and temperature.
pub fn input_noise(inputs: &Inputs, simulator: &dyn Simulator) -> InputNoise {
    let runs = inputs.runs();
    InputNoise {
        load: simulator.load(inputs).map_or(0.0, |l| scatter(&l, &runs)),
        temperature: inputs.temperature_c.as_deref().map_or(0.0, |t| scatter(t, &runs)),
    }
}

/// The inputs without their noise, and the share of its variance that is left, row by row: of the load and of the temperature.
pub fn quiet_inputs(inputs: &Inputs, simulator: &dyn Simulator, noise: &InputNoise) -> (Inputs, Vec<f64>, Vec<f64>) {
    let runs = inputs.runs();
    let time = inputs.time_s.as_deref();
    let mut quiet = inputs.clone();
    let (mut load_left, mut temperature_left) = (vec![0.0; inputs.len()], vec![0.0; inputs.len()]);
    let full = simulator.full_load().unwrap_or(1.0);
    for column in [&mut quiet.force_n, &mut quiet.pressure_pa].into_iter().flatten() {
        let found = denoise::denoise(column, time, &runs, noise.load * full);
        (*column, load_left) = (found.column, found.left);
    }
    if let Some(column) = &mut quiet.temperature_c {
        let found = denoise::denoise(column, time, &runs, noise.temperature);
        (*column, temperature_left) = (found.column, found.left);
    }
    (quiet, load_left, temperature_left)
}

/// Noise of a problem whose inputs were quietened: `inputs` as recorded, `left` the shares of variance left in load and temperature,
/// `base` the parameter values at which that is carried through.
///
/// # Errors
/// Those of the simulator.
pub fn noise_model(
    problem: &Problem<'_>,
    base: &[f64],
    inputs: InputNoise,
    left: (&[f64], &[f64]),
) -> Result<NoiseModel, SimulationError> {
    let load = load_column(problem.inputs, problem.simulator);
    let input_error = problem.input_variance(base, &inputs, left)?;
    let (blocks, measured, says) = blocks(problem, load.as_deref(), &inputs);
    let rows = blocks.iter().map(|b| b.rows.len()).sum();
    let (mut response, uncertainty) = estimate(problem.response, &blocks);
    response.white_sd = response.white_sd.max(resolution(problem.response) / 12f64.sqrt());
    let recordings = Vec::new();
    Ok(NoiseModel { response, inputs, recordings, input_error, uncertainty, weights: None, measured, rows, says })
}

/// Noise of a recording that never rests, from what a calibrated model leaves over inside short stretches: there a slow misfit is taken out with the cubic,
/// and a fast one counts as noise.
pub fn from_misfit(problem: &Problem<'_>, misfit: &[f64], noise: &NoiseModel) -> NoiseModel {
    let mut short = without_outliers(misfit, rest::short_stretches(problem.inputs));
    thin(&mut short);
    let rows = short.iter().map(|b| b.rows.len()).sum();
    let (mut response, uncertainty) = estimate(misfit, &short);
    response.white_sd = response.white_sd.max(resolution(problem.response) / 12f64.sqrt());
    let says = format!(
        "no rest record: from what the calibrated model leaves over in {rows} rows of short stretches; slow noise would go unseen"
    );
    NoiseModel { response, rows, uncertainty: uncertainty.max(UNSEEN), says, ..noise.clone() }
}

/// Least relative uncertainty of a noise that was not measured at rest.
const UNSEEN: f64 = 0.25;

/// Stretches to take the noise from, whether they are apart from the mismatch, and a sentence about them.
fn blocks(problem: &Problem<'_>, load: Option<&[f64]>, inputs: &InputNoise) -> (Vec<Block>, bool, String) {
    let mut rest = without_outliers(problem.response, rest::at_rest(problem.inputs, load, inputs));
    thin(&mut rest);
    let rows: usize = rest.iter().map(|b| b.rows.len()).sum();
    if rows >= ENOUGH {
        let says = format!("from {rows} rows in {} stretches at rest, a slow trend taken out of each", rest.len());
        return (rest, true, says);
    }
    let replicates = rest::replicates(problem.inputs, load);
    let repeated: usize = replicates.iter().map(|b| b.rows.len()).sum();
    if problem.inputs.time_s.is_none() && repeated >= 12 {
        let says = format!("from {repeated} rows measured again at the same inputs");
        return (replicates, true, says);
    }
    let mut short = without_outliers(problem.response, rest::short_stretches(problem.inputs));
    thin(&mut short);
    let rows: usize = short.iter().map(|b| b.rows.len()).sum();
    (short, false, format!("no rest record: from the scatter of {rows} rows within short stretches; slow noise would go unseen"))
}

/// Keeps a share of the stretches, spread evenly, where there are more rows than needed.
fn thin(blocks: &mut Vec<Block>) {
    let rows: usize = blocks.iter().map(|b| b.rows.len()).sum();
    if rows > PLENTY {
        let every = rows.div_ceil(PLENTY);
        let mut index = 0;
        blocks.retain(|_| {
            index += 1;
            index % every == 1
        });
    }
    for block in blocks {
        if block.rows.len() > PLENTY {
            block.truncate(PLENTY);
        }
    }
}

/// Smallest difference between two neighbouring values of a column; 0 where all are equal.
pub fn resolution(column: &[f64]) -> f64 {
    let greatest = column.iter().fold(0.0f64, |m, v| m.max(v.abs()));
    let differences = column.windows(2).map(|w| (w[1] - w[0]).abs()).filter(|d| *d > 1e-12 * greatest);
    let least = differences.fold(f64::INFINITY, f64::min);
    if least.is_finite() { least } else { 0.0 }
}
