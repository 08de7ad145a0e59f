//! Electrostatics: several conductors in piecewise uniform dielectrics, bounded or open to infinity.
//!
//! Charges come from energies of unit-potential fields, never from differentiated fields. Permittivities are scalar
//! and constant per region.

mod adaptive;
mod error;
mod estimate;
mod exterior;
mod fields;
mod form;
mod goals;
mod jumps;
mod order;
mod system;
mod unknowns;

pub use crate::space::Order;
pub use adaptive::{Accuracy, Outcome, solve_adaptive, solve_on, solve_on_with};
pub use error::ElectrostaticsError;
pub use estimate::{Pair, estimate_pairs};
pub use fields::FieldSample;
pub use form::{VACUUM_PERMITTIVITY, dielectric, energy_density};
pub use goals::{Answer, Goal, Quantity};
pub use system::{Seconds, Solved};

use crate::Symmetry;

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
