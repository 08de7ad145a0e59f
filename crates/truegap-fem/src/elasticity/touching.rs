//! What touches a plate: nodes, force, radius, pressure.
//!
//! The end of the contact lies between two nodes, and is known no better.

use super::error::ElasticityError;
use super::problem::{Component, Condition};
use super::solution::Solution;
use super::solver::Solver;

/// A plate and what touches it.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct Touching {
    /// Force of the plate against the body (N or N/m).
    pub force: f64,
    /// First coordinate, deformed, half way between the last node that touches and the next (m).
    pub radius: f64,
    /// Half of the distance between these two (m).
    pub half_gap: f64,
    /// Largest pressure at a touching node (Pa).
    pub peak_pressure: f64,
}

/// Looks at an obstacle (index among the problem's conditions) in an equilibrium.
pub(crate) fn touching(solver: &Solver, s: &Solution, condition: usize) -> Result<Touching, ElasticityError> {
    let body = s.body();
    let Condition::Obstacle { boundary, component, .. } = &body.problem.conditions[condition] else {
        return Ok(Touching::default());
    };
    let touches = solver.touching_nodes(condition);
    let place = |n: u32| body.nodes.points[n as usize][0] + s.nodal(n as usize)[0];
    let mut out = Touching { force: solver.obstacle_force(condition).abs(), ..Touching::default() };
    let id = body.problem.mesh.boundary(boundary)?;
    for edge in body.problem.mesh.edges_of(id) {
        let Some([a, b, middle]) = body.nodes.edge(&body.topology, edge) else { continue };
        for (one, other) in [(a, middle), (middle, b), (middle, a), (b, middle)] {
            let radius = 0.5 * (place(one) + place(other));
            if touches[one as usize] && !touches[other as usize] && radius > out.radius {
                out.radius = radius;
                out.half_gap = 0.5 * (place(other) - place(one)).abs();
            }
        }
    }
    for n in (0..touches.len()).filter(|&n| touches[n]) {
        let stress = s.stress_at(body.nodes.points[n])?;
        let normal = if *component == Component::First { stress.rr } else { stress.zz };
        out.peak_pressure = out.peak_pressure.max(-normal);
    }
    Ok(out)
}

impl Solver {
    /// Whether each node touches an obstacle (index among the problem's conditions).
    pub(crate) fn touching_nodes(&self, condition: usize) -> Vec<bool> {
        let mut out = vec![false; self.body.nodes.points.len()];
        for (stop, multiplier) in self.stops.iter().zip(&self.multipliers).filter(|(s, _)| s.condition == condition) {
            out[stop.dof / 2] = stop.force(&self.state, self.load, *multiplier) > 0.0;
        }
        out
    }

    /// Displacement unknowns that are prescribed, or stopped by an obstacle.
    pub(crate) fn held(&self) -> Vec<bool> {
        let mut out = self.body.fixed.clone();
        for (stop, multiplier) in self.stops.iter().zip(&self.multipliers) {
            out[stop.dof] |= stop.force(&self.state, self.load, *multiplier) > 0.0;
        }
        out
    }
}
