//! Noise before anything else: of the inputs, and of the response, from rest or replicates; never from what a model leaves over a slow change.
//!
//! Limits: one noise for the whole recording.

mod input;
mod likelihood;
mod rest;

use crate::problem::{InputNoise, NoiseModel, Problem};
use crate::whiten::Noise;
pub use input::scatter;
use likelihood::{Block, estimate};
use truegap_core::SimulationError;

/// Fewest rows at rest that a noise model may rest on.
const ENOUGH: usize = 120;
/// Most rows at rest that are used; more would not change the figures.
const PLENTY: usize = 6000;

/// Noise of a problem; `base` are parameter values at which the inputs' noise is carried through.
///
/// # Errors
/// Those of the simulator.
pub fn noise_model(problem: &Problem<'_>, base: &[f64]) -> Result<NoiseModel, SimulationError> {
    let load = problem.simulator.load(problem.inputs);
    let runs = problem.runs();
    let inputs = InputNoise {
        load: load.as_deref().map_or(0.0, |l| scatter(l, &runs)),
        temperature: problem.inputs.temperature_c.as_deref().map_or(0.0, |t| scatter(t, &runs)),
    };
    let extra_variance = problem.input_variance(base, &inputs)?;
    let (blocks, measured, says) = blocks(problem, load.as_deref(), &inputs);
    let rows = blocks.iter().map(|b| b.rows.len()).sum();
    let total = estimate(problem.response, &blocks);
    let response = without_inputs(total, &blocks, &extra_variance, problem.response);
    Ok(NoiseModel { response, inputs, extra_variance, weights: None, measured, rows, says })
}

/// Stretches to take the noise from, whether they are apart from the mismatch, and a sentence about them.
fn blocks(problem: &Problem<'_>, load: Option<&[f64]>, inputs: &InputNoise) -> (Vec<Block>, bool, String) {
    let mut rest = rest::at_rest(problem.inputs, load, inputs);
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
    let mut short = rest::short_stretches(problem.inputs);
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

/// Takes the part of the white noise that comes from the inputs off the figure measured at rest.
fn without_inputs(total: Noise, blocks: &[Block], extra: &[f64], response: &[f64]) -> Noise {
    let rows = blocks.iter().flat_map(|b| &b.rows);
    let (sum, count) = rows.fold((0.0, 0.0), |(s, n), row| (s + extra[*row], n + 1.0));
    let white2 = total.white_sd.powi(2);
    let floor = resolution(response) / 12f64.sqrt();
    let left = white2 - if count > 0.0 { sum / count } else { 0.0 };
    Noise { white_sd: left.max(0.05 * white2).sqrt().max(floor), ..total }
}

/// Smallest difference between two neighbouring values of a column; 0 where all are equal.
pub fn resolution(column: &[f64]) -> f64 {
    let greatest = column.iter().fold(0.0f64, |m, v| m.max(v.abs()));
    let differences = column.windows(2).map(|w| (w[1] - w[0]).abs()).filter(|d| *d > 1e-12 * greatest);
    let least = differences.fold(f64::INFINITY, f64::min);
    if least.is_finite() { least } else { 0.0 }
}
