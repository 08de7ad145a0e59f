//! Bodies pressed by rigid plates: the travel that gives a force, what touches, and quantities with their difference
//! between meshes.
//!
//! There is no error estimate of the kind that other goals have: what is printed is the change of a quantity from mesh to
//! mesh. Meshes are refined where the local residuals of the equilibrium are largest, with touching nodes held.

use super::error::ElasticityError;
use super::estimate::{FieldRef, estimate_pairs};
use super::goals::{Accuracy, Goal, Outcome};
use super::newton::NewtonOptions;
use super::problem::Problem;
use super::solution::Solution;
use super::solver::Solver;
use super::touching::{Touching, touching};
use crate::error::FemError;
use crate::goal::Answer;
use crate::mesh::{Mesh, bisect, longest_edge_first, mark_largest};
use crate::space::Order;
use crate::symmetry::Symmetry;
use std::time::Instant;

/// A wanted quantity of a body in contact; `usize` is the obstacle's index among the problem's conditions.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum ContactGoal {
    /// Force with which the plate presses (N or N/m).
    Force(usize),
    /// Radius of the touched part of the surface (m), half way between the last node that touches and the next; axisymmetric bodies.
    Radius(usize),
    /// Largest pressure under the plate (Pa), from the recovered stress at touching nodes.
    PeakPressure(usize),
    /// Travel of the plate towards the body (m).
    Travel(usize),
    /// A quantity of any body.
    Body(Goal),
}

/// A named goal.
pub type ContactQuantity = crate::goal::Quantity<ContactGoal>;

/// A plate that presses with a given force.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Press {
    /// Its index among the problem's conditions.
    pub condition: usize,
    /// Force against the body (N or N/m).
    pub force: f64,
}

/// Solves on the mesh of `problem` and on its halves, or refines until no quantity changes by more than the target.
///
/// A quantity's error estimate is its change from the mesh before, at least a quarter of the change before that; of a
/// contact radius at least half of the distance between the last node that touches and the next.
///
/// # Errors
/// `NotReached` at `accuracy.max_unknowns`, `NoForce` where no travel gives the force, and those of the solver.
pub fn solve_contact(
    problem: &mut Problem,
    press: Option<Press>,
    quantities: &[ContactQuantity],
    accuracy: Option<&Accuracy>,
) -> Result<Outcome, FemError> {
    if problem.order == Order::Linear {
        return Err(ElasticityError::EstimateNeedsQuadratic.into());
    }
    longest_edge_first(&mut problem.mesh);
    let mut seconds = [0.0; 2];
    let (mut assembling, mut travel) = (0.0, None);
    let mut history: Vec<Vec<Value>> = Vec::new();
    for levels in 1.. {
        let begin = Instant::now();
        let mut solver = Solver::new(problem.clone())?;
        travel = match press {
            Some(press) => Some(solver.press(press, travel)?),
            None => solver.solve().map(|_| None)?,
        };
        let solution = solver.solution();
        history.push(quantities.iter().map(|q| value(&solver, &solution, &q.goal)).collect::<Result<_, _>>()?);
        let answers = answers(quantities, &history);
        assembling += solver.assembling();
        let worst = answers.iter().map(Answer::error_over_scale).fold(0.0, f64::max);
        let done = match accuracy {
            None => levels == 2,
            Some(a) => levels > 2 && worst <= a.target,
        };
        seconds[1] += begin.elapsed().as_secs_f64();
        if done {
            return Ok(Outcome { answers, solution, levels, seconds, assembling });
        }
        let unknowns = solver.body().numbering.free.len();
        if let Some(a) = accuracy.filter(|a| levels > 2 && unknowns > a.max_unknowns) {
            let output = answers.iter().find(|x| x.error_over_scale() == worst).map_or(String::new(), |x| x.name.clone());
            return Err(ElasticityError::NotReached { output, estimate: worst, unknowns, wanted: a.target }.into());
        }
        let begin = Instant::now();
        problem.mesh = finer(&solver, accuracy);
        seconds[0] += begin.elapsed().as_secs_f64();
    }
    Err(ElasticityError::IllConditioned { correction: f64::INFINITY }.into())
}

/// A value and what can be said of it on one mesh.
struct Value {
    value: f64,
    unit: &'static str,
    scale: f64,
    /// Known width of it (m), for the end of the contact between two nodes.
    width: f64,
}

fn answers(quantities: &[ContactQuantity], history: &[Vec<Value>]) -> Vec<Answer> {
    let n = history.len();
    let answer = |(i, q): (usize, &ContactQuantity)| {
        let at = |level: usize| history[level][i].value;
        let last = if n > 1 { (at(n - 1) - at(n - 2)).abs() } else { f64::INFINITY };
        let before = if n > 2 { 0.25 * (at(n - 2) - at(n - 3)).abs() } else { 0.0 };
        let v = &history[n - 1][i];
        let error_estimate = last.max(before).max(v.width);
        Answer { name: q.name.clone(), value: v.value, unit: v.unit, error_estimate, scale: v.scale }
    };
    quantities.iter().enumerate().map(answer).collect()
}

fn finer(solver: &Solver, accuracy: Option<&Accuracy>) -> Mesh {
    let body = solver.body();
    let count = body.problem.mesh.triangles.len();
    let marked = match accuracy {
        None => vec![true; count],
        Some(a) => {
            let shares: Vec<f64> =
                estimate_pairs(solver, &[FieldRef::Equilibrium], &[(0, 0)])[0].iter().map(|x| x.abs()).collect();
            mark_largest(&shares, a.bulk)
        }
    };
    bisect(&body.problem.mesh, &body.topology, &marked).0
}

fn value(solver: &Solver, s: &Solution, goal: &ContactGoal) -> Result<Value, ElasticityError> {
    let axisymmetric = s.body().problem.symmetry == Symmetry::Axisymmetric;
    let plain = |value: f64, unit| Value { value, unit, scale: value.abs(), width: 0.0 };
    let per_depth = |body, planar| if axisymmetric { body } else { planar };
    let touched = |condition: &usize| -> Result<Touching, ElasticityError> { touching(solver, s, *condition) };
    Ok(match goal {
        ContactGoal::Force(c) => plain(touched(c)?.force, per_depth("N", "N/m")),
        ContactGoal::PeakPressure(c) => plain(touched(c)?.peak_pressure, "Pa"),
        ContactGoal::Travel(c) => plain(solver.plate_travel(*c), "m"),
        ContactGoal::Radius(c) => {
            let t = touched(c)?;
            Value { width: t.half_gap, ..plain(t.radius, "m") }
        }
        ContactGoal::Body(goal) => body_value(s, goal, per_depth)?,
    })
}

fn body_value(
    s: &Solution,
    goal: &Goal,
    per_depth: impl Fn(&'static str, &'static str) -> &'static str,
) -> Result<Value, ElasticityError> {
    let plain = |value: f64, unit| Value { value, unit, scale: value.abs(), width: 0.0 };
    Ok(match goal {
        Goal::Energy => plain(s.energy(), per_depth("J", "J/m")),
        Goal::Reaction { boundary, component } => plain(s.reaction(boundary, *component)?, per_depth("N", "N/m")),
        Goal::Displacement { at, component } => {
            let value = s.displacement_at(*at)?[component.index()];
            let largest = s.state()[..s.body().displacements].iter().fold(0.0f64, |m, u| m.max(u.abs()));
            Value { scale: value.abs().max(1e-3 * largest), ..plain(value, "m") }
        }
        Goal::Stress { at, component } | Goal::Strain { at, component } => {
            let stress = matches!(goal, Goal::Stress { .. });
            let tensor = s.tensor_at(*at, stress)?;
            let unknown = || ElasticityError::UnknownComponent { found: component.clone() };
            let value = tensor.named(component).ok_or_else(unknown)?;
            let scale = [tensor.rr, tensor.zz, tensor.tt, tensor.rz].iter().fold(0.0f64, |m, c| m.max(c.abs()));
            Value { scale, ..plain(value, if stress { "Pa" } else { "1" }) }
        }
    })
}

impl Solver {
    /// Travel of a plate towards the body at load factor 1 (m).
    pub fn plate_travel(&self, condition: usize) -> f64 {
        let stop = self.stops.iter().find(|s| s.condition == condition);
        // A plate below the body moves up towards it.
        stop.map_or(0.0, |s| s.travel())
    }

    /// Lets a plate press with a force at load factor 1, and returns its travel towards the body (m); `guess` is one from
    /// elsewhere. Travel is bracketed, then found by false position (Illinois rule) to 1e-7 of the force: contact settles
    /// to 1e-8 of the displacement.
    ///
    /// # Errors
    /// `NoForce` where travels up to the size of the body do not give it; those of the solver.
    pub fn press(&mut self, press: Press, guess: Option<f64>) -> Result<f64, ElasticityError> {
        const STEPS: usize = 60;
        let size = self.body.nodes.points.iter().flat_map(|p| [p[0].abs(), p[1].abs()]).fold(0.0, f64::max);
        // Travel and force off the wanted one: too little, too much.
        let mut ends: [Option<[f64; 2]>; 2] = [Some([0.0, -press.force]), None];
        let mut travel = guess.unwrap_or(1e-4 * size);
        let mut before = None;
        for _ in 0..STEPS {
            let off = self.pressed_by(press.condition, travel)? - press.force;
            if off.abs() <= 1e-7 * press.force {
                return Ok(travel);
            }
            let side = usize::from(off > 0.0);
            ends[side] = Some([travel, off]);
            if let Some(other) = ends[1 - side].as_mut().filter(|_| before == Some(side)) {
                other[1] *= 0.5;
            }
            before = Some(side);
            travel = match ends {
                [Some(low), Some(high)] => (low[0] * high[1] - high[0] * low[1]) / (high[1] - low[1]),
                // A sphere's force grows with the power 3/2 of the travel.
                _ => travel * (press.force / (off + press.force)).powf(2.0 / 3.0).clamp(1.2, 4.0),
            };
            if !(travel < size) {
                break;
            }
        }
        Err(ElasticityError::NoForce { force: press.force, travel })
    }

    /// Force of a plate at a travel.
    fn pressed_by(&mut self, condition: usize, travel: f64) -> Result<f64, ElasticityError> {
        self.stops.iter_mut().filter(|s| s.condition == condition).for_each(|s| s.set_travel(travel));
        let options = NewtonOptions::default();
        // From the last equilibrium, or else from the unloaded body in load steps.
        if self.load != 1.0 || self.advance(1.0, &NewtonOptions { least_step: 1.0, ..options }).is_err() {
            self.state.fill(0.0);
            self.multipliers.fill(0.0);
            self.load = 0.0;
            self.advance(1.0, &options)?;
        }
        Ok(self.obstacle_force(condition).abs())
    }
}
