//! A body with its pattern and factorisation: residuals, tangents, dual problems. `load_steps` finds the equilibria.
//!
//! The residual is always formed element by element, also to refine linear solutions: for thin layers (condition
//! numbers of 1e14) an assembled matrix loses four digits that this keeps. Symbolic analysis is done once.

use super::body::Body;
use super::element::{Energy, Residual, Tables, Tangent, evaluate_points};
use super::ends::{EndCorrection, add_product, ends};
use super::error::ElasticityError;
use super::following;
use super::material::LawKind;
use super::obstacle::{Stop, stops};
use super::problem::Problem;
use super::solution::Solution;
use super::vector::{add, largest};
use crate::algebra::{Direct, Kind, Pattern, ScatterMap, assemble_vector, element_residual, for_each_element};
use nalgebra_sparse::CscMatrix;
use std::sync::Arc;
use std::time::{Duration, Instant};

/// What a solver has done so far.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Counters {
    /// Symbolic analyses.
    pub analyses: usize,
    /// Numerical factorisations.
    pub factorisations: usize,
    /// Load steps accepted.
    pub steps: usize,
    /// Load steps halved.
    pub cuts: usize,
}

/// A body with its pattern and factorisation, at a load factor.
pub struct Solver {
    pub(super) body: Arc<Body>,
    pub(super) tables: Tables,
    scatter: ScatterMap,
    matrix: CscMatrix<f64>,
    pub(super) direct: Option<Direct>,
    ends: EndCorrection,
    pub(super) state: Vec<f64>,
    pub(super) load: f64,
    pub(super) correction: f64,
    pub(super) counters: Counters,
    assembling: Duration,
    pub(super) linear: bool,
    pub(super) stops: Vec<Stop>,
    /// Contact forces of the stops (N).
    pub(super) multipliers: Vec<f64>,
}

impl Solver {
    /// Checks and numbers a problem; the body is unloaded.
    ///
    /// # Errors
    /// Everything that is wrong with the description: materials, conditions, free rigid motions.
    pub fn new(problem: Problem) -> Result<Solver, ElasticityError> {
        let begin = Instant::now();
        let body = Body::new(problem)?;
        let (matrix, scatter) = Pattern::new(&body.dofs, &body.numbering)?.into_matrix();
        let stops = stops(&body)?;
        Ok(Solver {
            assembling: begin.elapsed(),
            matrix,
            tables: Tables::new(),
            scatter,
            direct: None,
            ends: EndCorrection::default(),
            state: vec![0.0; body.dofs.count],
            load: 0.0,
            correction: 0.0,
            counters: Counters::default(),
            linear: stops.is_empty() && body.problem.materials.iter().all(|m| m.law == LawKind::Linear),
            multipliers: vec![0.0; stops.len()],
            stops,
            body: Arc::new(body),
        })
    }

    /// The body.
    pub fn body(&self) -> &Arc<Body> {
        &self.body
    }

    /// Values of all unknowns.
    pub fn state(&self) -> &[f64] {
        &self.state
    }

    /// Load factor of the present equilibrium.
    pub fn load(&self) -> f64 {
        self.load
    }

    pub(crate) fn tables(&self) -> &Tables {
        &self.tables
    }

    /// What has been done so far.
    pub fn counters(&self) -> Counters {
        self.counters
    }

    /// Wall-clock seconds spent so far on numbering, pattern and tangents; everything else is solving.
    pub fn assembling(&self) -> f64 {
        self.assembling.as_secs_f64()
    }

    /// The present equilibrium.
    pub fn solution(&self) -> Solution {
        let forces = self.residual(&self.state, self.load);
        Solution::new(
            self.body.clone(),
            self.state.clone(),
            self.load,
            forces,
            self.energy(&self.state, self.load),
            self.correction,
        )
    }

    /// Inner minus outer forces at all unknowns; reactions where displacements are prescribed.
    pub(crate) fn residual(&self, state: &[f64], load: f64) -> Vec<f64> {
        let mut forces = assemble_vector(&self.body.dofs, |e, out| {
            evaluate_points(&self.body, &self.tables, e, state, load, false, &mut Residual(out));
            following::add_residual(&self.body, e, state, load, out);
        });
        forces.iter_mut().zip(&self.body.external).for_each(|(f, x)| *f -= load * x);
        forces
    }

    /// Inner forces at the present state, the slope of the stored energy; zero where there are pressure unknowns.
    pub(crate) fn inner_forces(&self) -> Vec<f64> {
        assemble_vector(&self.body.dofs, |e, out| {
            evaluate_points(&self.body, &self.tables, e, &self.state, self.load, false, &mut Residual(out));
        })
    }

    /// Residual with the forces of obstacles: zero at all free unknowns in equilibrium.
    pub(super) fn unbalanced(&self, state: &[f64], load: f64) -> Vec<f64> {
        let mut forces = self.residual(state, load);
        for (stop, multiplier) in self.stops.iter().zip(&self.multipliers) {
            stop.add_residual(state, load, *multiplier, &mut forces);
        }
        forces
    }

    /// Force of an obstacle (index among the problem's conditions) on the body, along its coordinate (N).
    ///
    /// `Solution::reaction` adds what all obstacles do to a boundary; this tells them apart.
    pub fn obstacle_force(&self, condition: usize) -> f64 {
        let stops = self.stops.iter().zip(&self.multipliers).filter(|(s, _)| s.condition == condition);
        stops.map(|(s, m)| s.push(&self.state, self.load, *m)).sum()
    }

    /// Whether a body has obstacles.
    pub(crate) fn has_obstacles(&self) -> bool {
        !self.stops.is_empty()
    }

    /// Stored energy (J, or J/m).
    pub(crate) fn energy(&self, state: &[f64], load: f64) -> f64 {
        let mut sum = 0.0;
        for_each_element(
            self.body.dofs.elements(),
            |e| {
                let mut one = Energy(0.0);
                evaluate_points(&self.body, &self.tables, e, state, load, false, &mut one);
                one.0
            },
            |_, one| sum += one,
        );
        sum
    }

    pub(super) fn factorise(&mut self, load: f64) -> Result<(), ElasticityError> {
        let begin = Instant::now();
        let (body, tables, state) = (&self.body, &self.tables, &self.state);
        self.scatter.assemble(&mut self.matrix, |e, out| {
            evaluate_points(body, tables, e, state, load, true, &mut Tangent(out));
            following::add_tangent(body, e, state, load, out);
        });
        let offsets = self.matrix.col_offsets().to_vec();
        for (stop, multiplier) in self.stops.iter().zip(&self.multipliers) {
            // The diagonal comes first in a lower column.
            let column = self.body.numbering.rows[stop.dof] as usize;
            self.matrix.values_mut()[offsets[column]] += stop.tangent(&self.state, load, *multiplier);
        }
        self.assembling += begin.elapsed();
        if self.direct.is_none() {
            let definite = self.linear && !self.body.is_mixed();
            let kind = if definite { Kind::Llt } else { Kind::Ldlt };
            self.direct = Some(Direct::analyse(&self.matrix, kind)?);
            self.counters.analyses += 1;
        }
        if let Some(direct) = &mut self.direct {
            // Conditioning is judged by what refinement achieves, not by the probe of the assembled matrix.
            direct.factorise_unchecked(&self.matrix)?;
            self.counters.factorisations += 1;
            self.ends = EndCorrection::new(body, &ends(body, state, load), |x| direct.apply_inverse(x));
        }
        Ok(())
    }

    /// Solution of the factorised system for minus the free entries of `residual`.
    pub(super) fn descend(&mut self, residual: &[f64]) -> Vec<f64> {
        self.solve_factorised(residual, 1.0)
    }

    /// Product of the tangent at the present state (`way` 1) or of its transpose (`way` -1) with `x`, fixed unknowns included.
    pub(super) fn tangent_product(&self, x: &[f64], load: f64, way: f64) -> Vec<f64> {
        let (body, tables, state) = (&self.body, &self.tables, &self.state);
        let mut out = element_residual(&body.dofs, x, |e, out| {
            evaluate_points(body, tables, e, state, load, true, &mut Tangent(out));
            following::add_tangent(body, e, state, load, out);
        });
        add_product(&ends(body, state, load), x, way, &mut out);
        out
    }

    fn solve_factorised(&mut self, residual: &[f64], way: f64) -> Vec<f64> {
        let mut free = self.body.numbering.restrict(residual);
        free.iter_mut().for_each(|x| *x = -*x);
        if let Some(direct) = &mut self.direct {
            direct.apply_inverse(&mut free);
            self.ends.apply(&mut free, way);
        }
        let mut all = vec![0.0; self.state.len()];
        self.body.numbering.scatter(&free, &mut all);
        all
    }

    /// Solution of the transposed problem linearised about the present state, with forces `rhs` and the `prescribed` values at the
    /// fixed unknowns (zero elsewhere).
    pub(crate) fn dual(&mut self, rhs: &[f64], mut prescribed: Vec<f64>) -> Result<Vec<f64>, ElasticityError> {
        if self.direct.is_none() {
            self.factorise(self.load)?;
        }
        let mut residual = self.tangent_product(&prescribed, self.load, -1.0);
        add(&mut residual, rhs, -1.0);
        let step = self.solve_factorised(&residual, -1.0);
        add(&mut prescribed, &step, 1.0);
        Ok(prescribed)
    }

    pub(super) fn prescribe(&mut self, load: f64) {
        for (i, _) in self.body.fixed.iter().enumerate().filter(|(_, f)| **f) {
            self.state[i] = load * self.body.prescribed[i];
        }
    }

    /// Largest displacement correction over the largest displacement (at least the body's scale and the correction);
    /// infinite if not a number.
    pub(super) fn relative(&self, step: &[f64]) -> f64 {
        let u = self.body.displacements;
        let top = largest(&step[..u]);
        let below = largest(&self.state[..u]).max(self.load_scale()).max(top);
        let all_finite = step.iter().all(|x| x.is_finite());
        match (all_finite, top == 0.0) {
            (false, _) => f64::INFINITY,
            (true, true) => 0.0,
            (true, false) => top / below,
        }
    }

    fn load_scale(&self) -> f64 {
        self.body.scale * self.load.abs()
    }
}

#[cfg(test)]
mod tests;
