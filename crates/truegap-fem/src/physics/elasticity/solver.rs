//! Newton's method with line search and load steps; a linear body is the case that needs one factorisation.
//!
//! The residual is always formed element by element, also to refine linear solutions: for thin layers (condition
//! numbers of 1e14) an assembled matrix loses four digits that this keeps. Symbolic analysis is done once.

use super::body::Body;
use super::element::{Energy, Residual, Tables, Tangent, evaluate_points};
use super::{ElasticityError, LawKind, Problem, Solution};
use crate::assembly::{Pattern, assemble_vector, element_residual};
use crate::solve::{Direct, Kind};
use nalgebra_sparse::CscMatrix;
use std::sync::Arc;

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
    body: Arc<Body>,
    tables: Tables,
    pattern: Pattern,
    matrix: CscMatrix<f64>,
    direct: Option<Direct>,
    state: Vec<f64>,
    load: f64,
    correction: f64,
    counters: Counters,
    linear: bool,
}

impl Solver {
    /// Checks and numbers a problem; the body is unloaded.
    ///
    /// # Errors
    /// Everything that is wrong with the description: materials, conditions, free rigid motions.
    pub fn new(problem: Problem) -> Result<Solver, ElasticityError> {
        let body = Body::new(problem)?;
        let pattern = Pattern::new(&body.dofs, &body.numbering);
        Ok(Solver {
            matrix: pattern.matrix(),
            tables: Tables::new(),
            pattern,
            direct: None,
            state: vec![0.0; body.dofs.count],
            load: 0.0,
            correction: 0.0,
            counters: Counters::default(),
            linear: body.problem.materials.iter().all(|m| m.law == LawKind::Linear),
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

    /// Equilibrium under the whole load (factor 1).
    pub fn solve(&mut self) -> Result<Solution, ElasticityError> {
        self.advance(1.0, &NewtonOptions::default())
    }

    /// Equilibrium at a load factor, reached from the last one in as many steps as it takes.
    ///
    /// # Errors
    /// `NotConverged` where load steps shrink below the least; the solver then stays at the last equilibrium. Rubber
    /// bonded at a sharp rim ends so: the finer the mesh there, the earlier its corner elements fold (a disc of shape
    /// factor 0.7 at 8 % with elements of h / 200, beyond 40 % with h / 8).
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
            let (start, from) = (self.state.clone(), self.load);
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

    fn factorise(&mut self, load: f64) -> Result<(), ElasticityError> {
        let (body, tables, state) = (&self.body, &self.tables, &self.state);
        self.pattern.assemble(&mut self.matrix, |e, out| {
            evaluate_points(body, tables, e, state, load, true, &mut Tangent(out));
        });
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
    fn descend(&mut self, residual: &[f64]) -> Vec<f64> {
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

    fn prescribe(&mut self, load: f64) {
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

    /// Largest displacement correction over the largest displacement (at least the body's scale); infinite if not a
    /// number.
    fn relative(&self, step: &[f64]) -> f64 {
        let u = self.body.displacements;
        let top = largest(&step[..u]);
        let below = largest(&self.state[..u]).max(self.load_scale());
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

    /// One load step; returns the iterations it took.
    fn newton(&mut self, load: f64, options: &NewtonOptions) -> Result<usize, ElasticityError> {
        self.first_step(load)?;
        let failed = |correction| ElasticityError::NotConverged { reached: load, wanted: load, correction };
        let mut correction = f64::INFINITY;
        for iteration in 1..=options.iterations {
            let residual = self.residual(&self.state, load);
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
        let (body, tables, state) = (&self.body, &self.tables, &self.state);
        let mut residual = self.residual(state, load);
        let follow = element_residual(&body.dofs, &jump, |e, out| {
            evaluate_points(body, tables, e, state, load, true, &mut Tangent(out));
        });
        add(&mut residual, &follow, 1.0);
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
            let along = dot(&self.residual(&trial, load), step).abs();
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

fn add(a: &mut [f64], b: &[f64], factor: f64) {
    a.iter_mut().zip(b).for_each(|(a, b)| *a += factor * b);
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

fn largest(x: &[f64]) -> f64 {
    x.iter().fold(0.0, |m, v| m.max(v.abs()))
}
