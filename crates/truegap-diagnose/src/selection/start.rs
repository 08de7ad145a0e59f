//! Where a fit of one more effect begins, and what is promised there.
//!
//! Limits: a promise is that of a straight step.

use crate::{
    fit::{model::Model, optimum::Fit},
    whitening::whitener::Whitener,
};

/// A starting point and what a straight step promises of it.
pub(crate) struct Start {
    /// coordinates
    pub z: Vec<f64>,
    /// what it promises to gain, or gains, log likelihood
    pub gain: f64,
}

/// Leaves the starts from launch `launch` to the `count` candidates that promise most from there.
pub(crate) fn keep_best(promising: &mut [(usize, Vec<Vec<Start>>)], launch: usize, count: usize) {
    let gain = |starts: &[Vec<Start>]| starts.get(launch).and_then(|s| s.first()).map_or(f64::NEG_INFINITY, |s| s.gain);
    let mut gains: Vec<f64> = promising.iter().map(|(_, starts)| gain(starts)).collect();
    gains.sort_by(|a, b| b.total_cmp(a));
    let Some(least) = gains.get(count).copied() else { return };
    promising.iter_mut().filter(|(_, starts)| gain(starts) <= least).for_each(|(_, starts)| {
        starts.get_mut(launch).map(Vec::clear);
    });
}

/// The bounds of a model with its coordinates from `first` on held where they are in `z`.
pub(crate) fn held_from(model: &Model<'_>, z: &[f64], first: usize) -> Vec<(f64, f64)> {
    let mut bounds = model.bounds();
    bounds.iter_mut().zip(z).skip(first).for_each(|(bound, z)| *bound = (*z, *z));
    bounds
}

/// The coordinates of `from` with the last effect of `model` behind them, in this size and shape, and the change of the whitened response for one unit of the size;
/// `None` where the model has no answer.
pub fn with_one_more(
    model: &Model<'_>,
    from: &Fit,
    size: f64,
    shape: &[f64],
    whitener: &Whitener,
) -> Option<(Vec<f64>, Vec<f64>)> {
    let zero = zero_size(model, model.effects.len() - 1);
    let mut z = from.z.clone();
    z.push(size);
    z.extend_from_slice(shape);
    let there = model.residual(&z, whitener).ok()?;
    let column = from.residual.iter().zip(&there).map(|(a, b)| (a - b) / (size - zero)).collect();
    Some((z, column))
}

/// A size `step` from none, on the side that the bounds of the last effect of `model` leave open.
pub fn small_size(model: &Model<'_>, step: f64) -> f64 {
    let last = model.effects.len() - 1;
    let zero = zero_size(model, last);
    if zero + step <= model.bounds()[model.first_of(last)].1 { zero + step } else { zero - step }
}

/// Coordinate at which the size of effect `index` is 0.
pub fn zero_size(model: &Model<'_>, index: usize) -> f64 {
    model.parameters[model.first_of(index)].prior.z(0.0)
}
