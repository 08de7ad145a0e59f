//! Named outputs of an elastic problem: their values, and the error estimate of each.
//!
//! Energies, reactions and displacements at a point by their dual problems; stresses and strains likewise for the fit
//! they come from, or by the difference of two fits where that is larger. The dual of a point value is singular there: its estimate may be up
//! to seven times the error, on the safe side.

use super::error::ElasticityError;
use super::estimate::{FieldRef, estimate_pairs};
use super::material::Formulation;
use super::problem::{Component, Problem};
use super::solution::Solution;
use super::solver::Solver;
use crate::error::FemError;
use crate::goal::{Answer, Judged};
use crate::mesh::{Mesh, Point};
use crate::mesh::{bisect, longest_edge_first, mark_largest};
use crate::space::Order;
use crate::symmetry::Symmetry;
use std::time::Instant;

/// What is asked for.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum Goal {
    /// Stored energy (J or J/m). Its estimate is half the energy of the error, which holds where a body is driven by
    /// dead forces alone, or by displacements and heat alone; under a following pressure it is that of the dual problem.
    Energy,
    /// Force of the supports on a boundary (N or N/m).
    Reaction {
        /// The boundary.
        boundary: String,
        /// The component.
        component: Component,
    },
    /// Displacement at a point (m).
    Displacement {
        /// Where (m).
        at: Point,
        /// The component.
        component: Component,
    },
    /// Cauchy stress at a point (Pa).
    Stress {
        /// Where (m).
        at: Point,
        /// `rr`, `zz`, `tt` or `rz` (planar: `xx`, `yy`, `xy`).
        component: String,
    },
    /// Strain at a point.
    Strain {
        /// Where (m).
        at: Point,
        /// As for stress.
        component: String,
    },
}

/// A named goal.
pub type Quantity = crate::goal::Quantity<Goal>;

/// How accurate, and at what cost at most.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Accuracy {
    /// Relative error wanted in every output.
    pub target: f64,
    /// Share of the estimated error that the halved triangles carry, 0 to 1.
    pub bulk: f64,
    /// Unknowns at which to give up.
    pub max_unknowns: usize,
}

impl Default for Accuracy {
    fn default() -> Self {
        Accuracy { target: 1e-4, bulk: 0.75, max_unknowns: 1_000_000 }
    }
}

/// What came out.
#[derive(Debug, Clone)]
pub struct Outcome {
    /// The outputs, in the order asked for.
    pub answers: Vec<Answer>,
    /// The last equilibrium.
    pub solution: Solution,
    /// Meshes solved on.
    pub levels: usize,
    /// Seconds spent on meshes, and on everything else.
    pub seconds: [f64; 2],
    /// Part of the second of them that went to numbering, pattern and tangents.
    pub assembling: f64,
}

/// The local problems see 0.84 of the error at a bonded rim and 1.1 to 1.8 of it in smooth fields; raised so that a
/// target is met at rims too.
const SAFETY: f64 = 1.25;
/// Smallest part of the sum of all local magnitudes that an estimate may fall to when local errors cancel.
const CANCELLATION_FLOOR: f64 = 0.05;
/// The same for energies and reactions where there is a pressure: errors of displacement and of pressure enter the energy with opposite signs, and each is
/// estimated too roughly for their difference. Where a clamped side of nearly incompressible rubber ends in a free one, one in thirty of the magnitude was left
/// on coarse meshes, and a tenth of the error was estimated. Found on those corners, `estimates_hold_where_a_clamped_side_of_rubber_ends_in_a_free_one`.
const MIXED_FLOOR: f64 = 0.75;

/// A linear functional and what it is made of.
struct Functional {
    value: f64,
    unit: &'static str,
    scale: f64,
    /// Dual field, or `None` where the equilibrium is its own.
    dual: Option<Vec<f64>>,
    /// Whether the functional is loaded inside, by the stress of the equilibrium.
    inner: bool,
    factor: f64,
    /// Error of evaluation, beside that of the solution.
    extra: f64,
    /// Part of the sum of local magnitudes below which the estimate may not fall.
    floor: f64,
}

/// Solves once and estimates the errors.
///
/// # Errors
/// `EstimateNeedsQuadratic` for linear elements, and those of the solver.
pub fn solve_goals(problem: &Problem, quantities: &[Quantity]) -> Result<Outcome, FemError> {
    Ok(level(problem, quantities)?.0)
}

/// Refines the mesh of `problem` until the estimated relative error of every output is at most `accuracy.target`.
///
/// # Errors
/// `NotReached` at `accuracy.max_unknowns`; as [`solve_goals`].
pub fn solve_goals_adaptive(problem: &mut Problem, quantities: &[Quantity], accuracy: &Accuracy) -> Result<Outcome, FemError> {
    longest_edge_first(&mut problem.mesh);
    let (mut seconds, mut assembling) = ([0.0; 2], 0.0);
    for levels in 1.. {
        let (mut outcome, judged) = level(problem, quantities)?;
        seconds[1] += outcome.seconds[1];
        assembling += outcome.assembling;
        let worst = judged.iter().max_by(|a, b| ratio(a).total_cmp(&ratio(b)));
        let Some(worst) = worst.filter(|w| !(ratio(w) <= accuracy.target)) else {
            outcome.seconds = seconds;
            outcome.assembling = assembling;
            outcome.levels = levels;
            return Ok(outcome);
        };
        let body = outcome.solution.body().clone();
        if body.numbering.free.len() > accuracy.max_unknowns || levels > 80 {
            return Err(ElasticityError::NotReached {
                output: worst.answer.name.clone(),
                estimate: ratio(worst),
                unknowns: body.numbering.free.len(),
                wanted: accuracy.target,
            }
            .into());
        }
        let begin = Instant::now();
        problem.mesh = refined(&problem.mesh, &body.topology, &judged, accuracy);
        seconds[0] += begin.elapsed().as_secs_f64();
    }
    Err(ElasticityError::IllConditioned { correction: f64::INFINITY }.into())
}

fn refined(mesh: &Mesh, topology: &crate::mesh::Topology, judged: &[Judged], accuracy: &Accuracy) -> Mesh {
    let mut sum = vec![0.0; mesh.triangles.len()];
    for j in judged.iter().filter(|j| !(ratio(j) <= accuracy.target)) {
        sum.iter_mut().zip(&j.shares).for_each(|(s, x)| *s += x / j.answer.scale);
    }
    bisect(mesh, topology, &mark_largest(&sum, accuracy.bulk)).0
}

fn ratio(j: &Judged) -> f64 {
    j.answer.error_over_scale()
}

fn level(problem: &Problem, quantities: &[Quantity]) -> Result<(Outcome, Vec<Judged>), FemError> {
    if problem.order == Order::Linear {
        return Err(ElasticityError::EstimateNeedsQuadratic.into());
    }
    let begin = Instant::now();
    let mut solver = Solver::new(problem.clone())?;
    let solution = solver.solve()?;
    let functionals = quantities.iter().map(|q| functional(&mut solver, &solution, &q.goal)).collect::<Result<Vec<_>, _>>()?;
    let mut fields = vec![FieldRef::Equilibrium];
    let mut pairs = Vec::new();
    for f in &functionals {
        pairs.push((0, if f.dual.is_some() { fields.len() } else { 0 }));
        let field = if f.inner { FieldRef::EnergyDual } else { FieldRef::Dual };
        fields.extend(f.dual.as_deref().map(field));
    }
    let parts = estimate_pairs(&solver, &fields, &pairs);
    let judged: Vec<Judged> =
        quantities.iter().zip(&functionals).zip(parts).map(|((q, f), parts)| judge(&q.name, f, &parts)).collect();
    let answers = judged.iter().map(|j| j.answer.clone()).collect();
    let seconds = [0.0, begin.elapsed().as_secs_f64()];
    Ok((Outcome { answers, solution, levels: 1, seconds, assembling: solver.assembling() }, judged))
}

fn judge(name: &str, f: &Functional, parts: &[f64]) -> Judged {
    let sum: f64 = parts.iter().sum();
    let shares: Vec<f64> = parts.iter().map(|p| (f.factor * p).abs()).collect();
    let magnitude: f64 = shares.iter().sum();
    // The two fits see the same interpolation error as the dual problem: the larger counts, not their sum.
    let error_estimate = (SAFETY * (f.factor * sum).abs().max(f.floor * magnitude)).max(f.extra);
    let answer = Answer { name: name.into(), value: f.value, unit: f.unit, error_estimate, scale: f.scale };
    Judged { answer, shares }
}

fn functional(solver: &mut Solver, s: &Solution, goal: &Goal) -> Result<Functional, ElasticityError> {
    let axisymmetric = s.body().problem.symmetry == Symmetry::Axisymmetric;
    let unit = |body, planar| if axisymmetric { body } else { planar };
    let count = s.state().len();
    let mixed = s.body().problem.materials.iter().any(|m| m.formulation == Formulation::Mixed);
    let floor = if mixed { MIXED_FLOOR } else { CANCELLATION_FLOOR };
    match goal {
        Goal::Energy if !s.body().following.is_empty() => {
            // The energy is not stationary: its slope is the inner forces.
            let dual = Some(solver.dual(&solver.inner_forces(), vec![0.0; count])?);
            let value = s.energy();
            Ok(Functional {
                value,
                unit: unit("J", "J/m"),
                scale: value.abs(),
                dual,
                inner: true,
                factor: 1.0,
                extra: 0.0,
                floor,
            })
        }
        Goal::Energy => Ok(Functional {
            value: s.energy(),
            unit: unit("J", "J/m"),
            scale: s.energy().abs(),
            dual: None,
            inner: false,
            factor: 0.5,
            extra: 0.0,
            floor,
        }),
        Goal::Reaction { boundary, component } => {
            let value = s.reaction(boundary, *component)?;
            let mut moved = vec![0.0; count];
            for n in s.body().boundary_nodes(boundary)? {
                let dof = 2 * n as usize + component.index();
                moved[dof] = f64::from(u8::from(s.body().fixed[dof]));
            }
            if moved.iter().all(|m| *m == 0.0) {
                return Err(ElasticityError::NoSupport { boundary: boundary.clone() });
            }
            let dual = Some(solver.dual(&vec![0.0; count], moved)?);
            Ok(Functional {
                value,
                unit: unit("N", "N/m"),
                scale: value.abs(),
                dual,
                inner: false,
                factor: 1.0,
                extra: 0.0,
                floor,
            })
        }
        Goal::Displacement { at, component } => {
            let value = s.displacement_at(*at)?[component.index()];
            let largest = s.state()[..s.body().displacements].iter().fold(0.0f64, |m, u| m.max(u.abs()));
            let dual = Some(solver.dual(&s.displacement_weights(*at, *component)?, vec![0.0; count])?);
            Ok(Functional {
                value,
                unit: "m",
                scale: value.abs().max(1e-3 * largest),
                dual,
                inner: false,
                factor: 1.0,
                extra: 0.0,
                floor: CANCELLATION_FLOOR,
            })
        }
        Goal::Stress { at, component } => point_functional(solver, s, *at, component, true),
        Goal::Strain { at, component } => point_functional(solver, s, *at, component, false),
    }
}

fn point_functional(
    solver: &mut Solver,
    s: &Solution,
    at: Point,
    name: &str,
    stress: bool,
) -> Result<Functional, ElasticityError> {
    let tensor = s.tensor_at(at, stress)?;
    let unknown = || ElasticityError::UnknownComponent { found: name.into() };
    let value = tensor.named(name).ok_or_else(unknown)?;
    let scale = [tensor.rr, tensor.zz, tensor.tt, tensor.rz].iter().fold(0.0f64, |m, c| m.max(c.abs()));
    let (weights, spread) = s.tensor_weights(at, stress, &|t| t.named(name).unwrap_or(f64::NAN))?;
    let dual = Some(solver.dual(&weights, vec![0.0; s.state().len()])?);
    Ok(Functional {
        value,
        unit: if stress { "Pa" } else { "1" },
        scale,
        dual,
        inner: false,
        factor: 1.0,
        extra: spread,
        floor: CANCELLATION_FLOOR,
    })
}
