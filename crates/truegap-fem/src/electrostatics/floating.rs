//! Parts of a drawing that no potential reaches.
//!
//! Limits: parts that share a corner are one part.

use super::error::ElectrostaticsError;
use super::problem::Problem;
use crate::mesh::Mesh;

/// Refuses a mesh of which a part touches neither a conductor nor the open boundary: its potential may be anything.
pub(super) fn check_held(problem: &Problem, mesh: &Mesh) -> Result<(), ElectrostaticsError> {
    if problem.conductors.is_empty() {
        return Ok(()); // which is refused where the conductors are looked at
    }
    let mut parent: Vec<u32> = (0..mesh.points.len() as u32).collect();
    for [a, b, c] in &mesh.triangles {
        for other in [b, c] {
            let (one, two) = (root(&mut parent, *a), root(&mut parent, *other));
            parent[one as usize] = two;
        }
    }
    let holds = |name: &String| problem.open.contains(name) || problem.conductors.iter().any(|c| c.boundary == *name);
    let holding: Vec<bool> = mesh.boundary_names.iter().map(holds).collect();
    let mut held = vec![false; mesh.points.len()];
    for edge in mesh.boundary_edges.iter().filter(|e| holding[e.boundary as usize]) {
        held[root(&mut parent, edge.nodes[0]) as usize] = true;
    }
    for (triangle, [a, ..]) in mesh.triangles.iter().enumerate() {
        if !held[root(&mut parent, *a) as usize] {
            let region = mesh.region_names[mesh.triangle_regions[triangle] as usize].clone();
            return Err(ElectrostaticsError::Floating { region, at: mesh.points[*a as usize] });
        }
    }
    Ok(())
}

/// The point that stands for the part which holds `at`.
fn root(parent: &mut [u32], mut at: u32) -> u32 {
    while parent[at as usize] != at {
        parent[at as usize] = parent[parent[at as usize] as usize];
        at = parent[at as usize];
    }
    at
}
