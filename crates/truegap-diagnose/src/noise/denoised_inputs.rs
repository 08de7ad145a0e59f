//! Inputs without their noise, column by column.
//!
//! Limits: one noise for a whole column.

use crate::{
    data::pauses::after_pauses,
    noise::tuning::{CROOKED, FINE_K},
    noise::{
        clock, crossings,
        denoise::{self, Denoised},
        errors_in_load,
        input::{self, scatter},
        rounding::{self, Rounded},
    },
    whitening::noise_model::InputNoise,
};
use std::ops::Range;
use truegap_core::{Inputs, Simulator};

/// Inputs without their noise.
pub struct DenoisedInputs {
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
    /// error of a load that is written in steps, in full loads
    pub load_steps: Option<Rounded>,
    /// the same of the temperature, K
    pub temperature_steps: Option<Rounded>,
}

/// Takes the noise out of load and temperature; `response` is what follows them. A load that is `switching` has none that could be told from it.
pub fn denoised_inputs(inputs: &Inputs, response: &[f64], simulator: &dyn Simulator, switching: bool) -> DenoisedInputs {
    let runs = between_pauses(inputs);
    let none = || vec![0.0; inputs.len()];
    let mut out = DenoisedInputs {
        inputs: inputs.clone(),
        noise: InputNoise::default(),
        load_left: none(),
        temperature_left: none(),
        load_shapes: Vec::new(),
        load_steps: None,
        temperature_steps: None,
    };
    // rows without a clock need not be evenly spaced: uneven steps of a table of set points are no noise
    let Some(time) = &inputs.time_s else { return out };
    let time = &clock::even(time, &runs);
    let time = Some(time.as_slice());
    let full = simulator.full_load().unwrap_or(1.0);
    // of the loads, the one that the simulator sees says how noisy it is
    let sd = simulator.load(inputs).filter(|_| !switching).map_or(0.0, |load| scatter(&load, time, &runs)) * full;
    for column in [&mut out.inputs.force_n, &mut out.inputs.pressure_pa].into_iter().flatten() {
        let steps = rounding::rounded(column, &runs, Some(response), 0.0).filter(|_| !switching);
        if let Some(steps) = &steps {
            steps.level_holds(column);
        }
        let Column { sd, found, wanders } = denoised(column, time, &runs, sd, steps.as_ref());
        out.noise.load = sd / full;
        out.load_steps = steps.map(|steps| steps.over(full));
        if wanders {
            out.load_shapes = errors_in_load::error_shapes(column, &runs, sd);
            out.load_shapes.iter_mut().flatten().for_each(|v| *v /= full);
        }
        (*column, out.load_left) = (found.column, found.left);
    }
    if let Some(column) = &mut out.inputs.temperature_c {
        let steps = rounding::rounded(column, &runs, None, FINE_K);
        let sd = scatter(column, time, &runs);
        if let Some(steps) = &steps {
            steps.level_holds(column);
            *column = crossings::course(column, &runs, steps.step);
        }
        let Column { sd, found, .. } = denoised(column, time, &runs, sd, steps.as_ref());
        out.noise.temperature = sd;
        out.temperature_steps = steps;
        (*column, out.temperature_left) = (found.column, found.left);
    }
    out
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
struct Column {
    /// standard deviation of the noise
    sd: f64,
    found: Denoised,
    /// whether it is no course of straight lines
    wanders: bool,
}

/// A column on straight lines; as it is, where hardly any hold. The noise of one that is written in steps is not below that of the steps.
fn denoised(column: &[f64], time: Option<&[f64]>, runs: &[Range<usize>], sd: f64, steps: Option<&Rounded>) -> Column {
    let least = steps.map_or(0.0, |steps| steps.step / 12f64.sqrt());
    let (most, unbent) = input::bent(column, runs);
    let (sd, most, unbent) = (sd.max(least), most.max(least), unbent.max(least));
    if sd > 0.0 && denoise::crookedness(column, time, runs, sd.min(most)) > CROOKED {
        let sd = sd.min(unbent);
        return Column { sd, found: Denoised { column: column.to_vec(), left: vec![1.0; column.len()] }, wanders: true };
    }
    Column { sd, found: denoise::denoise(column, time, runs, sd), wanders: false }
}
