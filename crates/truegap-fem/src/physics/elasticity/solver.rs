//! A body with its pattern and factorisation: linear solutions, load steps, residuals, dual problems.
//!
//! The residual is always formed element by element, also to refine linear solutions: for thin layers (condition
//! numbers of 1e14) an assembled matrix loses four digits that this keeps. Symbolic analysis is done once.

use super::NewtonOptions;
use super::body::Body;
use super::element::{Energy, Residual, Tables, Tangent, evaluate_points};
use super::obstacle::{Stop, stops};
use super::{ElasticityError, LawKind, Problem, Solution};
use crate::assembly::{Pattern, Places, assemble_vector, element_residual};
use crate::solve::{Direct, Kind};
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
    places: Places,
    matrix: CscMatrix<f64>,
    direct: Option<Direct>,
    pub(super) state: Vec<f64>,
    load: f64,
    pub(super) correction: f64,
    counters: Counters,
    assembling: Duration,
    linear: bool,
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
        let (matrix, places) = Pattern::new(&body.dofs, &body.numbering).into_matrix();
        let stops = stops(&body)?;
        Ok(Solver {
            assembling: begin.elapsed(),
            matrix,
            tables: Tables::new(),
            places,
            direct: None,
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

    /// Equilibrium under the whole load (factor 1).
    pub fn solve(&mut self) -> Result<Solution, ElasticityError> {
        self.advance(1.0, &NewtonOptions::default())
    }

    /// Equilibrium at a load factor, reached from the last one in as many steps as it takes.
    ///
    /// # Errors
    /// `NotConverged` where load steps shrink below the least; the solver then stays at the last equilibrium. Rubber
    /// bonded at a sharp rim ends so when its bulging side would fold through the plate (a disc of shape factor 0.7 at
    /// 11 % with elements of h / 100 at the rim): give the side obstacles at the plates.
    pub fn advance(&mut self, target: f64, options: &NewtonOptions) -> Result<Solution, ElasticityError> {
        if self.linear {
            self.solve_linear(target)?;
            return Ok(self.solution());
        }
        let way = target - self.load;
        let mut step = options.first_step;
        let mut done = 0.0;
        while done < 1.0 {
            let next = (done + step).min(1.0);
            let (start, from, held) = (self.state.clone(), self.load, self.multipliers.clone());
            let to = if next == 1.0 { target } else { target - way * (1.0 - next) };
            self.load = to;
            match self.newton(to, options) {
                Ok(iterations) => {
                    done = next;
                    self.counters.steps += 1;
                    if iterations < 8 {
                        step *= 1.5;
                    }
                }
                Err(error) => {
                    self.state = start;
                    self.load = from;
                    self.multipliers = held;
                    self.counters.cuts += 1;
                    step *= 0.5;
                    if step < options.least_step {
                        return Err(match error {
                            ElasticityError::NotConverged { correction, .. } => {
                                ElasticityError::NotConverged { reached: from, wanted: to, correction }
                            }
                            other => other,
                        });
                    }
                }
            }
        }
        Ok(self.solution())
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
        });
        forces.iter_mut().zip(&self.body.external).for_each(|(f, x)| *f -= load * x);
        forces
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
        crate::assembly::for_each_element(
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
        self.places.assemble(&mut self.matrix, |e, out| {
            evaluate_points(body, tables, e, state, load, true, &mut Tangent(out));
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
        }
        Ok(())
    }

    /// Solution of the factorised system for minus the free entries of `residual`.
    pub(super) fn descend(&mut self, residual: &[f64]) -> Vec<f64> {
        let mut free = self.body.numbering.restrict(residual);
        free.iter_mut().for_each(|x| *x = -*x);
        if let Some(direct) = &mut self.direct {
            direct.apply_inverse(&mut free);
        }
        let mut all = vec![0.0; self.state.len()];
        self.body.numbering.scatter(&free, &mut all);
        all
    }

    /// Solution of the problem linearised about the present state, with forces `rhs` and the `prescribed` values at the
    /// fixed unknowns (zero elsewhere).
    pub(crate) fn dual(&mut self, rhs: &[f64], mut prescribed: Vec<f64>) -> Result<Vec<f64>, ElasticityError> {
        if self.direct.is_none() {
            self.factorise(self.load)?;
        }
        let (body, tables, state, load) = (&self.body, &self.tables, &self.state, self.load);
        let mut residual = element_residual(&body.dofs, &prescribed, |e, out| {
            evaluate_points(body, tables, e, state, load, true, &mut Tangent(out));
        });
        add(&mut residual, rhs, -1.0);
        let step = self.descend(&residual);
        add(&mut prescribed, &step, 1.0);
        Ok(prescribed)
    }

    pub(super) fn prescribe(&mut self, load: f64) {
        for (i, _) in self.body.fixed.iter().enumerate().filter(|(_, f)| **f) {
            self.state[i] = load * self.body.prescribed[i];
        }
    }

    fn solve_linear(&mut self, load: f64) -> Result<(), ElasticityError> {
        const ALLOWED: f64 = 1e-7;
        if self.direct.is_none() {
            self.factorise(load)?;
        }
        self.load = load;
        self.prescribe(load);
        let mut last = f64::INFINITY;
        for _ in 0..8 {
            let residual = self.residual(&self.state, load);
            let step = self.descend(&residual);
            add(&mut self.state, &step, 1.0);
            let correction = self.relative(&step);
            let settled = correction < 1e-14 || (correction < 1e-9 && correction > 0.3 * last);
            last = correction;
            if settled {
                break;
            }
        }
        self.correction = last;
        if !(last < ALLOWED) {
            return Err(ElasticityError::IllConditioned { correction: last });
        }
        Ok(())
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

pub(super) fn add(a: &mut [f64], b: &[f64], factor: f64) {
    a.iter_mut().zip(b).for_each(|(a, b)| *a += factor * b);
}

pub(super) fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

pub(super) fn largest(x: &[f64]) -> f64 {
    x.iter().fold(0.0, |m, v| m.max(v.abs()))
}
