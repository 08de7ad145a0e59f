//! The mesh itself: corners, triangles, regions and named edges, with its checks.
//!
//! Holds corners only; the middle nodes of quadratic elements come from `Topology` (node `points.len() + edge`).

use super::arrangement::Arrangement;
use super::curve::Circle;
use super::plane::{Point, along, distance, least_angle_degrees, twice_area};
use super::topology::Topology;
use super::{MeshError, NONE};

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

    /// Checks indices, orientation and that boundary edges are edges of triangles.
    pub fn check(&self) -> Result<(), MeshError> {
        self.check_indices()?;
        for t in 0..self.triangles.len() {
            let c = self.corners(t);
            let longest = (0..3).map(|k| distance(c[k], c[(k + 1) % 3])).fold(0.0, f64::max);
            let ratio = twice_area(c[0], c[1], c[2]) / (longest * longest);
            if !(ratio > 1e-9) {
                return Err(MeshError::InvertedTriangle { triangle: t, at: c[0], ratio });
            }
        }
        let topology = Topology::new(self);
        for e in &self.boundary_edges {
            if topology.edge(e.nodes[0], e.nodes[1]).is_none() {
                let boundary = self.boundary_names[e.boundary as usize].clone();
                return Err(MeshError::NotAnEdge { boundary, a: e.nodes[0] as usize, b: e.nodes[1] as usize });
            }
        }
        self.check_curves(&topology)
    }

    /// A curved edge must not fold its triangle: the Jacobian of the quadratic element stays positive at its six nodes.
    fn check_curves(&self, topology: &Topology) -> Result<(), MeshError> {
        let middles = topology.middles(self);
        for e in &self.curved_edges {
            let Some(edge) = topology.edge(e.nodes[0], e.nodes[1]) else {
                continue;
            };
            for &t in topology.edge_triangles[edge].iter().filter(|&&t| t != NONE) {
                let c = self.corners(t as usize);
                let m = topology.triangle_edges[t as usize].map(|k| middles[k as usize]);
                let nodes = [c[0], c[1], c[2], m[0], m[1], m[2]];
                let area = twice_area(c[0], c[1], c[2]);
                let least = crate::space::least_jacobian(&nodes) / area;
                if !(least > 0.05) {
                    return Err(MeshError::InvertedTriangle { triangle: t as usize, at: c[0], ratio: least });
                }
            }
        }
        Ok(())
    }

    fn check_indices(&self) -> Result<(), MeshError> {
        let bad = |what, index, refers: usize, count| Err(MeshError::BadIndex { what, index, refers, count });
        for (i, t) in self.triangles.iter().enumerate() {
            if let Some(&c) = t.iter().find(|&&c| c as usize >= self.points.len()) {
                return bad("triangle", i, c as usize, self.points.len());
            }
        }
        for (i, &r) in self.triangle_regions.iter().enumerate() {
            if r as usize >= self.region_names.len() {
                return bad("the region of triangle", i, r as usize, self.region_names.len());
            }
        }
        for (i, e) in self.boundary_edges.iter().enumerate() {
            if e.boundary as usize >= self.boundary_names.len() {
                return bad("boundary edge", i, e.boundary as usize, self.boundary_names.len());
            }
        }
        if self.triangle_regions.len() != self.triangles.len() {
            return bad("the list of triangle regions", 0, self.triangle_regions.len(), self.triangles.len());
        }
        Ok(())
    }

    /// Removes curved edges that no triangle has; a boundary edge without a triangle is an error.
    pub(crate) fn drop_foreign_edges(&mut self, drawing: &Arrangement) -> Result<(), MeshError> {
        let topology = Topology::new(self);
        let known = |n: [u32; 2]| topology.edge(n[0], n[1]).is_some();
        if let Some(e) = self.boundary_edges.iter().find(|e| !known(e.nodes)) {
            let [a, b] = e.nodes.map(|i| self.points[i as usize]);
            return Err(MeshError::BoundaryOnNothing {
                boundary: drawing.boundaries[e.boundary as usize].clone(),
                at: along(a, b, 0.5),
            });
        }
        self.curved_edges.retain(|e| known(e.nodes));
        Ok(())
    }

    /// Checks that no point lies beyond the axis, as (r, z) coordinates need.
    pub fn check_axis(&self) -> Result<(), MeshError> {
        let r = self.points.iter().map(|p| p[0]).fold(f64::INFINITY, f64::min);
        if r < 0.0 { Err(MeshError::BeyondAxis { r }) } else { Ok(()) }
    }
}
