//! Noise as a linear filter that makes it white.
//!
//! Limits: Gaussian noise.

mod kinds;
pub(crate) mod noise_model;
mod parts;
mod shape;
pub(crate) mod whitener;
