//! Newton's method with line search, and the rounds of multipliers that contact needs.
//!
//! One load step; `load_steps` cuts the steps.

use super::error::ElasticityError;
use super::solver::Solver;
use super::vector::{add, dot, largest};

/// Settings of the search for equilibrium.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct NewtonOptions {
    /// Largest relative correction at which an equilibrium is accepted.
    pub tolerance: f64,
    /// Iterations before a load step is halved.
    pub iterations: usize,
    /// First load step, as a part of the way; 1 tries the whole way at once.
    pub first_step: f64,
    /// Smallest load step, as a part of the way, before giving up.
    pub least_step: f64,
}

impl Default for NewtonOptions {
    fn default() -> Self {
        NewtonOptions { tolerance: 1e-9, iterations: 25, first_step: 1.0, least_step: 1e-4 }
    }
}

impl Solver {
    /// One load step; returns the iterations it took.
    pub(super) fn newton(&mut self, load: f64, options: &NewtonOptions) -> Result<usize, ElasticityError> {
        const ROUNDS: usize = 60;
        self.first_step(load)?;
        let mut iterations = self.equilibrate(load, options)?;
        let mut gap = self.penetration(load);
        let size = largest(&self.state[..self.body.displacements]);
        let mut rounds = 0;
        while gap > 1e-8 * size {
            if rounds == ROUNDS {
                return Err(ElasticityError::Contact { gap, rounds });
            }
            rounds += 1;
            self.multipliers = self.stops.iter().zip(&self.multipliers).map(|(s, m)| s.force(&self.state, load, *m)).collect();
            iterations = iterations.max(self.equilibrate(load, options)?);
            gap = self.penetration(load);
        }
        Ok(iterations)
    }

    /// Deepest penetration of a stop (m).
    fn penetration(&self, load: f64) -> f64 {
        self.stops.iter().map(|s| -s.gap(&self.state, load)).fold(0.0, f64::max)
    }

    /// Newton's method at fixed prescribed values and multipliers; returns the iterations it took.
    fn equilibrate(&mut self, load: f64, options: &NewtonOptions) -> Result<usize, ElasticityError> {
        let advice = self.body.advice();
        let failed = |correction| ElasticityError::NotConverged { reached: load, wanted: load, correction, advice };
        let mut correction = f64::INFINITY;
        for iteration in 1..=options.iterations {
            let residual = self.unbalanced(&self.state, load);
            self.factorise(load)?;
            let step = self.descend(&residual);
            let size = self.relative(&step);
            if !size.is_finite() {
                return Err(failed(correction));
            }
            let part = self.line_search(&step, &residual, load).ok_or(failed(size))?;
            add(&mut self.state, &step, part);
            correction = size;
            if part == 1.0 && size <= options.tolerance {
                self.correction = size;
                return Ok(iteration);
            }
        }
        Err(failed(correction))
    }

    /// Moves prescribed displacements to their new values, the inside following by the tangent of the old state.
    fn first_step(&mut self, load: f64) -> Result<(), ElasticityError> {
        let mut jump = vec![0.0; self.state.len()];
        for (i, _) in self.body.fixed.iter().enumerate().filter(|(_, f)| **f) {
            jump[i] = load * self.body.prescribed[i] - self.state[i];
        }
        if largest(&jump) == 0.0 {
            return Ok(());
        }
        self.factorise(load)?;
        let mut residual = self.unbalanced(&self.state, load);
        add(&mut residual, &self.tangent_product(&jump, load, 1.0), 1.0);
        let step = self.descend(&residual);
        add(&mut self.state, &step, 1.0);
        self.prescribe(load);
        Ok(())
    }

    /// Part of the step at which the forces along it have fallen: 1, 1/2, 1/4, ...
    fn line_search(&self, step: &[f64], residual: &[f64], load: f64) -> Option<f64> {
        let before = dot(residual, step).abs();
        let mut part = 1.0;
        let mut trial = self.state.clone();
        for _ in 0..8 {
            trial.copy_from_slice(&self.state);
            add(&mut trial, step, part);
            let along = dot(&self.unbalanced(&trial, load), step).abs();
            // Near the end rounding decides: a step that changes nothing visible is taken.
            let admissible = self.energy(&trial, load).is_finite();
            if admissible && (along <= 0.9 * before || self.relative(step) < 1e-7) {
                return Some(part);
            }
            part *= 0.5;
        }
        None
    }
}
