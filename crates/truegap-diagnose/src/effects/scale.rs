//! What effects are scaled by: the reading that one can move, where its coefficient says little to a reader, and the strain of a full load.
//!
//! Limits: the reading at the centre of the priors of the base model, on a sample of the rows; the strain at the greatest load applied.

use crate::data::context::Context;
use truegap_core::Stage;

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
    let count = keep.len() as f64;
    let change = || with.iter().zip(&without).map(|(a, b)| a - b);
    let mean = change().sum::<f64>() / count;
    Some((change().map(|c| (c - mean).powi(2)).sum::<f64>() / count).sqrt())
}

/// Strain of a full load, as it is at the greatest load applied; 1 where no load is known.
pub(crate) fn full_strain(load: &[f64], strain: &[f64]) -> f64 {
    let greatest = load.iter().zip(strain).max_by(|a, b| a.0.total_cmp(b.0));
    greatest.filter(|(load, _)| **load > 0.0).map_or(1.0, |(load, strain)| strain / load)
}
