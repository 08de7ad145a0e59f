//! Temperature fields that a case can name: straight, and the two that steady heat flow makes through round walls.
//!
//! Limits: above the stress-free temperature, the same at every load.

use crate::mesh::Point;
use crate::symmetry::Symmetry;

/// A term that goes with a distance, measured in a reference radius.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RadialTerm {
    /// Factor of the term (K).
    pub amplitude: f64,
    /// Distance at which the logarithm is 0, or the inverse 1 (m).
    pub radius: f64,
}

/// Temperature above the stress-free one.
///
/// $$ T = T_0 + g \cdot x + L \ln(\rho / \rho_0) + S R_0 / R $$
///
/// | symbol | field | unit |
/// |--------|-------|------|
/// | T0, g  | `base`, `gradient` | K, K/m |
/// | L, rho0 | `logarithm` | K, m |
/// | S, R0  | `inverse` | K, m |
///
/// `rho` is the distance from the axis (planar: from the origin), `R` the distance from the origin.
///
/// **Source:** Laplace's equation: steady heat flow through a cylinder's wall goes with ln rho, through a sphere's with 1 / R.
/// **Accuracy:** exact; `walls_under_steady_heat_flow_agree_with_closed_forms` in `tests/temperature.rs` solves both.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Temperature {
    /// At the origin (K).
    pub base: f64,
    /// Along the coordinates (K/m).
    pub gradient: [f64; 2],
    /// Logarithm of the distance from the axis.
    pub logarithm: Option<RadialTerm>,
    /// Inverse of the distance from the origin.
    pub inverse: Option<RadialTerm>,
}

impl Temperature {
    /// Value at a point (K); infinite on the axis or at the origin where a term is.
    pub fn at(&self, symmetry: Symmetry, p: Point) -> f64 {
        let straight = self.base + self.gradient[0] * p[0] + self.gradient[1] * p[1];
        let distance = p[0].hypot(p[1]);
        let from_axis = match symmetry {
            Symmetry::Axisymmetric => p[0],
            Symmetry::Planar => distance,
        };
        let logarithm = self.logarithm.map_or(0.0, |t| t.amplitude * (from_axis / t.radius).ln());
        let inverse = self.inverse.map_or(0.0, |t| t.amplitude * t.radius / distance);
        straight + logarithm + inverse
    }

    /// Whether the field is a straight line in every direction.
    pub(super) fn is_linear(&self) -> bool {
        self.logarithm.is_none() && self.inverse.is_none()
    }
}
