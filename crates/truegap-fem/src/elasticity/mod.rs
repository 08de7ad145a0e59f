//! Thermoelasticity: linear and finite strain, nearly incompressible, axisymmetric and planar.
//!
//! Isotropic, static, without plasticity. One load factor scales all loads, displacements and temperatures.
//!
//! # Example: a bar pressed between smooth plates
//!
//! Plane strain, free sides: the stress along the bar is `E / (1 - nu^2)` times its strain, exact but for rounding.
//!
//! ```
//! use truegap_fem::elasticity::{
//!     Component, Condition, Formulation, LawKind, Material, Order, Problem, Solver, Temperature,
//! };
//! use truegap_fem::mesh::{Geometry, MeshOptions, Outline, SizeField, mesh_geometry};
//! use truegap_fem::{FemError, Symmetry};
//!
//! let drawing = Geometry::default()
//!     .region("bar", Outline::rectangle([0.0, 0.0], [1e-3, 2e-3]))
//!     .boundary("bottom", &[[0.0, 0.0], [1e-3, 0.0]])
//!     .boundary("top", &[[0.0, 2e-3], [1e-3, 2e-3]]);
//! let options = MeshOptions { size: SizeField::uniform(0.25e-3), ..MeshOptions::default() };
//! let problem = Problem {
//!     mesh: mesh_geometry(&drawing, &options)?,
//!     symmetry: Symmetry::Planar,
//!     materials: vec![Material {
//!         young: 1e6,
//!         poisson: 0.3,
//!         expansion: 0.0,
//!         law: LawKind::Linear,
//!         formulation: Formulation::Displacement,
//!     }],
//!     conditions: vec![
//!         Condition::fix("bottom", Component::Second),
//!         Condition::pin([0.0, 0.0], Component::First),
//!         Condition::displace("top", Component::Second, -2e-6),
//!     ],
//!     temperature: Temperature::uniform(0.0),
//!     body_force: None,
//!     order: Order::Quadratic,
//! };
//! let pressed = Solver::new(problem)?.solve()?;
//! let stress_pa = pressed.stress_at([0.5e-3, 1e-3])?.named("yy").unwrap_or(f64::NAN);
//! assert!((stress_pa / (-1e-3 * 1e6 / (1.0 - 0.3 * 0.3)) - 1.0).abs() < 1e-9);
//! // The force per metre of depth on a plate of 1 mm.
//! let force = pressed.reaction("top", Component::Second)?;
//! assert!((force / (stress_pa * 1e-3) - 1.0).abs() < 1e-9);
//! # Ok::<(), FemError>(())
//! ```

mod body;
mod contact;
mod element;
mod ends;
mod error;
mod estimate;
mod following;
mod goals;
mod harmonic;
mod hp;
pub mod kinematics;
pub mod laws;
mod load_steps;
mod loads;
mod material;
mod middle;
mod newton;
mod obstacle;
mod point;
mod pressure;
mod problem;
mod quadrature_point;
mod recovery;
mod rigid;
mod solution;
mod solver;
mod stability;
mod thermal;
mod touching;
mod vector;

pub use crate::goal::Answer;
pub use crate::hp::{HpError, HpOutcome, HpSeconds};
pub use crate::space::Order;
pub use body::Body;
pub use contact::{ContactGoal, ContactQuantity, Press, solve_contact};
pub use error::ElasticityError;
pub use goals::{Accuracy, Goal, Outcome, Quantity, solve_goals, solve_goals_adaptive};
pub use hp::solve_hp;
pub use material::{Formulation, Lame, LawKind, Material};
pub use newton::NewtonOptions;
pub use pressure::Acts;
pub use problem::{Component, Condition, Field, Place, PressureLoad, Problem, Side, Temperature};
pub use solution::{Components, Solution};
pub use solver::{Counters, Solver};
pub use stability::{Harmonic, Instability, Mode};
