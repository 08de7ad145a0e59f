//! How visible an effect is: the length, in units of the noise, of what calibration cannot absorb of it.
//!
//! Limits: calibration is taken as linear about the fit.

use crate::{
    fit::optimum::Fit,
    selection::{
        candidates::{Search, Tried},
        start::{small_size, with_one_more, zero_size},
    },
};
use nalgebra::{Cholesky, DMatrix, DVector};

/// Detectability of effect number `index` in a fitted model: sqrt of what the other parameters leave of its contribution; `None` where the model has no answer
/// without the effect.
pub fn detectability(search: &Search<'_>, tried: &Tried, index: usize) -> Option<f64> {
    let model = search.model(&tried.effects);
    let mut without = tried.fit.z.clone();
    without[model.first_of(index)] = zero_size(&model, index);
    let there = model.residual(&without, search.whitener).ok()?;
    let contribution: Vec<f64> = there.iter().zip(tried.fit.residual.iter()).map(|(a, b)| a - b).collect();
    let own = model.range_of(index);
    let others: Vec<usize> = (0..tried.fit.z.len()).filter(|i| !own.contains(i)).collect();
    Some(left_over(&tried.fit, &others, &contribution).sqrt())
}

/// Squared length of `column` that the parameters `others` of a fit cannot absorb within their priors.
pub fn left_over(fit: &Fit, others: &[usize], column: &[f64]) -> f64 {
    let column = DVector::from_column_slice(column);
    let cross = fit.jacobian.tr_mul(&column);
    let n = others.len();
    let hessian = DMatrix::from_fn(n, n, |i, j| fit.hessian[(others[i], others[j])]);
    let cross = DVector::from_fn(n, |i, _| cross[others[i]]);
    let absorbed = Cholesky::new(hessian).map_or(0.0, |f| cross.dot(&f.solve(&cross)));
    (column.norm_squared() - absorbed).max(0.0)
}

/// Size of the single effect `tried` at which its detectability would be `wanted`, in its own unit, with the shape as fitted.
pub fn visible_size(search: &Search<'_>, base: &Tried, tried: &Tried, wanted: f64) -> Option<f64> {
    let model = search.model(&tried.effects);
    let first = model.first_of(0);
    let (_, column) = with_one_more(&model, &base.fit, small_size(&model, 0.01), &tried.fit.z[first + 1..], search.whitener)?;
    let all: Vec<usize> = (0..base.fit.z.len()).collect();
    let per_unit = left_over(&base.fit, &all, &column).sqrt();
    let size = wanted / per_unit * model.parameters[first].prior.slope(zero_size(&model, 0));
    (per_unit > 0.0 && size.is_finite()).then_some(size)
}
