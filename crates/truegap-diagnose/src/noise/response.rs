//! Noise before anything else: of the inputs, and of the response, from rest or replicates; never from what a model leaves over a slow change.
//!
//! Limits: one noise for the whole recording.

use crate::{
    data::{context::load_column, problem::Problem},
    noise::{
        input_error::input_error,
        reml::{Block, estimate, without_outliers},
        rest,
    },
    stats::resolution,
    whitening::{
        noise_model::{InputNoise, NoiseModel},
        whitener::Noise,
    },
};
use truegap_core::SimulationError;

/// Fewest rows at rest that a noise model may rest on.
const ENOUGH: usize = 120;
/// Most rows at rest that are used; more would not change the figures.
const PLENTY: usize = 6000;

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
    let input_error = input_error(problem, base, &inputs, left, shapes)?;
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
pub(crate) fn no_finer_than_read(noise: Noise, problem: &Problem<'_>) -> Noise {
    Noise { white_sd: noise.white_sd.max(resolution(problem.response) / 12f64.sqrt()), ..noise }
}

/// Least relative uncertainty of a noise that was not measured at rest.
const UNSEEN: f64 = 0.25;

/// Stretches to take the noise from, whether they are apart from the mismatch, and a sentence about them; a load that `bends` all the time never rests.
pub(crate) fn blocks(
    problem: &Problem<'_>,
    load: Option<&[f64]>,
    inputs: &InputNoise,
    bends: bool,
) -> (Vec<Block>, bool, String) {
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
pub(crate) fn thin(blocks: &mut Vec<Block>) {
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
