//! Noise before anything else: of the inputs, and of the response, from rest or replicates; never from what a model leaves over a slow change.
//!
//! Limits: one noise for the whole recording.

mod bends;
pub mod denoise;
mod input;
mod likelihood;
mod lowered;
mod rest;

use crate::context::load_column;
use crate::problem::{InputNoise, NoiseModel, Problem};
use crate::screen::pauses::after_pauses;
use crate::whiten::Noise;
use denoise::Denoised;
pub use input::scatter;
use likelihood::{Block, estimate, without_outliers};
pub use lowered::{not_above, quieter_than, too_loud};
use std::ops::Range;
use truegap_core::{Inputs, SimulationError, Simulator};

/// Fewest rows at rest that a noise model may rest on.
const ENOUGH: usize = 120;
/// Most rows at rest that are used; more would not change the figures.
const PLENTY: usize = 6000;

/// Inputs without their noise.
pub struct Quiet {
    /// the inputs
    pub inputs: Inputs,
    /// noise as recorded
    pub noise: InputNoise,
    /// share of the variance of the load's noise that is left, row by row
    pub load_left: Vec<f64>,
    /// the same of the temperature
    pub temperature_left: Vec<f64>,
    /// courses that the error of the load follows with a weight not known beforehand, in full loads at one standard deviation of it
    pub load_shapes: Vec<Vec<f64>>,
}

/// Takes the noise out of load and temperature.
pub fn quiet(inputs: &Inputs, simulator: &dyn Simulator) -> Quiet {
    let (runs, time) = (between_pauses(inputs), inputs.time_s.as_deref());
    let none = || vec![0.0; inputs.len()];
    let mut quiet = Quiet {
        inputs: inputs.clone(),
        noise: InputNoise::default(),
        load_left: none(),
        temperature_left: none(),
        load_shapes: Vec::new(),
    };
    let full = simulator.full_load().unwrap_or(1.0);
    // of the loads, the one that the simulator sees says how noisy it is
    let sd = simulator.load(inputs).map_or(0.0, |load| scatter(&load, time, &runs)) * full;
    for column in [&mut quiet.inputs.force_n, &mut quiet.inputs.pressure_pa].into_iter().flatten() {
        let Quieter { sd, found, bends } = quieter(column, time, &runs, sd);
        quiet.noise.load = sd / full;
        if bends {
            quiet.load_shapes = bends::bends(column, &runs, sd);
            quiet.load_shapes.iter_mut().flatten().for_each(|v| *v /= full);
        }
        (*column, quiet.load_left) = (found.column, found.left);
    }
    if let Some(column) = &mut quiet.inputs.temperature_c {
        let Quieter { sd, found, .. } = quieter(column, time, &runs, scatter(column, time, &runs));
        quiet.noise.temperature = sd;
        (*column, quiet.temperature_left) = (found.column, found.left);
    }
    quiet
}

/// Runs, parted where time jumps: no line of an input goes on through a pause.
fn between_pauses(inputs: &Inputs) -> Vec<Range<usize>> {
    let cuts = after_pauses(inputs).map_or_else(Vec::new, |(_, rows)| rows);
    let mut parts = Vec::new();
    for run in inputs.runs() {
        let mut start = run.start;
        for cut in cuts.iter().copied().filter(|cut| run.contains(cut) && *cut > run.start) {
            parts.push(start..cut);
            start = cut;
        }
        parts.push(start..run.end);
    }
    parts
}

/// A column without its noise.
struct Quieter {
    /// standard deviation of the noise
    sd: f64,
    found: Denoised,
    /// whether it is no course of straight lines
    bends: bool,
}

/// A column on straight lines; as it is, where hardly any hold.
fn quieter(column: &[f64], time: Option<&[f64]>, runs: &[Range<usize>], sd: f64) -> Quieter {
    let (most, unbent) = input::bent(column, runs);
    if sd > 0.0 && denoise::crookedness(column, time, runs, sd.min(most)) > CROOKED {
        let sd = sd.min(unbent);
        return Quieter { sd, found: Denoised { column: column.to_vec(), left: vec![1.0; column.len()] }, bends: true };
    }
    Quieter { sd, found: denoise::denoise(column, time, runs, sd), bends: false }
}

/// Scatter about short lines, over that of noise, from which on a column is no course of straight lines.
const CROOKED: f64 = 0.85;
/// Noise of a problem whose inputs were quietened: `inputs` as recorded, `left` the shares of variance left in load and temperature,
/// `shapes` courses that the error of the load may follow, `base` the parameter values at which all that is carried through.
///
/// # Errors
/// Those of the simulator.
pub fn noise_model(
    problem: &Problem<'_>,
    base: &[f64],
    inputs: InputNoise,
    left: (&[f64], &[f64]),
    shapes: &[Vec<f64>],
) -> Result<NoiseModel, SimulationError> {
    let load = load_column(problem.inputs, problem.simulator);
    let input_error = problem.input_variance(base, &inputs, left, shapes)?;
    let (blocks, measured, says) = blocks(problem, load.as_deref(), &inputs, !shapes.is_empty());
    let rows = blocks.iter().map(|b| b.rows.len()).sum();
    let (response, uncertainty) = estimate(problem.response, &blocks);
    let response = no_finer_than_read(response, problem);
    let recordings = Vec::new();
    Ok(NoiseModel { response, inputs, recordings, input_error, uncertainty, weights: None, measured, rows, says })
}

/// Noise of a recording that never rests, from what a calibrated model leaves over inside short stretches: there a slow misfit is taken out with the cubic,
/// and a fast one counts as noise.
pub fn from_misfit(problem: &Problem<'_>, misfit: &[f64], noise: &NoiseModel) -> NoiseModel {
    let mut short = without_outliers(misfit, rest::short_stretches(problem.inputs));
    thin(&mut short);
    let rows = short.iter().map(|b| b.rows.len()).sum();
    let (response, uncertainty) = estimate(misfit, &short);
    let response = no_finer_than_read(response, problem);
    let says = format!(
        "no rest record: from what the calibrated model leaves over in {rows} rows of short stretches; slow noise would go unseen"
    );
    NoiseModel { response, rows, uncertainty: uncertainty.max(UNSEEN), says, ..noise.clone() }
}

/// A response is read to steps, which are noise too.
fn no_finer_than_read(noise: Noise, problem: &Problem<'_>) -> Noise {
    Noise { white_sd: noise.white_sd.max(resolution(problem.response) / 12f64.sqrt()), ..noise }
}

/// Least relative uncertainty of a noise that was not measured at rest.
const UNSEEN: f64 = 0.25;

/// Stretches to take the noise from, whether they are apart from the mismatch, and a sentence about them; a load that `bends` all the time never rests.
fn blocks(problem: &Problem<'_>, load: Option<&[f64]>, inputs: &InputNoise, bends: bool) -> (Vec<Block>, bool, String) {
    let at_rest = if bends { Vec::new() } else { rest::at_rest(problem.inputs, load, inputs) };
    let mut rest = without_outliers(problem.response, at_rest);
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
