//! The way down to an optimum: damped Gauss-Newton steps inside bounds, each corrected until it is back where the objective is low.
//!
//! Limits: one mode; what an optimum is worth is for [`crate::fit::optimum`] to say.

use crate::{
    fit::tuning::{CHORDS, FAILED_STEPS, PINNED, REACH, STEPS_BACK},
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

/// Damped Gauss-Newton step; coordinates that would leave their range stop at it and the others are solved again.
fn bounded_step(
    gram: &DMatrix<f64>,
    gradient: &DVector<f64>,
    z: &[f64],
    bounds: &[(f64, f64)],
    known: &[f64],
    damping: f64,
) -> Option<Vec<f64>> {
    let n = z.len();
    let mut fixed: Vec<Option<f64>> = vec![None; n];
    for _ in 0..=n {
        let mut hessian = gram.clone();
        let mut rhs = gradient.clone();
        for i in 0..n {
            hessian[(i, i)] += known[i] + damping * (gram[(i, i)] + known[i]);
        }
        for i in 0..n {
            if let Some(step) = fixed[i] {
                (0..n).filter(|j| *j != i).for_each(|j| rhs[j] -= hessian[(j, i)] * step);
                for j in 0..n {
                    hessian[(i, j)] = 0.0;
                    hessian[(j, i)] = 0.0;
                }
                hessian[(i, i)] = 1.0;
                rhs[i] = step;
            }
        }
        let step = Cholesky::new(hessian)?.solve(&rhs);
        let mut blocked = false;
        for i in 0..n {
            let target = z[i] + step[i];
            if fixed[i].is_none() && (target < bounds[i].0 || target > bounds[i].1) {
                fixed[i] = Some(target.clamp(bounds[i].0, bounds[i].1) - z[i]);
                blocked = true;
            }
        }
        if !blocked {
            return Some((0..n).map(|i| (z[i] + step[i]).clamp(bounds[i].0, bounds[i].1)).collect());
        }
    }
    None
}
