//! Dead loads: pressure on the undeformed outer boundary and body force.
//!
//! Per undeformed area and volume; `following` has the pressure on the deformed surface.

use super::pressure::LoadedEdge;
use super::problem::Problem;
use crate::algebra::assemble_vector;
use crate::space::{ElementDofs, Nodes, Order, P1, P2, edge_rule, triangle_rule};

/// Degree to which loads are integrated.
const DEGREE: usize = 6;

/// Forces at all unknowns (N, or N/m in planar bodies).
pub(crate) fn external_forces(problem: &Problem, nodes: &Nodes, dofs: &ElementDofs, pressures: &[LoadedEdge]) -> Vec<f64> {
    let mut force = match &problem.body_force {
        None => vec![0.0; dofs.count],
        Some(density) => body_forces(problem, nodes, dofs, density.as_ref()),
    };
    pressures.iter().filter(|edge| !edge.follows).for_each(|edge| add_pressure(problem, nodes, edge, &mut force));
    force
}

/// `int -p n . v dS`.
fn add_pressure(problem: &Problem, nodes: &Nodes, edge: &LoadedEdge, force: &mut [f64]) {
    let (t, k) = (edge.element, edge.side);
    let ends = nodes.triangles[t];
    let three = [ends[k], ends[(k + 1) % 3], ends[k + 3]];
    for (s, w) in edge_rule(DEGREE) {
        let q = nodes.element(t).edge_point(k, s);
        let (value, count) = match problem.order {
            Order::Quadratic => (q.value, 3),
            Order::Linear => ([1.0 - s, s, 0.0], 2),
        };
        let weight = -edge.pressure * w * q.speed * problem.symmetry.weight(q.at[0]);
        for i in 0..count {
            for c in 0..2 {
                force[2 * three[i] as usize + c] += weight * value[i] * q.normal[c];
            }
        }
    }
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
