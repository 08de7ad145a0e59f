//! Checks of a mesh: indices, orientation, named edges, curved edges, the axis.

use super::error::MeshError;
use super::mesh::Mesh;
use super::plane::{distance, twice_area};
use super::topology::{NONE, Topology};
use crate::space::least_jacobian;

impl Mesh {
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
                let least = least_jacobian(&nodes) / area;
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

    /// Checks that no point lies beyond the axis, as (r, z) coordinates need.
    pub(crate) fn check_axis(&self) -> Result<(), MeshError> {
        let r = self.points.iter().map(|p| p[0]).fold(f64::INFINITY, f64::min);
        if r < 0.0 { Err(MeshError::BeyondAxis { r }) } else { Ok(()) }
    }
}
