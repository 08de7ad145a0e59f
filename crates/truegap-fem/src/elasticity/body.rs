//! A problem made discrete: nodes, unknowns, prescribed values, dead loads, and where pressures follow the surface.
//!
//! Unknowns are `2 node + component`, then one pressure for each corner of each mixed region: pressure may jump
//! between regions.

use super::error::ElasticityError;
use super::loads::external_forces;
use super::material::Formulation;
use super::pressure::{Acts, Jump, LoadedEdge, jumps, loaded_edges};
use super::problem::{Component, Condition, Place, Problem};
use super::rigid::check_held;
use crate::mesh::{Point, Topology};
use crate::space::{ElementDofs, Nodes, Numbering, Order, P2};
use crate::symmetry::Symmetry;
use std::collections::HashMap;

/// A discrete elastic body.
#[derive(Debug)]
pub struct Body {
    /// What it was made of.
    pub problem: Problem,
    /// Edges of the mesh.
    pub topology: Topology,
    /// Quadratic nodes; geometry is quadratic also where displacements are linear.
    pub nodes: Nodes,
    /// Unknowns of every element.
    pub dofs: ElementDofs,
    /// Displacement unknowns; pressures follow.
    pub displacements: usize,
    /// Free unknowns.
    pub numbering: Numbering,
    /// Whether each unknown is prescribed.
    pub fixed: Vec<bool>,
    /// Prescribed values at load factor 1, zero where free (m).
    pub prescribed: Vec<f64>,
    /// Dead forces of pressure and body force at load factor 1 (N, or N/m).
    pub external: Vec<f64>,
    /// Edges with a pressure, dead or following.
    pub(crate) pressures: Vec<LoadedEdge>,
    /// Following pressures on the sides of an element, by element (Pa).
    pub(crate) following: HashMap<usize, [f64; 3]>,
    /// Nodes where a following pressure ends or changes.
    pub(crate) jumps: Vec<Jump>,
    /// Displacement that the loads at factor 1 would cause in a free bar as long as the body (m): what "small" means
    /// where supports hold the body still.
    pub scale: f64,
}

impl Body {
    /// Numbers the unknowns of a problem and checks it.
    pub fn new(problem: Problem) -> Result<Body, ElasticityError> {
        check(&problem)?;
        let topology = Topology::new(&problem.mesh);
        let nodes = Nodes::new(&problem.mesh, &topology);
        let active = match problem.order {
            Order::Linear => nodes.corners,
            Order::Quadratic => nodes.points.len(),
        };
        let dofs = unknowns(&problem, &nodes, 2 * active);
        let (fixed, prescribed) = supports(&problem, &topology, &nodes, &dofs, active)?;
        check_parts(&problem, &nodes, &fixed, active)?;
        let numbering = Numbering::new(&fixed);
        let pressures = loaded_edges(&problem, &topology)?;
        let mut following = HashMap::<usize, [f64; 3]>::new();
        for edge in pressures.iter().filter(|e| e.follows) {
            following.entry(edge.element).or_default()[edge.side] += edge.pressure;
        }
        Ok(Body {
            scale: free_displacement(&problem, &nodes),
            displacements: 2 * active,
            external: external_forces(&problem, &nodes, &dofs, &pressures),
            jumps: jumps(&nodes, &pressures),
            problem,
            topology,
            nodes,
            dofs,
            numbering,
            fixed,
            prescribed,
            pressures,
            following,
        })
    }

    /// Whether any region has pressure unknowns.
    pub(crate) fn is_mixed(&self) -> bool {
        self.dofs.count > self.displacements
    }

    /// On which surface each pressure acts: boundary, pressure at load factor 1 (Pa), and the surface, once each.
    pub fn pressures(&self) -> Vec<(String, f64, Acts)> {
        let mut out = Vec::new();
        for edge in &self.pressures {
            let Condition::Pressure { boundary, pressure, load } = &self.problem.conditions[edge.condition] else { continue };
            let region = self.problem.mesh.triangle_regions[edge.element] as usize;
            let acts = Acts::of(*load, self.problem.materials[region].law);
            let one = (boundary.clone(), *pressure, acts);
            if !out.contains(&one) {
                out.push(one);
            }
        }
        out
    }

    /// What to do where no equilibrium is found.
    pub(crate) fn advice(&self) -> &'static str {
        if !self.following.is_empty() {
            "the pressure follows the deformed surface, and a body can have a greatest pressure of this kind (a balloon): \
             look for it with less pressure, load in smaller steps, or give the pressure as a dead load on the undeformed surface"
        } else if self.pressures.is_empty() {
            "load in smaller steps, or look for an instability"
        } else {
            "the pressure is a dead load on the undeformed surface: load in smaller steps, look for an instability, or let the \
             pressure follow the surface"
        }
    }

    /// Nodes of a boundary that carry displacements, in no order, each once.
    pub fn boundary_nodes(&self, name: &str) -> Result<Vec<u32>, ElasticityError> {
        boundary_nodes(&self.problem, &self.topology, &self.nodes, name)
    }

    /// Displacement at a reference point of an element (m).
    pub(crate) fn displacement_in(&self, element: usize, reference: [f64; 2], state: &[f64]) -> [f64; 2] {
        let of = self.dofs.of(element);
        let value: Vec<f64> = match self.problem.order {
            Order::Linear => crate::space::P1::at(reference).0.to_vec(),
            Order::Quadratic => P2::at(reference).0.to_vec(),
        };
        [0, 1].map(|c| value.iter().enumerate().map(|(i, v)| v * state[of[2 * i + c] as usize]).sum())
    }
}

fn check(problem: &Problem) -> Result<(), ElasticityError> {
    let mesh = &problem.mesh;
    mesh.check()?;
    if problem.symmetry == Symmetry::Axisymmetric {
        mesh.check_axis()?;
    }
    if problem.materials.len() != mesh.region_names.len() {
        return Err(ElasticityError::MaterialCount { given: problem.materials.len(), regions: mesh.region_names.clone() });
    }
    for (material, region) in problem.materials.iter().zip(&mesh.region_names) {
        material.check(region)?;
        if material.formulation == Formulation::Mixed && problem.order == Order::Linear {
            return Err(ElasticityError::MixedNeedsQuadratic { region: region.clone() });
        }
    }
    for condition in &problem.conditions {
        let (place, value) = match condition {
            Condition::Displacement { place, value, .. } => (format!("{place:?}"), *value),
            Condition::Pressure { boundary, pressure, .. } => (boundary.clone(), *pressure),
            Condition::Obstacle { boundary, position, travel, .. } => (boundary.clone(), position + travel),
        };
        if !value.is_finite() {
            return Err(ElasticityError::Value { place, value });
        }
    }
    Ok(())
}

fn unknowns(problem: &Problem, nodes: &Nodes, displacements: usize) -> ElementDofs {
    let mesh = &problem.mesh;
    let mut pressures = HashMap::<(u16, u32), u32>::new();
    let mut lists = Vec::with_capacity(nodes.triangles.len());
    for (t, six) in nodes.triangles.iter().enumerate() {
        let mut list: Vec<u32> = six[..problem.order.nodes()].iter().flat_map(|n| [2 * n, 2 * n + 1]).collect();
        let region = mesh.triangle_regions[t];
        if problem.materials[region as usize].formulation == Formulation::Mixed {
            for &corner in &mesh.triangles[t] {
                let next = (displacements + pressures.len()) as u32;
                list.push(*pressures.entry((region, corner)).or_insert(next));
            }
        }
        lists.push(list);
    }
    let mut dofs = ElementDofs::empty(displacements + pressures.len());
    lists.iter().for_each(|l| dofs.push(l));
    dofs
}

fn boundary_nodes(problem: &Problem, topology: &Topology, nodes: &Nodes, name: &str) -> Result<Vec<u32>, ElasticityError> {
    let boundary = problem.mesh.boundary(name)?;
    let keep = match problem.order {
        Order::Linear => 2,
        Order::Quadratic => 3,
    };
    let mut found: Vec<u32> =
        problem.mesh.edges_of(boundary).filter_map(|e| nodes.edge(topology, e)).flat_map(|n| n.into_iter().take(keep)).collect();
    found.sort_unstable();
    found.dedup();
    Ok(found)
}

type Supports = (Vec<bool>, Vec<f64>);

fn supports(
    problem: &Problem,
    topology: &Topology,
    nodes: &Nodes,
    dofs: &ElementDofs,
    active: usize,
) -> Result<Supports, ElasticityError> {
    let mut fixed = vec![false; dofs.count];
    let mut value = vec![0.0; dofs.count];
    let size = extent(nodes);
    if problem.symmetry == Symmetry::Axisymmetric {
        (0..active).filter(|&n| nodes.points[n][0].abs() <= 1e-12 * size).for_each(|n| fixed[2 * n] = true);
    }
    for condition in &problem.conditions {
        let Condition::Displacement { place, component, value: wanted } = condition else {
            continue;
        };
        let held = match place {
            Place::Boundary(name) => boundary_nodes(problem, topology, nodes, name)?,
            Place::Point(at) => vec![node_at(&nodes.points[..active], *at, 1e-9 * size)?],
        };
        for n in held {
            let dof = 2 * n as usize + component.index();
            if fixed[dof] && value[dof] != *wanted {
                return Err(ElasticityError::Conflict {
                    component: match component {
                        Component::First => "first",
                        Component::Second => "second",
                    },
                    at: nodes.points[n as usize],
                    first: value[dof],
                    second: *wanted,
                });
            }
            fixed[dof] = true;
            value[dof] = *wanted;
        }
    }
    Ok((fixed, value))
}

fn check_parts(problem: &Problem, nodes: &Nodes, fixed: &[bool], active: usize) -> Result<(), ElasticityError> {
    let mut held = fixed[..2 * active].to_vec();
    held.resize(2 * nodes.points.len(), false);
    check_held(problem.symmetry, nodes, &held)
}

/// Thermal and pressure strain times the size of the body (m).
fn free_displacement(problem: &Problem, nodes: &Nodes) -> f64 {
    let heat = nodes.points.iter().map(|&p| problem.temperature.at(p).abs()).fold(0.0, f64::max);
    let push = problem.conditions.iter().map(|c| match c {
        Condition::Pressure { pressure, .. } => pressure.abs(),
        Condition::Displacement { .. } | Condition::Obstacle { .. } => 0.0,
    });
    let push = push.fold(0.0, f64::max);
    let strain = problem.materials.iter().map(|m| m.expansion.abs() * heat + push / m.young).fold(0.0, f64::max);
    strain * extent(nodes)
}

fn extent(nodes: &Nodes) -> f64 {
    nodes.points.iter().flat_map(|p| [p[0].abs(), p[1].abs()]).fold(0.0, f64::max)
}

fn node_at(points: &[Point], at: Point, slack: f64) -> Result<u32, ElasticityError> {
    points
        .iter()
        .position(|p| (p[0] - at[0]).hypot(p[1] - at[1]) <= slack)
        .map(|n| n as u32)
        .ok_or(ElasticityError::NoNode { at })
}
