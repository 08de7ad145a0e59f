//! Flux of a field through an edge, seen from one triangle.

use super::system::Solved;
use crate::mesh::Point;
use crate::space::{Element, P2};

/// Permittivity of the region of a triangle (F/m).
pub(super) fn permittivity(solved: &Solved, t: usize) -> f64 {
    solved.permittivity[solved.mesh.triangle_regions[t] as usize]
}

/// Reference slopes of a field given by its nodal values `u`, from those of the shapes.
pub(super) fn slope_sum(solved: &Solved, t: usize, slopes: &[[f64; 2]; 6], u: &[f64]) -> [f64; 2] {
    let nodes = &solved.nodes.triangles[t];
    (0..6).fold([0.0; 2], |s, k| {
        let u = u[nodes[k] as usize];
        [s[0] + u * slopes[k][0], s[1] + u * slopes[k][1]]
    })
}

/// ε ∇u · n of a field at a reference point of a triangle.
pub(super) fn flux(solved: &Solved, t: usize, element: &Element, reference: [f64; 2], normal: Point, u: &[f64]) -> f64 {
    let g = element.map_at(reference).gradient(slope_sum(solved, t, &P2::at(reference).1, u));
    permittivity(solved, t) * (g[0] * normal[0] + g[1] * normal[1])
}
