//! The physics: one folder a problem, one form a file.

pub mod elasticity;
pub mod electrostatics;
