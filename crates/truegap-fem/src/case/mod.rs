//! FEM cases as text: `truegap.case/1` files in, named quantities out.
//!
//! Text carries units; everything in a `Case` is SI. The file describes one body, one physics, one state.

mod contact;
mod description;
mod elastic_outputs;
mod elasticity;
mod electrostatics;
mod error;
mod fields;
mod first_mesh;
mod geometry;
mod hp;
mod raw;
mod read;
mod result;
mod solve;
mod temperature;
mod units;

pub use description::{Case, Condition, Drive, Law, Material, MeshRequest, Method, Output, OutputKind, Physics, Plate};
pub use error::CaseError;
pub use fields::{InTriangles, SolvedCase};
pub use first_mesh::mesh_case;
pub use read::read_case;
pub use result::{CaseResult, ErrorsFrom, MeshCounts, PressureActs, QuantityValue, SecondsSpent};
pub use solve::{solve_case, solve_case_with_fields};
pub use temperature::{RadialTerm, Temperature};
