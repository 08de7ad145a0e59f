//! The analytic model of a capacitive tactile sensor, one function per equation, and the base models that a recording is compared with.
//!
//! Limits: steady state; everything with a memory, and everything outside the plates, is left to the stages that plug into the chain.

pub mod base;
pub mod cases;
pub mod equations;
pub mod errata;
pub mod stack;

pub use base::{BaseError, BaseModel, Recorded, base_model};
pub use stack::{CoefficientOptions, Coefficients, Point, SeriesOrder, Stack, StackOptions, State, coefficients, states};
