//! Axisymmetric and planar finite elements: meshing, quadratic spaces, sparse assembly and direct solvers,
//! with electrostatics and thermoelasticity built on them.
//!
//! The crate knows no sensor: it takes outlines, materials and boundary conditions. Everything inside is SI
//! (metres, volts, pascals); text with units exists only in case files. Sizes are those of two-dimensional
//! problems (a few million unknowns on one machine).
//!
//! | you have | you call |
//! |---|---|
//! | a case file | [`case::read_case`], [`case::solve_case`] |
//! | outlines, conductors, permittivities | [`mesh::mesh_geometry`], [`electrostatics::solve_adaptive`] |
//! | outlines, materials, loads | [`mesh::mesh_geometry`], [`elasticity::Solver`] or [`elasticity::solve_goals_adaptive`] |
//! | a mesh file | [`io::read_msh`] |
//! | a form of your own | [`space`] for shapes and numbering, [`algebra`] for the system |
//!
//! # Example: a disc capacitor with its fringing field
//!
//! Two discs of radius 10 mm, 1 mm apart, in open space. Love's integral equation gives `C = 36.93232 eps0 a`, 17.6 % more
//! than `eps0 A / d`.
//!
//! ```
//! use truegap_fem::case::{read_case, solve_case};
//!
//! let text = r#"
//! schema = "truegap.case/1"
//! physics = "electrostatics"
//! symmetry = "axisymmetric"
//! length_unit = "mm"
//! material.air.relative_permittivity = 1.0
//! region = [{ name = "space", material = "air", polygon = [[0, -50], [50, -50], [50, 50], [0, 50]] }]
//! boundary = [
//!     { name = "upper", path = [[0, 0.5], [10, 0.5]], potential = "0.5 V" },
//!     { name = "lower", path = [[0, -0.5], [10, -0.5]], potential = "-0.5 V" },
//!     { name = "far", path = [[0, -50], [50, -50], [50, 50], [0, 50]], open = true },
//! ]
//! mesh.target_error = 1e-3
//! output = [{ name = "C", kind = "capacitance", boundary = "upper" }]
//! "#;
//! let result = solve_case(&read_case(text, "disc.toml")?)?;
//! let c = result.quantity("C").ok_or("the case has no output C")?;
//! let love = 36.93232 * 8.8541878e-12 * 10e-3;
//! // The target of the case is also the tolerance.
//! assert!((c.value / love - 1.0).abs() < 1e-3 && c.unit == "F");
//! assert!(c.relative_error_estimate < 1e-3);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # Between files
//!
//! No file of the crate uses items of a file that uses its own, directly or through others.

// Comparisons are written so that NaN falls on the refusing side.
#![allow(clippy::neg_cmp_op_on_partial_ord)]

pub mod algebra;
pub mod case;
pub mod elasticity;
pub mod electrostatics;
mod error;
mod goal;
mod hp;
pub mod io;
pub mod mesh;
pub mod problems;
pub mod space;
mod symmetry;

pub use error::FemError;
pub use symmetry::Symmetry;
