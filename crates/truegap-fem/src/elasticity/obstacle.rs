//! Frictionless contact of a boundary with rigid planes across the first or second coordinate.
//!
//! Nodes may not pass the plane; forces are found by augmented multipliers, so nothing penetrates beyond the tolerance.
//! The plane moves with the load factor. Error estimates and harmonics do not know about contact.

use super::body::Body;
use super::error::ElasticityError;
use super::problem::{Condition, Problem, Side};
use crate::symmetry::Symmetry;

/// A node that a plane may stop.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Stop {
    /// Index of the obstacle among the problem's conditions.
    pub condition: usize,
    /// Displacement unknown across the plane.
    pub dof: usize,
    /// Undeformed coordinate of the node (m).
    coordinate: f64,
    /// Coordinate of the plane without load, and its way at load factor 1 (m).
    plane: [f64; 2],
    /// +1 where the body stays above the plane, -1 below.
    sign: f64,
    /// Penalty stiffness (N/m, or N/m^2 in planar bodies).
    stiffness: f64,
}

impl Stop {
    /// Way of the plane towards the body at load factor 1 (m).
    pub fn travel(&self) -> f64 {
        self.sign * self.plane[1]
    }

    /// Sets that way.
    pub fn set_travel(&mut self, travel: f64) {
        self.plane[1] = self.sign * travel;
    }

    /// Distance of the node from the plane (m), negative if it has passed.
    pub fn gap(&self, state: &[f64], load: f64) -> f64 {
        self.sign * (self.coordinate + state[self.dof] - self.plane[0] - load * self.plane[1])
    }

    /// Force of the plane on the node, away from the plane (N), for the multiplier so far.
    pub fn force(&self, state: &[f64], load: f64, multiplier: f64) -> f64 {
        (multiplier - self.stiffness * self.gap(state, load)).max(0.0)
    }

    /// Force of the plane on the node along the coordinate (N).
    pub fn push(&self, state: &[f64], load: f64, multiplier: f64) -> f64 {
        self.sign * self.force(state, load, multiplier)
    }

    /// Adds what the plane does to the residual.
    pub(crate) fn add_residual(&self, state: &[f64], load: f64, multiplier: f64, residual: &mut [f64]) {
        residual[self.dof] -= self.push(state, load, multiplier);
    }

    /// Stiffness of the plane in its present state.
    pub(crate) fn tangent(&self, state: &[f64], load: f64, multiplier: f64) -> f64 {
        if self.force(state, load, multiplier) > 0.0 { self.stiffness } else { 0.0 }
    }
}

/// The stops of all planes of a body, prescribed unknowns left out.
pub(crate) fn stops(body: &Body) -> Result<Vec<Stop>, ElasticityError> {
    let mut out = Vec::new();
    for (index, condition) in body.problem.conditions.iter().enumerate() {
        let Condition::Obstacle { boundary, component, position, travel, side } = condition else { continue };
        let stiffness = penalty(&body.problem, &body.nodes.points);
        for n in body.boundary_nodes(boundary)? {
            let dof = 2 * n as usize + component.index();
            if !body.fixed[dof] {
                let sign = if *side == Side::Above { 1.0 } else { -1.0 };
                let coordinate = body.nodes.points[n as usize][component.index()];
                out.push(Stop { condition: index, dof, coordinate, plane: [*position, *travel], sign, stiffness });
            }
        }
    }
    Ok(out)
}

/// A thousand times the stiffness of a body of this size and of its stiffest material: each round of multipliers then
/// leaves about a thousandth of the penetration.
fn penalty(problem: &Problem, points: &[[f64; 2]]) -> f64 {
    let young = problem.materials.iter().map(|m| m.young).fold(0.0, f64::max);
    let size = points.iter().flat_map(|p| [p[0].abs(), p[1].abs()]).fold(0.0, f64::max);
    match problem.symmetry {
        Symmetry::Axisymmetric => 1e3 * young * size,
        Symmetry::Planar => 1e3 * young,
    }
}
