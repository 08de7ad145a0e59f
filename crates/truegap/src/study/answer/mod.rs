//! What the studies answer: plain data, as JSON and CSV have it.
//!
//! Limits: nothing here computes or draws.

#[cfg(feature = "fem")]
pub mod audit;
pub mod optimise;
pub mod sensitivity;
pub mod tolerance;
