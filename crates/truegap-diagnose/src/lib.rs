//! Locate, name and model the physics that a simulation leaves out of a recording.
//!
//! Limits: sees a model only through [`truegap_core::Simulator`]; one scalar response.

pub mod context;
pub mod effect;
pub mod effects;
pub mod memory;

pub use context::Context;
pub use effect::{About, Effect, Family, FittedParameter};
pub use effects::library;

pub mod diagnosis;
pub mod evidence;
pub mod fit;
pub mod noise;
pub mod problem;
pub mod whiten;
