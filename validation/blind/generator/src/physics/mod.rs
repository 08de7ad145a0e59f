//! The stack sensor by another route than the closed forms: quadrature, bisection, Timoshenko's two-layer plate.

pub mod beads;
pub mod constants;
pub mod field;
pub mod gauss;
pub mod layers;
pub mod memory;
pub mod warp;
