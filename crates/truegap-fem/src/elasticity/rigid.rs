//! Whether every part of a body is held: the rigid motions that the conditions leave free.
//!
//! Exact, and before any matrix exists: a nearly singular factorisation of a thin plate cannot be told from a free one.

use super::error::ElasticityError;
use crate::mesh::Point;
use crate::space::Nodes;
use crate::symmetry::Symmetry;
use nalgebra::Matrix3;

/// Checks that the fixed unknowns (`2 node + component`) stop every rigid motion of every connected part.
pub(crate) fn check_held(symmetry: Symmetry, nodes: &Nodes, fixed: &[bool]) -> Result<(), ElasticityError> {
    for part in parts(nodes) {
        let held: Vec<(Point, usize)> = part
            .iter()
            .flat_map(|&n| [(n, 0), (n, 1)])
            .filter(|&(n, c)| fixed[2 * n as usize + c])
            .map(|(n, c)| (nodes.points[n as usize], c))
            .collect();
        let free = match symmetry {
            Symmetry::Axisymmetric => free_axially(&held),
            Symmetry::Planar => free_in_plane(&held),
        };
        if let Some(motion) = free {
            return Err(ElasticityError::RigidMotion { at: nodes.points[part[0] as usize], motion });
        }
    }
    Ok(())
}

fn free_axially(held: &[(Point, usize)]) -> Option<&'static str> {
    (!held.iter().any(|h| h.1 == 1)).then_some("along the axis")
}

fn free_in_plane(held: &[(Point, usize)]) -> Option<&'static str> {
    let count = held.len().max(1) as f64;
    let centre = [0, 1].map(|k| held.iter().map(|h| h.0[k]).sum::<f64>() / count);
    let reach = held.iter().map(|h| (h.0[0] - centre[0]).hypot(h.0[1] - centre[1])).fold(f64::MIN_POSITIVE, f64::max);
    let mut gram = Matrix3::zeros();
    for &(p, c) in held {
        let turn = [-(p[1] - centre[1]), p[0] - centre[0]][c] / reach;
        let row = nalgebra::Vector3::new((1 - c) as f64, c as f64, turn);
        gram += row * row.transpose();
    }
    let eigen = gram.symmetric_eigen();
    let (at, least) = eigen.eigenvalues.argmin();
    if least > 1e-10 * count {
        return None;
    }
    Some(match eigen.eigenvectors.column(at).iamax() {
        0 => "along x",
        1 => "along y",
        _ => "turning in the plane",
    })
}

/// Nodes of every connected part of the mesh.
fn parts(nodes: &Nodes) -> Vec<Vec<u32>> {
    let mut parent: Vec<u32> = (0..nodes.points.len() as u32).collect();
    fn root(parent: &mut [u32], mut i: u32) -> u32 {
        while parent[i as usize] != i {
            parent[i as usize] = parent[parent[i as usize] as usize];
            i = parent[i as usize];
        }
        i
    }
    let mut used = vec![false; nodes.points.len()];
    for t in &nodes.triangles {
        let a = root(&mut parent, t[0]);
        for &n in t {
            used[n as usize] = true;
            let b = root(&mut parent, n);
            parent[b as usize] = a;
        }
    }
    let mut of = std::collections::BTreeMap::<u32, Vec<u32>>::new();
    for n in (0..nodes.points.len() as u32).filter(|&n| used[n as usize]) {
        of.entry(root(&mut parent, n)).or_default().push(n);
    }
    of.into_values().collect()
}
