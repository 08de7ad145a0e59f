//! From element matrices to a checked solution: the sparsity pattern, the sums over elements, the direct solver.
//!
//! Symmetric systems only: the lower triangle is stored. Element matrices are computed in parallel and added in
//! element order, so that the sums do not depend on the number of threads. One thread a factorisation (two gave no
//! gain): run cases in parallel.

mod direct;
mod error;
mod pattern;
mod vector;

pub(crate) use direct::{ALLOWED_PROBE_ERROR, ALLOWED_RESIDUAL, largest};
pub use direct::{Direct, Kind, Memory, Solution};
pub use error::SolveError;
pub use pattern::{Pattern, ScatterMap};
pub(crate) use vector::for_each_element;
pub use vector::{assemble_vector, element_residual};
