//! Edges of a triangle mesh and what is on either side of them.

use super::mesh::Mesh;
use super::plane::Point;
use rayon::slice::ParallelSliceMut;

/// "There is none", in tables of indices.
pub const NONE: u32 = u32::MAX;

/// Edges, numbered in the order of their (lower, higher) corners.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Topology {
    /// Corners of every edge, lower index first.
    pub edges: Vec<[u32; 2]>,
    /// The edges of every triangle: local edge k joins the corners k and k + 1 (mod 3).
    pub triangle_edges: Vec<[u32; 3]>,
    /// The one or two triangles of every edge; `NONE` where the mesh ends.
    pub edge_triangles: Vec<[u32; 2]>,
}

impl Topology {
    /// Finds the edges of a mesh.
    pub fn new(mesh: &Mesh) -> Topology {
        let mut sides: Vec<(u64, u32)> = Vec::with_capacity(3 * mesh.triangles.len());
        for (t, c) in mesh.triangles.iter().enumerate() {
            for k in 0..3 {
                sides.push((edge_key(c[k], c[(k + 1) % 3]), (3 * t + k) as u32));
            }
        }
        sides.par_sort_unstable();
        let mut topology = Topology { triangle_edges: vec![[0; 3]; mesh.triangles.len()], ..Topology::default() };
        let mut last = None;
        for (key, side) in sides {
            if last != Some(key) {
                topology.edges.push([(key >> 32) as u32, key as u32]);
                topology.edge_triangles.push([NONE; 2]);
                last = Some(key);
            }
            let edge = topology.edges.len() - 1;
            let (triangle, local) = (side / 3, (side % 3) as usize);
            topology.triangle_edges[triangle as usize][local] = edge as u32;
            let slots = &mut topology.edge_triangles[edge];
            slots[usize::from(slots[0] != NONE)] = triangle;
        }
        topology
    }

    /// Index of the edge between two corners.
    pub fn edge(&self, a: u32, b: u32) -> Option<usize> {
        self.edges.binary_search(&[a.min(b), a.max(b)]).ok()
    }

    /// Triangle and local edge of an outer edge, or `None` where two triangles meet.
    pub(crate) fn outer_side(&self, edge: usize) -> Option<(usize, usize)> {
        let [t, other] = self.edge_triangles[edge];
        (other == NONE).then(|| {
            let local = self.triangle_edges[t as usize].iter().position(|&e| e as usize == edge).unwrap_or(0);
            (t as usize, local)
        })
    }

    /// Positions of the middle nodes, one an edge: on the circle where the edge is curved (m).
    pub fn middles(&self, mesh: &Mesh) -> Vec<Point> {
        let mut middles: Vec<Point> = self
            .edges
            .iter()
            .map(|&[a, b]| {
                let (p, q) = (mesh.points[a as usize], mesh.points[b as usize]);
                [0.5 * (p[0] + q[0]), 0.5 * (p[1] + q[1])]
            })
            .collect();
        for curved in &mesh.curved_edges {
            if let Some(edge) = self.edge(curved.nodes[0], curved.nodes[1]) {
                middles[edge] = curved.circle.project(middles[edge]);
            }
        }
        middles
    }
}

/// Key by which the edge between two corners sorts.
pub(crate) fn edge_key(a: u32, b: u32) -> u64 {
    (u64::from(a.min(b)) << 32) | u64::from(a.max(b))
}
