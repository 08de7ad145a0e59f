//! The outline as corners with normals: smooth where the outline bends gently, split where it has a crease.

use super::boundary::minus;
use std::collections::HashMap;

/// Cosine of 40 degrees: sharper bends of the resting outline are creases.
const CREASE: f64 = 0.766;

/// A point of the outline as seen from the edges that share its normal.
#[derive(Debug, Clone, Copy)]
pub(super) struct Corner {
    pub point: usize,
    /// Edges that the normal is averaged over.
    edges: [Option<usize>; 2],
    /// On the axis with a nearly axial normal: the surface is smooth across the axis.
    pole: bool,
}

/// Outline edges that make a surface when turned, between corners.
#[derive(Debug, Clone)]
pub(super) struct Profile {
    pub corners: Vec<Corner>,
    /// Pairs of corner indices, material on the left.
    pub edges: Vec<[usize; 2]>,
    /// The same edges as pairs of points.
    point_edges: Vec<[usize; 2]>,
}

impl Profile {
    /// `outline` without the edges on the axis; `on_axis` tells which points lie there.
    pub fn new(points: &[[f64; 2]], outline: &[[usize; 2]], on_axis: &[bool]) -> Self {
        let point_edges: Vec<[usize; 2]> = outline.iter().copied().filter(|[a, b]| !(on_axis[*a] && on_axis[*b])).collect();
        let normals: Vec<[f64; 2]> = point_edges.iter().map(|e| edge_normal(points, *e)).collect();
        let (leaving, arriving) = (only_edge(&point_edges, 0), only_edge(&point_edges, 1));
        let smooth = |point: usize| {
            let (arriving, leaving) = (*arriving.get(&point)?, *leaving.get(&point)?);
            let (arriving, leaving) = (arriving?, leaving?);
            (dot(normals[arriving], normals[leaving]) > CREASE).then_some([Some(arriving), Some(leaving)])
        };
        let mut profile = Self { corners: Vec::new(), edges: Vec::new(), point_edges: point_edges.clone() };
        let mut shared: HashMap<usize, usize> = HashMap::new();
        for (e, edge) in point_edges.iter().enumerate() {
            let ends = edge.map(|point| {
                let joined = smooth(point);
                if let (Some(_), Some(&corner)) = (joined, shared.get(&point)) {
                    return corner;
                }
                let pole = on_axis[point] && normals[e][1].abs() > CREASE;
                profile.corners.push(Corner { point, edges: joined.unwrap_or([Some(e), None]), pole });
                if joined.is_some() {
                    shared.insert(point, profile.corners.len() - 1);
                }
                profile.corners.len() - 1
            });
            profile.edges.push(ends);
        }
        profile
    }

    /// Outward unit normal (n_r, n_z) of a corner when the points lie at `points`.
    pub fn normal(&self, corner: &Corner, points: &[[f64; 2]]) -> [f64; 2] {
        let sum = corner.edges.iter().flatten().map(|&e| edge_normal(points, self.point_edges[e]));
        let [r, z] = sum.fold([0.0, 0.0], |s, n| [s[0] + n[0], s[1] + n[1]]);
        unit(if corner.pole { [0.0, z] } else { [r, z] })
    }
}

/// For each point the one edge that starts (`end` = 0) or stops (1) there; `None` where there are several.
fn only_edge(edges: &[[usize; 2]], end: usize) -> HashMap<usize, Option<usize>> {
    let mut found: HashMap<usize, Option<usize>> = HashMap::new();
    for (e, edge) in edges.iter().enumerate() {
        found.entry(edge[end]).and_modify(|one| *one = None).or_insert(Some(e));
    }
    found
}

/// Outward unit normal of an edge with the material on its left.
fn edge_normal(points: &[[f64; 2]], [a, b]: [usize; 2]) -> [f64; 2] {
    let [r, z] = minus(points[b], points[a]);
    unit([z, -r])
}

fn dot(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

/// `v` with length one; the axial direction where an edge has collapsed to a point.
fn unit(v: [f64; 2]) -> [f64; 2] {
    let length = v[0].hypot(v[1]);
    if length > 0.0 { [v[0] / length, v[1] / length] } else { [0.0, 1.0] }
}
