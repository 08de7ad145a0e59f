//! The way down to an optimum: damped Gauss-Newton steps inside bounds, each corrected until it is back where the objective is low.
//!
//! Limits: one mode; what an optimum is worth is for [`crate::fit::optimum`] to say.

use crate::{
    fit::tuning::{ACTIVE_SETS, AS_PROMISED, CHORDS, FAILED_STEPS, PINNED, REACH, STEPS_BACK},
    fit::{
        model::Model,
        optimum::{Fit, finish, gram},
        ways::Ways,
    },
    whitening::whitener::Whitener,
};
use nalgebra::{Cholesky, DMatrix, DVector};
use std::cell::OnceCell;
use truegap_core::SimulationError;

/// Numerical settings of a fit.
#[derive(Clone, Copy, Debug)]
pub struct FitOptions {
    /// most steps
    pub iterations: usize,
    /// a step that promises to lower the objective by less than this ends the search
    pub tolerance: f64,
}

impl Default for FitOptions {
    fn default() -> Self {
        Self { iterations: 20, tolerance: 0.05 }
    }
}

/// A search on its way down.
///
/// The derivatives by the parameters of the base model change little from step to step, those by the parameters of an effect much: every second step renews
/// only the latter. Nothing is called converged before all derivatives have been computed where it stands.
pub(crate) struct Descent<'a, 'm> {
    model: &'a Model<'m>,
    whitener: &'a Whitener,
    bounds: &'a [(f64, f64)],
    pub(crate) z: Vec<f64>,
    residual: Vec<f64>,
    jacobian: DMatrix<f64>,
    /// `J^T J`, where it has been computed for this Jacobian
    gram: OnceCell<DMatrix<f64>>,
    damping: f64,
    /// whether some columns were computed elsewhere
    stale: bool,
    /// first columns that may stay as they were computed elsewhere where the search ends at its first step, since its fit needs no more
    rough: usize,
    iterations: usize,
    converged: bool,
    /// where earlier searches from other starts have been
    others: Option<&'a Ways>,
    /// where it was before each of its steps, where that is asked
    pub(crate) way: Vec<Vec<f64>>,
}

impl<'a, 'm> Descent<'a, 'm> {
    pub(crate) fn at(
        model: &'a Model<'m>,
        whitener: &'a Whitener,
        start: &[f64],
        bounds: &'a [(f64, f64)],
    ) -> Result<Self, SimulationError> {
        let z = inside(start, bounds);
        let residual = model.residual(&z, whitener)?;
        let jacobian = DMatrix::zeros(residual.len(), z.len());
        Ok(Self::with(model, whitener, bounds, z, (residual, jacobian)))
    }

    /// A search that begins with its residual and its derivatives.
    pub(crate) fn with(
        model: &'a Model<'m>,
        whitener: &'a Whitener,
        bounds: &'a [(f64, f64)],
        z: Vec<f64>,
        (residual, jacobian): (Vec<f64>, DMatrix<f64>),
    ) -> Self {
        Self {
            model,
            whitener,
            bounds,
            z,
            residual,
            jacobian,
            gram: OnceCell::new(),
            damping: 1e-6,
            stale: false,
            rough: 0,
            iterations: 0,
            converged: false,
            others: None,
            way: Vec::new(),
        }
    }

    /// The same search, which ends where it comes upon the way of an earlier one.
    pub(crate) fn apart_from(self, others: &'a Ways) -> Self {
        Self { others: Some(others), ..self }
    }

    /// The same search for a model that cannot win: where its first step gains nothing, the first `columns` derivatives are good enough as they were known.
    pub(crate) fn content_with(self, columns: usize) -> Self {
        Self { rough: columns, ..self }
    }

    /// Notes where it is; whether an earlier search has been there, after as many steps or fewer: then it would only go the same way.
    pub(crate) fn comes_upon_another(&mut self) -> bool {
        let Some(others) = self.others else { return false };
        self.way.push(self.z.clone());
        others.lead_through(&self.z, self.way.len())
    }

    /// Computes the columns from `first` on anew.
    pub(crate) fn refresh(&mut self, first: usize) -> Result<(), SimulationError> {
        let columns = first..self.z.len();
        self.gram.take();
        self.model.refresh(&mut self.jacobian, columns, &self.z, &self.residual, self.whitener, self.bounds)?;
        self.stale = first > 0;
        Ok(())
    }

    /// Takes over the first columns, computes the others.
    pub(crate) fn know(&mut self, known: &DMatrix<f64>) -> Result<(), SimulationError> {
        self.jacobian.columns_mut(0, known.ncols()).copy_from(known);
        self.refresh(known.ncols())
    }

    /// One step; the gain, or `None` where no step lowers the objective.
    pub(crate) fn step(&mut self) -> Option<f64> {
        let mut damping = self.damping;
        let found = self.best_step(&mut damping);
        self.damping = damping;
        let (next, residual, gain) = found?;
        (self.z, self.residual) = (next, residual);
        Some(gain)
    }

    /// Searches to the end; `false` where it came upon the way of an earlier search and was given up there.
    pub(crate) fn run(&mut self, options: &FitOptions) -> Result<bool, SimulationError> {
        let (mut reach, mut failed) = (REACH, 0);
        while self.iterations < options.iterations && !self.converged {
            if self.comes_upon_another() {
                return Ok(false);
            }
            self.iterations += 1;
            let was_stale = self.stale;
            let promise = self.promised();
            let gain = self.step();
            if promise > options.tolerance && gain.is_none_or(|g| g < 0.5 * promise) && failed < FAILED_STEPS {
                self.refresh(0)?;
                if self.nonmonotone_step(reach)? {
                    (reach, failed) = (3.0 * reach, 0);
                    self.converged = self.promised() < options.tolerance;
                    continue;
                }
                (reach, failed) = (0.2 * reach, failed + 1);
            }
            match gain {
                None if was_stale => {
                    self.refresh(0)?;
                    self.damping = 1e-6;
                }
                None => self.converged = true,
                Some(gain) if was_stale && self.iterations == 1 && self.rough > 0 && gain < options.tolerance => {
                    self.refresh(self.rough)?;
                    self.converged = self.promised() < options.tolerance;
                    if self.converged {
                        return Ok(true);
                    }
                }
                Some(gain) if !was_stale && self.was_as_promised(gain, promise, options.tolerance) => {
                    // others may come here, too
                    if self.comes_upon_another() {
                        return Ok(false);
                    }
                    self.converged = true;
                }
                Some(gain) => {
                    let only_effects = !was_stale && gain > options.tolerance && self.model.base_count() < self.z.len();
                    self.refresh(if only_effects { self.model.base_count() } else { 0 })?;
                    self.converged = !self.stale && gain < options.tolerance && self.promised() < options.tolerance;
                }
            }
        }
        if self.stale {
            self.refresh(0)?;
        }
        Ok(true)
    }

    /// Whether a step gained what all derivatives at its start had promised, so that they still hold where it led, and promise nothing more there.
    ///
    /// Where the gain differs from the promise `p` by a part `d` of it, the gradient at the end is off by about that part, and what is left to gain is of the order of `d^2 p`.
    fn was_as_promised(&self, gain: f64, promise: f64, tolerance: f64) -> bool {
        (gain - promise).powi(2) < AS_PROMISED * tolerance * promise && self.promised() < tolerance
    }

    /// A step along a sloppy direction that is too curved for steps that may never climb: straight along it, at most `reach` in any coordinate
    /// and up, then back down, each with derivatives of its own.
    ///
    /// `true` as soon as the objective is below where they started, with all derivatives known there; `false` where it does not get there, and everything
    /// but the derivatives is as before.
    ///
    /// **Source:** steps that climb are let through as in Transtrum & Sethna, Improvements to the Levenberg-Marquardt algorithm (2012), section 5.
    fn nonmonotone_step(&mut self, reach: f64) -> Result<bool, SimulationError> {
        let (z, residual, jacobian) = (self.z.clone(), self.residual.clone(), self.jacobian.clone());
        let start = objective(self.model, &residual, &z);
        let back = std::iter::repeat_n((PINNED, f64::INFINITY), STEPS_BACK);
        for (pinned, reach) in std::iter::once((0.0, reach)).chain(back) {
            let Some(next) = self.undamped(pinned, reach) else { break };
            let Ok(there) = self.model.residual(&next, self.whitener) else { break };
            (self.z, self.residual) = (next, there);
            if self.refresh(0).is_err() {
                break;
            }
            if objective(self.model, &self.residual, &self.z) < start {
                return Ok(true);
            }
        }
        (self.z, self.residual, self.jacobian, self.stale) = (z, residual, jacobian, false);
        self.gram.take();
        Ok(false)
    }

    /// Where the step without damping leads, with `pinned` added to the curvature in every direction; shortened as a whole to `reach` in any coordinate.
    fn undamped(&self, pinned: f64, reach: f64) -> Option<Vec<f64>> {
        let (mut gram, gradient) = (self.gram().clone(), self.downhill());
        (0..self.z.len()).for_each(|i| gram[(i, i)] += pinned);
        let next = bounded_step(&gram, &gradient, &self.z, self.bounds, &self.known(), 0.0)?;
        let longest = next.iter().zip(&self.z).map(|(to, from)| (to - from).abs()).fold(0.0, f64::max);
        let share = if longest > reach { reach / longest } else { 1.0 };
        Some(next.iter().zip(&self.z).map(|(to, from)| from + share * (to - from)).collect())
    }

    /// Whether a straight step to the optimum, with all derivatives known, promises to leave less than `level`.
    pub(crate) fn promises_less_than(&self, level: f64) -> bool {
        objective(self.model, &self.residual, &self.z) - self.promised() < level
    }

    /// What a straight step to the optimum promises to lower the objective by.
    fn promised(&self) -> f64 {
        let (gram, gradient) = (self.gram(), self.downhill());
        let known = self.known();
        let Some(next) = bounded_step(gram, &gradient, &self.z, self.bounds, &known, 0.0) else { return 0.0 };
        let step = DVector::from_fn(self.z.len(), |i, _| next[i] - self.z[i]);
        let own: f64 = step.iter().zip(&known).map(|(step, curvature)| step * step * curvature).sum();
        step.dot(&gradient) - 0.5 * (step.dot(&(gram * &step)) + own)
    }

    /// `J^T J`.
    fn gram(&self) -> &DMatrix<f64> {
        self.gram.get_or_init(|| gram(&self.jacobian))
    }

    /// Gradient of the objective, downhill.
    fn downhill(&self) -> DVector<f64> {
        downhill(self.model, &self.jacobian, &self.residual, &self.z)
    }

    /// Curvature of the prior.
    fn known(&self) -> Vec<f64> {
        self.model.prior(&self.z).curvature().collect()
    }

    pub(crate) fn finish(self) -> Fit {
        let counts = (self.iterations, self.converged);
        finish(self.z, self.residual, self.jacobian, self.bounds, self.model.kinds(), counts)
    }

    /// The first damped step that lowers the objective: point, residual there, gain.
    ///
    /// Parameters that trade off against one another make a sloppy direction that is curved. A straight step along it climbs, so each step is
    /// corrected with the same Jacobian until it is down again (chord iterations), and only then judged.
    fn best_step(&self, damping: &mut f64) -> Option<(Vec<f64>, Vec<f64>, f64)> {
        let Self { model, whitener, bounds, z, residual, jacobian, .. } = self;
        let here = objective(model, residual, z);
        let known = self.known();
        for _ in 0..10 {
            let mut best: Option<(Vec<f64>, Vec<f64>, f64)> = None;
            let (mut at, mut there) = (z.clone(), residual.clone());
            for _ in 0..CHORDS {
                let gradient = downhill(model, jacobian, &there, &at);
                at = bounded_step(self.gram(), &gradient, &at, bounds, &known, *damping)?;
                let Ok(next) = model.residual(&at, whitener) else { break };
                there = next;
                let gain = here - objective(model, &there, &at);
                let before = best.as_ref().map_or(0.0, |b| b.2);
                if gain > before && gain.is_finite() {
                    best = Some((at.clone(), there.clone(), gain));
                }
                if best.is_some() && gain < before + 0.01 * before.abs() {
                    break;
                }
            }
            if best.is_some() {
                *damping = (*damping * 0.1).max(1e-9);
                return best;
            }
            *damping = (*damping * 10.0).max(1e-4);
        }
        None
    }
}

/// The point inside the bounds.
pub(crate) fn inside(z: &[f64], bounds: &[(f64, f64)]) -> Vec<f64> {
    z.iter().zip(bounds).map(|(z, b)| z.clamp(b.0, b.1)).collect()
}

/// Half the squares that a model leaves at a point, and half of what its numbers cost there.
pub(crate) fn objective(model: &Model<'_>, residual: &[f64], z: &[f64]) -> f64 {
    0.5 * (residual.iter().map(|r| r * r).sum::<f64>() + model.prior(z).penalty())
}

/// Gradient of the objective, downhill.
fn downhill(model: &Model<'_>, jacobian: &DMatrix<f64>, residual: &[f64], z: &[f64]) -> DVector<f64> {
    jacobian.tr_mul(&DVector::from_column_slice(residual)) - DVector::from_iterator(z.len(), model.prior(z).gradient())
}

/// Damped Gauss-Newton step: the lowest point of the quadratic inside the bounds.
///
/// Coordinates at a bound that the gradient holds there stay; the others are solved, up to where the first of them meets its bound. One that would rather leave its bound is set free again.
///
/// **Source:** Nocedal & Wright, Numerical Optimization, 2nd ed., algorithm 16.3 (active set), for bounds.
fn bounded_step(
    gram: &DMatrix<f64>,
    gradient: &DVector<f64>,
    z: &[f64],
    bounds: &[(f64, f64)],
    known: &[f64],
    damping: f64,
) -> Option<Vec<f64>> {
    let n = z.len();
    let mut hessian = gram.clone();
    (0..n).for_each(|i| hessian[(i, i)] += known[i] + damping * (gram[(i, i)] + known[i]));
    let mut step = DVector::zeros(n);
    let mut held: Vec<bool> = (0..n).map(|i| bounds[i].0 >= bounds[i].1 || leaves(z[i], gradient[i], bounds[i])).collect();
    for _ in 0..ACTIVE_SETS * n.max(1) {
        let free: Vec<usize> = (0..n).filter(|i| !held[*i]).collect();
        let slope = gradient - &hessian * &step;
        let part = hessian.select_rows(&free).select_columns(&free);
        let towards = Cholesky::new(part)?.solve(&slope.select_rows(&free));
        let room = |k: usize| {
            let (at, bound) = (z[free[k]] + step[free[k]], bounds[free[k]]);
            let to = if towards[k] > 0.0 { bound.1 - at } else { bound.0 - at };
            if towards[k] == 0.0 { f64::INFINITY } else { (to / towards[k]).max(0.0) }
        };
        let first = (0..free.len()).map(|k| (room(k), k)).min_by(|a, b| a.0.total_cmp(&b.0)).filter(|first| first.0 < 1.0);
        let share = first.map_or(1.0, |first| first.0);
        free.iter().enumerate().for_each(|(k, i)| step[*i] += share * towards[k]);
        if let Some((_, k)) = first {
            held[free[k]] = true;
            continue;
        }
        let slope = gradient - &hessian * &step;
        let inward = |i: usize| held[i] && bounds[i].0 < bounds[i].1 && !leaves(z[i] + step[i], slope[i], bounds[i]);
        let Some(loose) = (0..n).filter(|i| inward(*i)).max_by(|a, b| slope[*a].abs().total_cmp(&slope[*b].abs())) else { break };
        held[loose] = false;
    }
    Some((0..n).map(|i| (z[i] + step[i]).clamp(bounds[i].0, bounds[i].1)).collect())
}

/// Whether a coordinate is at a bound, up to rounding, and would leave its range along this slope, downhill.
fn leaves(at: f64, slope: f64, bound: (f64, f64)) -> bool {
    let near = 1e-12 * (1.0 + at.abs());
    (slope >= 0.0 && at >= bound.1 - near) || (slope <= 0.0 && at <= bound.0 + near)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Where a quadratic is lowest inside the bounds, by trying every point of a fine grid.
    fn on_a_grid(gram: &DMatrix<f64>, gradient: &DVector<f64>, bounds: &[(f64, f64); 2]) -> [f64; 2] {
        let at = |k: usize, i: usize| bounds[k].0 + (bounds[k].1 - bounds[k].0) * i as f64 / 400.0;
        let height = |x: &[f64; 2]| {
            let x = DVector::from_column_slice(x);
            0.5 * x.dot(&(gram * &x)) - gradient.dot(&x)
        };
        let points = (0..=400).flat_map(|i| (0..=400).map(move |j| [at(0, i), at(1, j)]));
        points.min_by(|a, b| height(a).total_cmp(&height(b))).unwrap()
    }

    /// Two numbers that trade off: the first is stopped at its bound, and then the second wants to go up, though without bounds it would go far down. Stopped where a straight step leaves the
    /// range, both stood at bounds that one of them wants to leave, and the step promised less than nothing.
    #[test]
    fn a_step_ends_where_the_quadratic_is_lowest_inside_the_bounds() {
        let gram = DMatrix::from_row_slice(2, 2, &[1.0, 0.9, 0.9, 1.0]);
        let cases = [
            ([1.0, 0.5], [(-1.0, 0.1), (0.0, 1.0)]),
            ([0.5, 1.0], [(0.0, 1.0), (-1.0, 0.1)]),
            ([1.0, -2.0], [(0.0, 0.3), (-0.2, 0.5)]),
        ];
        for (gradient, bounds) in cases {
            let gradient = DVector::from_column_slice(&gradient);
            let found = bounded_step(&gram, &gradient, &[0.0; 2], &bounds, &[0.0; 2], 0.0).unwrap();
            for (found, expected) in found.iter().zip(on_a_grid(&gram, &gradient, &bounds)) {
                // half a step of the grid
                approx::assert_abs_diff_eq!(*found, expected, epsilon = 2e-3);
            }
        }
    }

    /// A number that begins at its bound and wants to leave it stays out of nothing; one that is held between equal bounds does not move.
    #[test]
    fn a_number_leaves_a_bound_that_nothing_holds_it_at() {
        let gram = DMatrix::identity(3, 3);
        let gradient = DVector::from_column_slice(&[0.5, -0.5, 2.0]);
        let bounds = [(0.0, 1.0), (0.0, 1.0), (0.4, 0.4)];
        let found = bounded_step(&gram, &gradient, &[0.0, 0.0, 0.4], &bounds, &[0.0; 3], 0.0).unwrap();
        assert_eq!(found, [0.5, 0.0, 0.4]);
    }
}
