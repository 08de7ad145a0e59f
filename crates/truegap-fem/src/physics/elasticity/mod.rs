//! Thermoelasticity: linear and finite strain, nearly incompressible, axisymmetric and planar.
//!
//! Isotropic, static, without plasticity. One load factor scales all loads, displacements and temperatures.

mod body;
mod element;
mod error;
mod estimate;
mod goals;
pub mod harmonic;
pub mod kinematics;
pub mod laws;
mod loads;
mod material;
mod newton;
mod obstacle;
mod point;
mod problem;
mod recovery;
mod rigid;
mod solution;
mod solver;
mod stability;
mod thermal;

pub use crate::space::Order;
pub use body::Body;
pub use error::ElasticityError;
pub use goals::{Accuracy, Answer, Goal, Outcome, Quantity, solve_goals, solve_goals_adaptive};
pub use material::{Formulation, Lame, LawKind, Material};
pub use newton::NewtonOptions;
pub use problem::{Component, Condition, Field, Place, Problem, Side, Temperature};
pub use solution::{Components, Solution};
pub use solver::{Counters, Solver};
pub use stability::{Harmonic, Instability, Mode};
pub use thermal::ThermalStretch;
