//! Potential, field and energy density at points and at all nodes.

use super::error::ElectrostaticsError;
use super::form::energy_density;
use super::system::Solved;
use crate::mesh::{Point, plane};
use crate::space::P2;

/// The field at one place.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FieldSample {
    /// Potential (V).
    pub potential: f64,
    /// Field E = -grad V (V/m) along the first and second coordinate.
    pub field: [f64; 2],
    /// Energy density (J/m³).
    pub energy_density: f64,
}

impl Solved<'_> {
    /// Triangle and reference coordinates of a point; on an edge the triangle of lower number.
    pub(super) fn find(&self, at: Point) -> Result<(usize, [f64; 2]), ElectrostaticsError> {
        let near = |t: &usize| {
            let [a, b, c] = self.mesh.corners(*t);
            let reach = plane::distance(a, b).max(plane::distance(b, c)).max(plane::distance(c, a));
            plane::distance(a, at) <= 1.2 * reach
        };
        let candidates: Vec<usize> = (0..self.mesh.triangles.len()).filter(near).collect();
        for slack in [1e-12, 1e-6] {
            let hit = candidates.iter().find_map(|&t| self.nodes.element(t).locate(at, slack).map(|reference| (t, reference)));
            if let Some(hit) = hit {
                return Ok(hit);
            }
        }
        Err(ElectrostaticsError::PointOutside { at })
    }

    /// Potential, field and energy density at a point of the mesh.
    pub fn sample(&self, at: Point) -> Result<FieldSample, ElectrostaticsError> {
        let (t, reference) = self.find(at)?;
        Ok(self.sample_in(t, reference))
    }

    /// The same at reference coordinates of a triangle.
    pub fn sample_in(&self, triangle: usize, reference: [f64; 2]) -> FieldSample {
        let (value, slope) = P2::at(reference);
        let map = self.nodes.element(triangle).map_at(reference);
        let (mut potential, mut field) = (0.0, [0.0; 2]);
        for (k, &node) in self.nodes.triangles[triangle].iter().enumerate() {
            let u = self.potential[node as usize];
            let g = map.gradient(slope[k]);
            potential += u * value[k];
            field = [field[0] - u * g[0], field[1] - u * g[1]];
        }
        let permittivity = self.permittivity[self.mesh.triangle_regions[triangle] as usize];
        FieldSample { potential, field, energy_density: energy_density(permittivity, field) }
    }
}
