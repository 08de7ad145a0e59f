//! Noise of the inputs, carried through the base model to the response.
//!
//! Limits: linear in the noise.

use crate::{
    data::problem::Problem,
    whitening::{noise_model::InputNoise, whitener::InputError},
};
use truegap_core::{Inputs, SimulationError, Stage};

/// Error that noise of the inputs adds to each row, at parameter values `base`; `left` are the shares of it that quietening left in a row,
/// `shapes` courses of the error of the load, in full loads, whose weights are not known.
///
/// # Errors
/// Those of the simulator.
pub fn input_error(
    problem: &Problem<'_>,
    base: &[f64],
    noise: &InputNoise,
    left: (&[f64], &[f64]),
    shapes: &[Vec<f64>],
) -> Result<InputError, SimulationError> {
    let mut error = InputError::white(vec![0.0; problem.inputs.len()]);
    let here = problem.simulator.respond(base, problem.inputs, &[])?;
    let add = |error: &mut InputError, there: Vec<f64>, ratio: f64, left: &[f64]| {
        for (row, (a, b)) in there.iter().zip(&here).enumerate() {
            let recorded = ((a - b) * ratio).powi(2);
            error.variance[row] += recorded * left[row];
            error.level[row] += recorded;
        }
    };
    if noise.load > 0.0 && problem.simulator.full_load().is_some() {
        let step = 1e-3;
        let there = problem.simulator.respond(base, problem.inputs, &[&Nudge { load: step, kelvin: 0.0 }])?;
        let slope: Vec<f64> = there.iter().zip(&here).map(|(a, b)| (a - b) / step).collect();
        let carried = |shape: &Vec<f64>| shape.iter().zip(&slope).map(|(s, slope)| s * slope).collect();
        error.shapes = shapes.iter().map(carried).collect();
        add(&mut error, there, noise.load / step, left.0);
    }
    if noise.temperature > 0.0 && problem.inputs.temperature_c.is_some() {
        let step = 0.1;
        add(
            &mut error,
            problem.simulator.respond(base, problem.inputs, &[&Nudge { load: 0.0, kelvin: step }])?,
            noise.temperature / step,
            left.1,
        );
    }
    Ok(error)
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
