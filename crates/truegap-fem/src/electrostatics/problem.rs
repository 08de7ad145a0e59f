//! What is solved: permittivities, conductors and open boundaries by name.

use crate::symmetry::Symmetry;

/// A boundary with a prescribed potential.
#[derive(Debug, Clone, PartialEq)]
pub struct Conductor {
    /// Name of the boundary in the mesh.
    pub boundary: String,
    /// Potential (V).
    pub potential: f64,
}

/// What is solved, independent of any mesh.
#[derive(Debug, Clone, PartialEq)]
pub struct Problem {
    /// Axisymmetric (results for the whole body) or planar (per metre of depth).
    pub symmetry: Symmetry,
    /// Permittivity of every region by name (F/m).
    pub permittivity: Vec<(String, f64)>,
    /// Conductors; where two touch, the first one owns the common node.
    pub conductors: Vec<Conductor>,
    /// Boundaries that stand for unbounded space beyond them.
    pub open: Vec<String>,
}
