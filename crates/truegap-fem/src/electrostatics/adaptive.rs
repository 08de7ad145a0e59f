//! Solve, estimate, refine - until every named output is as accurate as asked.

use super::error::ElectrostaticsError;
use super::goals::{Quantity, judge};
use super::problem::Problem;
use super::system::{Seconds, Solved};
use crate::error::FemError;
use crate::goal::{Answer, Judged};
use crate::mesh::Mesh;
use crate::mesh::{bisect_repeatedly, longest_edge_first, mark_largest};
use crate::space::Order;
use std::time::Instant;

/// How accurate, and at what cost at most.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Accuracy {
    /// Relative error wanted in every output.
    pub target: f64,
    /// Share of the estimated error that the halved triangles carry, 0 to 1.
    pub bulk: f64,
    /// Unknowns at which to give up.
    pub max_unknowns: usize,
    /// Shapes; linear ones are for comparison.
    pub order: Order,
}

impl Default for Accuracy {
    fn default() -> Self {
        Accuracy { target: 1e-4, bulk: 0.75, max_unknowns: 2_000_000, order: Order::Quadratic }
    }
}

/// What came out.
#[derive(Debug, Clone, PartialEq)]
pub struct Outcome {
    /// The outputs, in the order asked for.
    pub answers: Vec<Answer>,
    /// Triangles of the last mesh.
    pub triangles: usize,
    /// Free unknowns on the last mesh.
    pub unknowns: usize,
    /// Meshes solved on.
    pub levels: usize,
    /// Largest normwise backward error of the last solves.
    pub residual: f64,
    /// Bytes of the last factorisation.
    pub factor_bytes: usize,
    /// Time spent on all levels.
    pub seconds: Seconds,
    /// Potential at the quadratic nodes of the last mesh (V).
    pub potential: Vec<f64>,
}

/// Solves once on a mesh with quadratic elements and estimates the errors.
pub fn solve_on(problem: &Problem, quantities: &[Quantity], mesh: &Mesh) -> Result<Outcome, FemError> {
    solve_on_with(problem, quantities, mesh, Order::Quadratic)
}

/// Solves once on a mesh with elements of an order and estimates the errors.
pub fn solve_on_with(problem: &Problem, quantities: &[Quantity], mesh: &Mesh, order: Order) -> Result<Outcome, FemError> {
    Ok(level(problem, quantities, mesh, order)?.1)
}

/// Refines `mesh` until the estimated relative error of every output is at most `accuracy.target`.
///
/// The last mesh is left in `mesh`.
pub fn solve_adaptive(
    problem: &Problem,
    quantities: &[Quantity],
    mesh: &mut Mesh,
    accuracy: &Accuracy,
) -> Result<Outcome, FemError> {
    longest_edge_first(mesh);
    let mut seconds = Seconds::default();
    let mut levels = 0;
    loop {
        levels += 1;
        let (judged, mut outcome, topology) = level(problem, quantities, mesh, accuracy.order)?;
        seconds.assemble += outcome.seconds.assemble;
        seconds.solve += outcome.seconds.solve;
        let worst = judged.iter().max_by(|a, b| ratio(a).total_cmp(&ratio(b)));
        let Some(worst) = worst.filter(|w| !(ratio(w) <= accuracy.target)) else {
            outcome.seconds = seconds;
            outcome.levels = levels;
            return Ok(outcome);
        };
        let not_reached = ElectrostaticsError::NotReached {
            output: worst.answer.name.clone(),
            estimate: ratio(worst),
            unknowns: outcome.unknowns,
            wanted: accuracy.target,
        };
        if outcome.unknowns > accuracy.max_unknowns || levels > 80 {
            return Err(not_reached.into());
        }
        let begin = Instant::now();
        let shares = shares(&judged, accuracy.target);
        let marked = mark_largest(&shares, accuracy.bulk);
        *mesh = bisect_repeatedly(mesh, &topology, &marked, &shares);
        seconds.mesh += begin.elapsed().as_secs_f64();
    }
}

fn ratio(j: &Judged) -> f64 {
    j.answer.error_over_scale()
}

/// Error shares of the triangles, summed over the outputs that are not accurate enough yet.
fn shares(judged: &[Judged], target: f64) -> Vec<f64> {
    let count = judged.first().map_or(0, |j| j.shares.len());
    let mut sum = vec![0.0; count];
    for j in judged.iter().filter(|j| ratio(j) > target) {
        sum.iter_mut().zip(&j.shares).for_each(|(s, x)| *s += x / j.answer.scale);
    }
    sum
}

fn level(
    problem: &Problem,
    quantities: &[Quantity],
    mesh: &Mesh,
    order: Order,
) -> Result<(Vec<Judged>, Outcome, crate::mesh::Topology), FemError> {
    let mut solved = Solved::of_order(problem, mesh, order)?;
    let begin = Instant::now();
    let judged = judge(&mut solved, quantities)?;
    let mut seconds = solved.seconds;
    seconds.solve += begin.elapsed().as_secs_f64();
    let outcome = Outcome {
        answers: judged.iter().map(|j| j.answer.clone()).collect(),
        triangles: mesh.triangles.len(),
        unknowns: solved.unknowns(),
        levels: 1,
        residual: solved.residual,
        factor_bytes: solved.memory().bytes,
        seconds,
        potential: solved.potential[..solved.nodes.points.len()].to_vec(),
    };
    Ok((judged, outcome, solved.topology))
}
