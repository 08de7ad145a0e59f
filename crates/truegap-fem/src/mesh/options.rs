//! Settings of the mesher.

use super::size::SizeField;

/// How to mesh.
#[derive(Debug, Clone, PartialEq)]
pub struct MeshOptions {
    /// Wanted edge lengths.
    pub size: SizeField,
    /// Smallest inner angle aimed at, degrees; refinement ends for certain up to about 30.
    pub least_angle_degrees: f64,
    /// Largest angle that one edge of an arc spans, degrees.
    pub arc_step_degrees: f64,
    /// Most triangles before the mesher gives up.
    pub max_triangles: usize,
}

impl Default for MeshOptions {
    fn default() -> Self {
        MeshOptions { size: SizeField::default(), least_angle_degrees: 28.0, arc_step_degrees: 10.0, max_triangles: 8_000_000 }
    }
}
