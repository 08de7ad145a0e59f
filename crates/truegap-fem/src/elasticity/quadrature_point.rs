//! A quadrature point mapped from the reference triangle to an element.

use crate::mesh::Point;
use crate::space::{PointMap, Shape};

/// A quadrature point of an element: where, how heavy, the shapes there.
pub(crate) struct MappedQuadraturePoint<'a> {
    /// Position (m).
    pub at: Point,
    /// Quadrature weight, Jacobian and 2 pi r together.
    pub weight: f64,
    /// Displacement shapes.
    pub shapes: &'a [Shape],
    /// Pressure shapes, empty without pressure.
    pub pressures: &'a [f64],
    /// Barycentric coordinates of the point.
    pub barycentric: [f64; 3],
    /// The map there.
    pub map: PointMap,
}
