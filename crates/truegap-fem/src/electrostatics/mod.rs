//! Electrostatics: several conductors in piecewise uniform dielectrics, bounded or open to infinity.
//!
//! Charges come from energies of unit-potential fields, never from differentiated fields. Permittivities are scalar
//! and constant per region.
//!
//! # Example: a guarded plate, per metre of depth
//!
//! A strip of 4 mm by 2 mm between plates, no field through its sides: `C = eps0 w / d`, exact but for rounding.
//!
//! ```
//! use truegap_fem::electrostatics::{Accuracy, Conductor, Goal, Problem, Quantity, VACUUM_PERMITTIVITY, solve_adaptive};
//! use truegap_fem::mesh::{Geometry, MeshOptions, Outline, mesh_geometry};
//! use truegap_fem::{FemError, Symmetry};
//!
//! let drawing = Geometry::default()
//!     .region("gap", Outline::rectangle([0.0, 0.0], [4e-3, 2e-3]))
//!     .boundary("top", &[[0.0, 2e-3], [4e-3, 2e-3]])
//!     .boundary("bottom", &[[0.0, 0.0], [4e-3, 0.0]]);
//! let mut mesh = mesh_geometry(&drawing, &MeshOptions::default())?;
//! let at = |boundary: &str, potential| Conductor { boundary: boundary.into(), potential };
//! let problem = Problem {
//!     symmetry: Symmetry::Planar,
//!     permittivity: vec![("gap".into(), VACUUM_PERMITTIVITY)],
//!     conductors: vec![at("top", 1.0), at("bottom", 0.0)],
//!     open: vec![],
//! };
//! let goals = [Quantity { name: "C".into(), goal: Goal::Capacitance { boundary: "top".into() } }];
//! let found = solve_adaptive(&problem, &goals, &mut mesh, &Accuracy::default())?;
//! assert!((found.answers[0].value / (2.0 * VACUUM_PERMITTIVITY) - 1.0).abs() < 1e-12);
//! # Ok::<(), FemError>(())
//! ```

mod adaptive;
mod constrained_dofs;
mod error;
mod estimate;
mod exterior;
mod fields;
mod floating;
mod flux;
mod form;
mod goals;
mod hp;
mod infinite_hp;
mod jumps;
mod problem;
mod system;
mod unknowns;

pub use crate::goal::Answer;
pub use crate::hp::{HpError, HpOutcome, HpSeconds};
pub use crate::space::Order;
pub use adaptive::{Accuracy, Outcome, solve_adaptive, solve_on, solve_on_with};
pub use error::ElectrostaticsError;
pub use fields::FieldSample;
pub use form::{VACUUM_PERMITTIVITY, dielectric, energy_density};
pub use goals::{Goal, Quantity};
pub use hp::solve_hp;
pub use problem::{Conductor, Problem};
pub use system::{Seconds, Solved};
