//! What the two coordinates of a mesh mean.

/// Which body a two-dimensional mesh stands for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Symmetry {
    /// Coordinates are (r, z); integrals carry 2 pi r.
    Axisymmetric,
    /// Coordinates are (x, y); integrals are per metre of depth.
    Planar,
}

impl Symmetry {
    /// Weight of a quadrature point at the first coordinate `r` (m): 2 pi r, or 1.
    #[inline]
    pub fn weight(self, r: f64) -> f64 {
        match self {
            Symmetry::Axisymmetric => std::f64::consts::TAU * r,
            Symmetry::Planar => 1.0,
        }
    }

    /// Change of the weight with the first coordinate (1/m): 2 pi, or 0.
    #[inline]
    pub fn weight_slope(self) -> f64 {
        match self {
            Symmetry::Axisymmetric => std::f64::consts::TAU,
            Symmetry::Planar => 0.0,
        }
    }
}
