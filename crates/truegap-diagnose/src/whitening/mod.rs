//! Noise as a linear filter that makes it white.
//!
//! Limits: Gaussian noise.

pub(crate) mod noise_model;
pub(crate) mod whitener;
