//! The mesh itself: corners, triangles, regions and named edges.
//!
//! Holds corners only; the middle nodes of quadratic elements come from `Topology` (node `points.len() + edge`).

use super::curve::Circle;
use super::error::MeshError;
use super::plane::{Point, distance, least_angle_degrees};

/// An edge that belongs to a named boundary.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct BoundaryEdge {
    /// Its corners.
    pub nodes: [u32; 2],
    /// Index into `Mesh::boundary_names`.
    pub boundary: u16,
}

/// An edge that lies on a circle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CurvedEdge {
    /// Its corners.
    pub nodes: [u32; 2],
    /// The circle.
    pub circle: Circle,
}

/// A conforming triangle mesh (coordinates in m: (r, z) or (x, y)).
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Mesh {
    /// Corners.
    pub points: Vec<Point>,
    /// Corner indices, counter-clockwise.
    pub triangles: Vec<[u32; 3]>,
    /// Region of every triangle, index into `region_names`.
    pub triangle_regions: Vec<u16>,
    /// Names of the regions.
    pub region_names: Vec<String>,
    /// Edges with a name; an edge may carry several.
    pub boundary_edges: Vec<BoundaryEdge>,
    /// Names of the boundaries.
    pub boundary_names: Vec<String>,
    /// Edges on arcs.
    pub curved_edges: Vec<CurvedEdge>,
}

/// How well shaped a mesh is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Quality {
    /// Smallest inner angle, degrees.
    pub least_angle_degrees: f64,
    /// Mean over the triangles of their smallest angle, degrees.
    pub mean_least_angle_degrees: f64,
    /// Shortest edge (m).
    pub shortest_edge: f64,
    /// Longest edge (m).
    pub longest_edge: f64,
}

impl Mesh {
    /// Corner positions of a triangle.
    #[inline]
    pub fn corners(&self, triangle: usize) -> [Point; 3] {
        self.triangles[triangle].map(|i| self.points[i as usize])
    }

    /// Index of a boundary.
    pub fn boundary(&self, name: &str) -> Result<u16, MeshError> {
        self.boundary_names
            .iter()
            .position(|n| n == name)
            .map(|i| i as u16)
            .ok_or_else(|| MeshError::UnknownBoundary { name: name.into(), known: self.boundary_names.join(", ") })
    }

    /// Corner pairs of the edges of a boundary.
    pub fn edges_of(&self, boundary: u16) -> impl Iterator<Item = [u32; 2]> + '_ {
        self.boundary_edges.iter().filter(move |e| e.boundary == boundary).map(|e| e.nodes)
    }

    /// Angles and edge lengths, straight edges assumed.
    pub fn quality(&self) -> Quality {
        let mut q = Quality {
            least_angle_degrees: f64::INFINITY,
            mean_least_angle_degrees: 0.0,
            shortest_edge: f64::INFINITY,
            longest_edge: 0.0,
        };
        for t in 0..self.triangles.len() {
            let c = self.corners(t);
            let least = least_angle_degrees(c);
            q.least_angle_degrees = q.least_angle_degrees.min(least);
            q.mean_least_angle_degrees += least / self.triangles.len() as f64;
            for k in 0..3 {
                let edge = distance(c[k], c[(k + 1) % 3]);
                q.shortest_edge = q.shortest_edge.min(edge);
                q.longest_edge = q.longest_edge.max(edge);
            }
        }
        q
    }
}
