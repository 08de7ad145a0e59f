//! What effects are scaled by: the reading that one can move, where its coefficient says little to a reader, the strain of a full load, and the response without load.
//!
//! Limits: all at the centre of the priors of the base model; the reading on a sample of the rows.

use crate::data::context::Context;
use crate::stats::deviation;
use std::sync::Mutex;
use truegap_core::{Drive, Stage};

/// Rows of the sample.
const ROWS: usize = 96;
/// Share of the response's span by which one prior standard deviation may move the reading (root mean square about its mean).
const SHARE: f64 = 0.2;

/// Prior standard deviation of a size: `physical`, or less where that would move the reading by more than a fifth of its span.
pub fn prior_sd(context: &Context<'_>, physical: f64, with: impl Fn(f64) -> Box<dyn Stage>) -> f64 {
    let step = 0.01 * physical;
    match spread(context, with(step).as_ref()) {
        Some(moved) if moved > 0.0 && context.response_span.abs() > 0.0 => {
            physical.min(SHARE * context.response_span.abs() * step / moved)
        }
        _ => physical,
    }
}

/// Standard deviation over the sampled rows of what `stage` adds to the reading; `None` where the model has no answer.
fn spread(context: &Context<'_>, stage: &dyn Stage) -> Option<f64> {
    let stride = context.inputs.len().div_ceil(ROWS).max(1);
    let keep: Vec<usize> = (0..context.inputs.len()).step_by(stride).collect();
    let inputs = context.inputs.select(&keep);
    let values = context.simulator.centre();
    let without = context.simulator.respond(&values, &inputs, &[]).ok()?;
    let with = context.simulator.respond(&values, &inputs, &[stage]).ok()?;
    Some(deviation(&with.iter().zip(&without).map(|(a, b)| a - b).collect::<Vec<_>>()))
}

/// Strain of a full load at the reference temperature, the base model at the centre of its priors; 1 where no load is known or the model has no answer.
///
/// A number of the sensor, not of the rows: what is fitted on some rows means the same on others.
pub(crate) fn full_strain(context: &Context<'_>) -> f64 {
    *context.full_strain.get_or_init(|| at_full_load(context).unwrap_or(1.0))
}

fn at_full_load(context: &Context<'_>) -> Option<f64> {
    let load = context.simulator.load(context.inputs)?;
    let greatest = (0..load.len()).max_by(|a, b| load[*a].total_cmp(&load[*b])).filter(|row| load[*row] > 0.0)?;
    let mut inputs = context.inputs.select(&[greatest]);
    let to_full = |column: &mut Option<Vec<f64>>| column.iter_mut().flatten().for_each(|v| *v /= load[greatest]);
    to_full(&mut inputs.force_n);
    to_full(&mut inputs.pressure_pa);
    inputs.temperature_c.iter_mut().flatten().for_each(|t| *t = context.reference_c);
    let seen = Seen::default();
    context.simulator.respond(&context.simulator.centre(), &inputs, &[&seen]).ok()?;
    let seen = *seen.0.lock().ok()?;
    seen.filter(|strain| *strain > 0.0)
}

/// Response of the base model, at the centre of its priors, in the row where least load acts; 0 where no load is known or the model has no answer.
pub(crate) fn unloaded(context: &Context<'_>) -> f64 {
    *context.unloaded.get_or_init(|| at_least_load(context).unwrap_or(0.0))
}

fn at_least_load(context: &Context<'_>) -> Option<f64> {
    let load = context.simulator.load(context.inputs)?;
    let least = (0..load.len()).min_by(|a, b| load[*a].abs().total_cmp(&load[*b].abs()))?;
    let answer = context.simulator.respond(&context.simulator.centre(), &context.inputs.select(&[least]), &[]).ok()?;
    answer.first().copied()
}

/// Looks at the strain of the last row and changes nothing.
#[derive(Default)]
struct Seen(Mutex<Option<f64>>);

impl Stage for Seen {
    fn strain(&self, _: &Drive<'_>, strain: &mut [f64]) {
        if let Ok(mut seen) = self.0.lock() {
            *seen = strain.last().copied();
        }
    }
}
