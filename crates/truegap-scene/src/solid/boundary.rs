//! The outline of a triangulation, as directed edges with the material on their left.

use super::error::SolidError;
use std::collections::HashMap;

/// Triangles turned counter-clockwise in (r, z).
pub(super) fn oriented(layer: &str, points: &[[f64; 2]], triangles: &[[usize; 3]]) -> Result<Vec<[usize; 3]>, SolidError> {
    let turn = |(triangle, &[a, b, c]): (usize, &[usize; 3])| {
        let (u, v) = (minus(points[b], points[a]), minus(points[c], points[a]));
        let twice_area = u[0] * v[1] - u[1] * v[0];
        let longest = u[0].hypot(u[1]).max(v[0].hypot(v[1]));
        if twice_area.abs() <= 1e-14 * longest * longest {
            return Err(SolidError::FlatTriangle { layer: layer.into(), triangle });
        }
        Ok(if twice_area > 0.0 { [a, b, c] } else { [a, c, b] })
    };
    triangles.iter().enumerate().map(turn).collect()
}

/// Edges of counter-clockwise `triangles` that have no neighbour, in the order of the triangles.
pub(super) fn edges(layer: &str, triangles: &[[usize; 3]]) -> Result<Vec<[usize; 2]>, SolidError> {
    let sides = |t: &[usize; 3]| [[t[0], t[1]], [t[1], t[2]], [t[2], t[0]]];
    let mut count: HashMap<[usize; 2], u32> = HashMap::new();
    for side in triangles.iter().flat_map(sides) {
        *count.entry(side).or_default() += 1;
    }
    if let Some(([from, to], _)) = count.iter().filter(|(_, n)| **n > 1).min() {
        return Err(SolidError::Overlap { layer: layer.into(), from: *from, to: *to });
    }
    Ok(triangles.iter().flat_map(sides).filter(|[a, b]| !count.contains_key(&[*b, *a])).collect())
}

pub(super) fn minus(a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
    [a[0] - b[0], a[1] - b[1]]
}
