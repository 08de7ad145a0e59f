//! Sparse direct solvers that check what they return.
//!
//! Symmetric systems, lower triangle given. One thread a factorisation (two gave no gain): run cases in parallel.

mod direct;
mod error;

pub use direct::{Direct, Kind, Memory, Solution};
pub use error::SolveError;
