//! Dead loads: pressure on the outer boundary and body force.
//!
//! Per undeformed area and volume.

use super::error::ElasticityError;
use super::problem::{Condition, Problem};
use crate::algebra::assemble_vector;
use crate::mesh::{Topology, plane::along};
use crate::space::{ElementDofs, Nodes, Order, P1, P2, edge_rule, triangle_rule};

/// Degree to which loads are integrated.
const DEGREE: usize = 6;

/// Forces at all unknowns (N, or N/m in planar bodies).
pub(crate) fn external_forces(
    problem: &Problem,
    topology: &Topology,
    nodes: &Nodes,
    dofs: &ElementDofs,
) -> Result<Vec<f64>, ElasticityError> {
    let mut force = match &problem.body_force {
        None => vec![0.0; dofs.count],
        Some(density) => body_forces(problem, nodes, dofs, density.as_ref()),
    };
    for condition in &problem.conditions {
        if let Condition::Pressure { boundary, pressure } = condition {
            add_pressure(problem, topology, nodes, (boundary, *pressure), &mut force)?;
        }
    }
    Ok(force)
}

/// `int -p n . v dS`.
fn add_pressure(
    problem: &Problem,
    topology: &Topology,
    nodes: &Nodes,
    (boundary, pressure): (&str, f64),
    force: &mut [f64],
) -> Result<(), ElasticityError> {
    let id = problem.mesh.boundary(boundary)?;
    for [a, b] in problem.mesh.edges_of(id) {
        let side = topology.edge(a, b).and_then(|e| topology.outer_side(e));
        let Some((t, k)) = side else {
            let [a, b] = [a, b].map(|i| problem.mesh.points[i as usize]);
            return Err(ElasticityError::PressureInside { boundary: boundary.into(), at: along(a, b, 0.5) });
        };
        let ends = nodes.triangles[t];
        let three = [ends[k], ends[(k + 1) % 3], ends[k + 3]];
        for (s, w) in edge_rule(DEGREE) {
            let q = nodes.element(t).edge_point(k, s);
            let (value, count) = match problem.order {
                Order::Quadratic => (q.value, 3),
                Order::Linear => ([1.0 - s, s, 0.0], 2),
            };
            let weight = -pressure * w * q.speed * problem.symmetry.weight(q.at[0]);
            for i in 0..count {
                for c in 0..2 {
                    force[2 * three[i] as usize + c] += weight * value[i] * q.normal[c];
                }
            }
        }
    }
    Ok(())
}

fn body_forces(
    problem: &Problem,
    nodes: &Nodes,
    dofs: &ElementDofs,
    density: &(dyn Fn([f64; 2]) -> [f64; 2] + Send + Sync),
) -> Vec<f64> {
    let rule = triangle_rule(DEGREE);
    assemble_vector(dofs, |e, out| {
        for q in &rule {
            let map = nodes.element(e).map_at(q.at);
            let f = density(map.at);
            let w = q.weight * map.jacobian * problem.symmetry.weight(map.at[0]);
            let add = |out: &mut [f64], i: usize, value: f64| {
                out[2 * i] += w * value * f[0];
                out[2 * i + 1] += w * value * f[1];
            };
            match problem.order {
                Order::Linear => {
                    (0..3).for_each(|i| add(out, i, P1::at(q.at).0[i]));
                }
                Order::Quadratic => {
                    (0..6).for_each(|i| add(out, i, P2::at(q.at).0[i]));
                }
            }
        }
    })
}
