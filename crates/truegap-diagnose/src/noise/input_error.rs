//! Noise of the inputs, carried through the base model to the response.
//!
//! Limits: linear in the noise.

use crate::{
    data::problem::Problem,
    noise::rounding::Rounded,
    whitening::{
        noise_model::InputNoise,
        whitener::{InputError, Lasting},
    },
};
use truegap_core::{Inputs, SimulationError, Stage};

/// What denoising left of the noise of load and temperature.
pub struct Left<'a> {
    /// share of the variance of the load's noise, row by row
    pub load: &'a [f64],
    /// the same of the temperature
    pub temperature: &'a [f64],
    /// courses that the error of the load follows with weights that are not known, in full loads
    pub shapes: &'a [Vec<f64>],
    /// error of a load that is written in steps, in full loads
    pub load_steps: Option<&'a Rounded>,
    /// the same of the temperature, K
    pub temperature_steps: Option<&'a Rounded>,
}

/// Error that noise of the inputs adds to each row, at parameter values `base`.
///
/// # Errors
/// Those of the simulator.
pub fn input_error(
    problem: &Problem<'_>,
    base: &[f64],
    noise: &InputNoise,
    left: &Left<'_>,
) -> Result<InputError, SimulationError> {
    let mut error = InputError::white(vec![0.0; problem.inputs.len()]);
    let here = problem.simulator.respond(base, problem.inputs, &[])?;
    if noise.load > 0.0 && problem.simulator.full_load().is_some() {
        let step = 1e-3;
        let there = problem.simulator.respond(base, problem.inputs, &[&Nudge { load: step, kelvin: 0.0 }])?;
        let slope: Vec<f64> = there.iter().zip(&here).map(|(a, b)| (a - b) / step).collect();
        let carried = |shape: &Vec<f64>| shape.iter().zip(&slope).map(|(s, slope)| s * slope).collect();
        error.shapes = left.shapes.iter().map(carried).collect();
        error.wanders = !left.shapes.is_empty();
        add(&mut error, (&there, &here), step, noise.load, (left.load, left.load_steps));
    }
    if noise.temperature > 0.0 && problem.inputs.temperature_c.is_some() {
        let step = 0.1;
        let there = problem.simulator.respond(base, problem.inputs, &[&Nudge { load: 0.0, kelvin: step }])?;
        add(&mut error, (&there, &here), step, noise.temperature, (left.temperature, left.temperature_steps));
    }
    Ok(error)
}

/// Adds the error of one input, which a nudge of `step` takes from the second of the responses to the first.
fn add(error: &mut InputError, (there, here): (&[f64], &[f64]), step: f64, sd: f64, (left, steps): (&[f64], Option<&Rounded>)) {
    let ratio = sd / step;
    for (row, (a, b)) in there.iter().zip(here).enumerate() {
        let recorded = ((a - b) * ratio).powi(2);
        // where a column stands still in its steps, most of its error does too
        let alone = steps.filter(|steps| steps.stays(row) > 0.0).map_or(1.0, |steps| (steps.white / (sd * sd)).min(1.0));
        error.variance[row] += recorded * alone * left[row];
        error.level[row] += recorded * alone;
    }
    if let Some(steps) = steps {
        let slopes: Vec<f64> = there.iter().zip(here).map(|(a, b)| (a - b) / step).collect();
        let variance = slopes.iter().zip(&steps.held).map(|(slope, held)| slope * slope * held).collect();
        error.shapes.extend(steps.same.iter().map(|level| level.iter().zip(&slopes).map(|(sd, slope)| sd * slope).collect()));
        error.lasting.push(Lasting { variance, memory: steps.memory.clone(), of_reading: false });
    }
}

/// Adds a constant to an input; for derivatives.
struct Nudge {
    load: f64,
    kelvin: f64,
}

impl Stage for Nudge {
    fn load(&self, _: &Inputs, load: &mut [f64]) {
        if self.load != 0.0 {
            load.iter_mut().for_each(|l| *l += self.load);
        }
    }
    fn thermal(&self, _: &Inputs, temperature_c: &mut [f64]) {
        if self.kelvin != 0.0 {
            temperature_c.iter_mut().for_each(|t| *t += self.kelvin);
        }
    }
}
