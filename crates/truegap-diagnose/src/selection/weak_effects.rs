//! How far the numbers of a model may have been moved by effects too weak to be named, and by errors of the equations of those that are named.
//!
//! A calibrated number takes up part of whatever the model leaves out, so that noise and prior alone make it look better known than it is. Each effect that a model
//! does not hold acts with a small probability ([`WEAK`]). Where it acts, its size is Gaussian: so large that it stands [`VISIBLE_BY`] noise deviations out of what
//! calibration leaves of it, each with the same weight, and no larger than is physical. What the recording says of that size is Gaussian too, hence its mean square
//! is a closed form; the shift of every number for one unit of it comes from the fit. The same with the difference between the two equations of an effect that is named.
//!
//! This is the discrepancy of Kennedy & O'Hagan, J. R. Statist. Soc. B 63 (2001) 425, with the library as what is known of it beforehand: without any such knowledge it
//! is confused with the numbers (Brynjarsdottir & O'Hagan, Inverse Problems 30 (2014) 114007).
//!
//! Limits: linear about the fit; one effect at a time, their shifts added as if independent; the most probable values stay where they are.

use crate::{
    fit::{model::Model, optimum::Fit, score_test::scores},
    selection::{
        candidates::{Search, Tried},
        posterior::Selection,
        start::{small_size, with_one_more, zero_size},
        tuning::{VISIBLE_BY, WEAK},
    },
    stats::log_sum_exp,
};
use nalgebra::{Cholesky, DMatrix};

/// A size that is looked at, in prior standard deviations.
const STEP: f64 = 0.02;

/// Standard deviations of the coordinates of `tried`, with what is not named counted in beside those that are `known`.
///
/// Where the equations may be off, what speaks for an effect counts as much less as it does where effects are named: else everything that a model leaves would speak for each of them.
pub(crate) fn widened(search: &Search<'_>, selection: &Selection, tried: &Tried, known: &[f64]) -> Vec<f64> {
    let model = search.model(&tried.effects);
    let left_out = (0..search.library.len()).filter(|e| !tried.effects.contains(e) && !search.library[*e].free_form());
    let columns: Vec<Column> = left_out
        .filter_map(|e| left_out_column(search, selection, tried, e))
        .chain(of_equations(search, &model, &tried.fit))
        .collect();
    with_columns(&tried.fit, known, &columns, selection.temper)
}

/// What the reading does for one unit of a size, whitened, and the largest size that is physical.
struct Column {
    change: Vec<f64>,
    most: f64,
}

/// The standard deviations of a fit that are `known`, each widened by the shifts that these columns may have made; the log likelihood of a size counts `temper` times less.
fn with_columns(fit: &Fit, known: &[f64], columns: &[Column], temper: f64) -> Vec<f64> {
    let free: Vec<usize> = (0..fit.z.len()).filter(|i| !fit.at_limit[*i]).collect();
    let hessian = fit.hessian.select_rows(&free).select_columns(&free);
    let Some(factor) = Cholesky::new(hessian).filter(|_| !columns.is_empty() && !free.is_empty()) else { return known.to_vec() };
    let changes = DMatrix::from_fn(fit.residual.len(), columns.len(), |row, k| columns[k].change[row]);
    let seen = scores(&fit.linearised(), &changes);
    let shifts = factor.solve(&fit.jacobian.select_columns(&free).tr_mul(&changes));
    let squares: Vec<f64> = columns
        .iter()
        .enumerate()
        .map(|(k, c)| mean_square(seen.scores[k] / temper, seen.covariance[(k, k)] / temper, c.most))
        .collect();
    let mut sd = known.to_vec();
    for (own, i) in free.iter().enumerate() {
        let moved: f64 = squares.iter().enumerate().map(|(k, square)| shifts[(own, k)].powi(2) * square).sum();
        sd[*i] = (sd[*i].powi(2) + moved).sqrt();
    }
    sd
}

/// Mean square of a size with this score and variance of the score (the likelihood is `exp(score a - variance a^2 / 2)`), 0 where it does not act.
fn mean_square(score: f64, variance: f64, most: f64) -> f64 {
    if !(score.is_finite() && variance.is_finite()) {
        return 0.0;
    }
    // rounding makes little of what calibration takes up whole, and less than nothing
    let variance = variance.max(f64::MIN_POSITIVE);
    let absent = ((1.0 - WEAK).ln(), 0.0);
    let share = (WEAK / VISIBLE_BY.len() as f64).ln();
    let acting = VISIBLE_BY.map(|by| {
        let prior = (by * by / variance).min(most * most);
        let grown = 1.0 + prior * variance;
        let mean = prior * score / grown;
        (share + 0.5 * (mean * score - grown.ln()), mean * mean + prior / grown)
    });
    let all: Vec<(f64, f64)> = std::iter::once(absent).chain(acting).collect();
    let total = log_sum_exp(&all.iter().map(|(weight, _)| *weight).collect::<Vec<_>>());
    all.iter().map(|(weight, square)| (weight - total).exp() * square).sum()
}

/// The column of an effect that the model does not hold, in the shape in which it fits best beside it, or alone; that of its first start where neither was fitted.
fn left_out_column(search: &Search<'_>, selection: &Selection, tried: &Tried, effect: usize) -> Option<Column> {
    let with: Vec<usize> = tried.effects.iter().copied().chain([effect]).collect();
    let model = search.model(&with);
    let last = model.effects.len() - 1;
    let parameters = &model.parameters[model.range_of(last)];
    let fitted = |effects: &[usize]| {
        let found = selection.with(effects)?;
        let place = found.effects.iter().position(|e| *e == effect)?;
        Some(found.fit.z[search.model(&found.effects).range_of(place)][1..].to_vec())
    };
    let start = || {
        let starts = search.library[effect].starts(search.context);
        Some(parameters.iter().skip(1).zip(starts.first()?).map(|(p, v)| p.prior.z(*v)).collect())
    };
    let shape: Vec<f64> = fitted(&with).or_else(|| fitted(&[effect])).or_else(start)?;
    let (_, change) = with_one_more(&model, &tried.fit, small_size(&model, STEP), &shape, search.whitener)?;
    // what was computed beforehand is expected at its computed size, which lies that far from 0
    Some(Column { change, most: zero_size(&model, last).abs().max(1.0) })
}

/// The columns of named effects: by how much the reading changes where the equation is the sibling's.
fn of_equations(search: &Search<'_>, model: &Model<'_>, fit: &Fit) -> Vec<Column> {
    let values = model.values(&fit.z);
    let other = |index: usize| {
        let sibling = model.effects[index].sibling(&values[model.range_of(index)], search.context)?;
        let mut stages = model.stages(&fit.z);
        *stages.get_mut(index)? = sibling;
        let there = model.residual_through(&stages, &fit.z, search.whitener).ok()?;
        Some(Column { change: fit.residual.iter().zip(&there).map(|(a, b)| a - b).collect(), most: 1.0 })
    };
    (0..model.effects.len()).filter_map(other).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The closed form against quadrature over the size, prior and likelihood multiplied point by point.
    #[test]
    fn the_mean_square_of_a_size_is_that_of_its_posterior() {
        for (score, variance, most) in [(0.0, 4.0, 1.0), (5.0, 4.0, 1.0), (30.0, 100.0, 0.2), (-8.0, 9.0, 50.0)] {
            let width = |by: f64| (by / f64::sqrt(variance)).min(most);
            let normal = |a: f64, sd: f64| (-0.5 * (a / sd).powi(2)).exp() / (sd * std::f64::consts::TAU.sqrt());
            let likelihood = |a: f64| (score * a - 0.5 * variance * a * a).exp();
            let [mut mass, mut square] = [1.0 - WEAK, 0.0];
            for by in VISIBLE_BY {
                let sd = width(by);
                // ten deviations either way of the prior's and the likelihood's narrower width
                let (centre, narrow) = (score / variance * sd * sd / (sd * sd + 1.0 / variance), sd.min(variance.sqrt().recip()));
                let step = 1e-3 * narrow;
                for k in -10_000..=10_000 {
                    let a = centre + f64::from(k) * step;
                    let weight = WEAK / VISIBLE_BY.len() as f64 * normal(a, sd) * likelihood(a) * step;
                    mass += weight;
                    square += weight * a * a;
                }
            }
            approx::assert_relative_eq!(mean_square(score, variance, most), square / mass, max_relative = 1e-6);
        }
    }

    #[test]
    fn of_a_size_that_calibration_takes_up_whole_all_that_is_known_is_what_is_physical() {
        approx::assert_relative_eq!(mean_square(0.0, 0.0, 0.3), WEAK * 0.09, max_relative = 1e-12);
    }
}
