//! Noise before anything else: of the inputs, and of the response, from rest or replicates; never from what a model leaves over a slow change.
//!
//! Limits: one noise for the whole recording.

use crate::{
    data::{context::load_column, problem::Problem},
    noise::neighbours::{lie_apart, neighbours},
    noise::tuning::{ENOUGH_ROWS, FEWEST_NEIGHBOURS, FEWEST_REPLICATES, PLENTY_OF_ROWS, UNSEEN},
    noise::{
        follows_drivers::without_what_follows_drivers,
        input_error::{Left, input_error},
        reml::{Block, estimate, without_outliers},
        rest,
        rounding::rounded,
        slow::{beside, slow},
        tones::without_tones,
    },
    stats::finest_step,
    whitening::{
        noise_model::{InputNoise, NoiseModel, tells},
        whitener::{InputError, Lasting, Noise},
    },
};
use truegap_core::{Inputs, SimulationError};

/// Noise of a problem whose inputs were denoised: `inputs` as recorded, `left` what denoising left of it, `base` the parameter values at which all that is carried
/// through.
///
/// # Errors
/// Those of the simulator.
pub fn noise_model(
    problem: &Problem<'_>,
    base: &[f64],
    inputs: InputNoise,
    left: &Left<'_>,
) -> Result<NoiseModel, SimulationError> {
    let load = load_column(problem.inputs, problem.simulator);
    let input_error = input_error(problem, base, &inputs, left)?;
    let (blocks, measured, says) = blocks(problem, load.as_deref(), &inputs, !left.shapes.is_empty());
    let rows = blocks.iter().map(|b| b.rows.len()).sum();
    let (response, uncertainty) = estimate(problem.response, &blocks);
    // one white noise for all rows is all that neighbours can tell
    let uncertainty = if problem.runs_in_order().is_empty() { uncertainty.max(UNSEEN) } else { uncertainty };
    let response = no_finer_than_read(response, problem);
    let recordings = Vec::new();
    let (response, input_error, step) = read_in_steps(problem, response, input_error);
    let ordered = problem.inputs.time_s.is_some() || lie_apart(&blocks);
    let (response, input_error, says) = match slow(problem.response, &blocks, &response).filter(|_| measured && ordered) {
        Some(slow) => {
            let mut error = input_error;
            beside(&mut error, problem.response.len(), slow);
            (Noise { white_sd: slow.white_sd, ar_sd: 0.0, ar_correlation: 0.0 }, error, says + "; slow like 1/f")
        }
        None => (response, input_error, says),
    };
    Ok(NoiseModel {
        response,
        inputs,
        recordings,
        input_error,
        step,
        uncertainty,
        weights: None,
        untold: Vec::new(),
        measured,
        rows,
        says,
    })
}

/// Noise of a recording that never rests, from what a calibrated model leaves over inside short stretches: there a slow misfit is taken out with the cubic,
/// and a fast one counts as noise.
pub fn from_misfit(problem: &Problem<'_>, misfit: &[f64], noise: &NoiseModel) -> NoiseModel {
    let misfit = &noise.with_rows_alike(misfit);
    let mut short = without_outliers(misfit, rest::short_stretches(problem.inputs));
    keep_some(&mut short);
    let rows = short.iter().map(|b| b.rows.len()).sum();
    let (response, uncertainty) = estimate(misfit, &short);
    let response = no_finer_than_read(response, problem);
    let weighs_less = |(row, variance): (usize, &f64)| *variance > 0.0 && tells(&noise.untold, row);
    let any_louder = noise.input_error.louder.iter().enumerate().any(weighs_less);
    let louder = if any_louder { "; louder rows weigh less" } else { "" };
    let says = format!(
        "no rest record: from what the calibrated model leaves over in {rows} rows of short stretches; slow noise would go unseen{louder}"
    );
    NoiseModel { response, rows, uncertainty: uncertainty.max(UNSEEN), says, ..noise.clone() }
}

/// What of a misfit follows no driver and is no tone.
pub(crate) fn follows_nothing(inputs: &Inputs, misfit: Vec<f64>) -> Vec<f64> {
    without_tones(inputs, without_what_follows_drivers(inputs, misfit))
}

/// The noise of a reading that is written in steps, and the step: what they make of it lasts as long as it stays on one value.
fn read_in_steps(problem: &Problem<'_>, noise: Noise, mut error: InputError) -> (Noise, InputError, f64) {
    let Some(steps) = rounded(problem.response, &problem.runs(), None, 0.0) else { return (noise, error, 0.0) };
    let alone = steps.step * steps.step / 12.0;
    let white = steps.white.max(0.09 * alone);
    // rows on the way have the error of the step each by itself, those on the edge of a step flicker more than the others
    let louder = |row| (if steps.stays(row) > 0.0 { steps.flicker[row] } else { alone } - white).max(0.0);
    error.louder = (0..steps.held.len()).map(louder).collect();
    error.shapes.extend(steps.same);
    error.lasting.push(Lasting { variance: steps.held, memory: steps.memory, of_reading: true });
    (Noise { white_sd: white.sqrt(), ar_sd: 0.0, ar_correlation: 0.0 }, error, steps.step)
}

/// A response is read to steps, which are noise too: the least difference of any two readings, for a reading that climbs goes by many steps from row to row.
pub(crate) fn no_finer_than_read(noise: Noise, problem: &Problem<'_>) -> Noise {
    Noise { white_sd: noise.white_sd.max(finest_step(problem.response) / 12f64.sqrt()), ..noise }
}

/// Stretches to take the noise from, whether they are apart from the mismatch, and a sentence about them; a load that `wanders` never rests.
pub(crate) fn blocks(
    problem: &Problem<'_>,
    load: Option<&[f64]>,
    inputs: &InputNoise,
    wanders: bool,
) -> (Vec<Block>, bool, String) {
    if let Some((blocks, says)) = rest_or_repeated(problem, load, inputs, wanders) {
        return (blocks, true, says);
    }
    if problem.inputs.time_s.is_none() {
        let alike = without_outliers(problem.response, neighbours(problem.inputs, load));
        let rows: usize = alike.iter().map(|b| b.rows.len()).sum();
        if rows >= FEWEST_NEIGHBOURS {
            let says = format!("from {rows} rows at neighbouring inputs, since no clock says which rows follow one another");
            return (alike, true, says);
        }
    }
    let mut short = without_outliers(problem.response, rest::short_stretches(problem.inputs));
    keep_some(&mut short);
    let rows: usize = short.iter().map(|b| b.rows.len()).sum();
    (short, false, format!("no rest record: from the scatter of {rows} rows within short stretches; slow noise would go unseen"))
}

/// Groups of rows at neighbouring inputs, where there is no clock and the noise is taken from them; none elsewhere.
pub(crate) fn groups_alike(problem: &Problem<'_>, noise: &NoiseModel) -> Vec<Block> {
    let load = load_column(problem.inputs, problem.simulator);
    let without = problem.inputs.time_s.is_none()
        && rest_or_repeated(problem, load.as_deref(), &noise.inputs, noise.load_wanders()).is_none();
    if without { neighbours(problem.inputs, load.as_deref()) } else { Vec::new() }
}

/// Stretches at rest, or else rows measured again where there is no clock, and a sentence about them; `None` where there are too few.
fn rest_or_repeated(
    problem: &Problem<'_>,
    load: Option<&[f64]>,
    inputs: &InputNoise,
    wanders: bool,
) -> Option<(Vec<Block>, String)> {
    let at_rest = if wanders { Vec::new() } else { rest::at_rest(problem.inputs, load, remembered(problem).as_deref(), inputs) };
    let mut rest = without_outliers(problem.response, at_rest);
    keep_some(&mut rest);
    let rows: usize = rest.iter().map(|b| b.rows.len()).sum();
    if rows >= ENOUGH_ROWS {
        let says = format!("from {rows} rows in {} stretches at rest, a slow trend taken out of each", rest.len());
        return Some((rest, says));
    }
    let replicates = rest::replicates(problem.inputs, load);
    let repeated: usize = replicates.iter().map(|b| b.rows.len()).sum();
    let says = format!("from {repeated} rows measured again at the same inputs");
    (problem.inputs.time_s.is_none() && repeated >= FEWEST_REPLICATES).then_some((replicates, says))
}

/// What a model that remembers answers to the inputs at the centre of what is known of it; `None` where a row follows from its own inputs, at rest with which it is.
fn remembered(problem: &Problem<'_>) -> Option<Vec<f64>> {
    let simulator = problem.simulator;
    let remembers = !simulator.row_by_row() && simulator.moves() && simulator.joined().is_none();
    remembers.then(|| simulator.respond(&simulator.centre(), problem.inputs, &[]).ok()).flatten()
}

/// Keeps a share of the stretches, spread evenly, where there are more rows than needed.
pub(crate) fn keep_some(blocks: &mut Vec<Block>) {
    let rows: usize = blocks.iter().map(|b| b.rows.len()).sum();
    if rows > PLENTY_OF_ROWS {
        let every = rows.div_ceil(PLENTY_OF_ROWS);
        let mut index = 0;
        blocks.retain(|_| {
            index += 1;
            index % every == 1
        });
    }
    for block in blocks {
        if block.rows.len() > PLENTY_OF_ROWS {
            block.truncate(PLENTY_OF_ROWS);
        }
    }
}
