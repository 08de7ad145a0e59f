//! Which edges carry a pressure, which of them follow the surface, and where a following pressure ends.
//!
//! A pressure follows where the material next to it knows large strain; a law of small strain knows one surface only.

use super::error::ElasticityError;
use super::material::LawKind;
use super::problem::{Condition, PressureLoad, Problem};
use crate::mesh::{Topology, plane::along};
use crate::space::Nodes;
use std::collections::BTreeMap;

/// An outer edge with a pressure.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct LoadedEdge {
    /// Index of the pressure among the problem's conditions.
    pub condition: usize,
    /// Element inside.
    pub element: usize,
    /// Which of its sides.
    pub side: usize,
    /// Pressure at load factor 1 (Pa).
    pub pressure: f64,
    /// Whether it follows the deformed surface.
    pub follows: bool,
}

/// A node where following pressure ends or changes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Jump {
    /// The node.
    pub node: usize,
    /// Pressure that ends there less the one that begins, travelling with the body to the left (Pa).
    pub pressure: f64,
}

/// On which surface a pressure acts, as it was solved.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Acts {
    /// On the deformed surface.
    Following,
    /// On the undeformed surface, as asked for.
    Dead,
    /// On the undeformed surface: the law is one of small strain, which does not tell the two apart.
    SmallStrain,
}

impl Acts {
    /// The word in results and case files.
    pub fn word(self) -> &'static str {
        match self {
            Acts::Following => "following",
            Acts::Dead => "dead",
            Acts::SmallStrain => "small strain",
        }
    }

    pub(crate) fn of(load: PressureLoad, law: LawKind) -> Acts {
        match (law, load) {
            (LawKind::Linear, _) => Acts::SmallStrain,
            (_, PressureLoad::Following) => Acts::Following,
            (_, PressureLoad::Dead) => Acts::Dead,
        }
    }
}

/// All edges with a pressure.
pub(crate) fn loaded_edges(problem: &Problem, topology: &Topology) -> Result<Vec<LoadedEdge>, ElasticityError> {
    let mut out = Vec::new();
    for (condition, c) in problem.conditions.iter().enumerate() {
        let Condition::Pressure { boundary, pressure, load } = c else { continue };
        let id = problem.mesh.boundary(boundary)?;
        for [a, b] in problem.mesh.edges_of(id) {
            let inside = topology.edge(a, b).and_then(|e| topology.outer_side(e));
            let Some((element, side)) = inside else {
                let [a, b] = [a, b].map(|i| problem.mesh.points[i as usize]);
                return Err(ElasticityError::PressureInside { boundary: boundary.into(), at: along(a, b, 0.5) });
            };
            let law = problem.materials[problem.mesh.triangle_regions[element] as usize].law;
            let follows = Acts::of(*load, law) == Acts::Following;
            out.push(LoadedEdge { condition, element, side, pressure: *pressure, follows });
        }
    }
    Ok(out)
}

/// Corners where following pressures do not cancel.
pub(crate) fn jumps(nodes: &Nodes, edges: &[LoadedEdge]) -> Vec<Jump> {
    let mut sum = BTreeMap::<usize, f64>::new();
    let mut largest: f64 = 0.0;
    for e in edges.iter().filter(|e| e.follows) {
        let corners = &nodes.triangles[e.element];
        *sum.entry(corners[e.side] as usize).or_default() -= e.pressure;
        *sum.entry(corners[(e.side + 1) % 3] as usize).or_default() += e.pressure;
        largest = largest.max(e.pressure.abs());
    }
    let all = sum.into_iter().map(|(node, pressure)| Jump { node, pressure });
    all.filter(|j| j.pressure.abs() > 1e-12 * largest).collect()
}
