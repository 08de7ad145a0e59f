//! From element matrices to the sparse system, over a pattern that is built once.
//!
//! Symmetric systems only: the lower triangle is stored. Element matrices are computed in parallel and added in
//! element order, so that the sums do not depend on the number of threads.

mod pattern;
mod vector;

pub use pattern::{Pattern, Places};
pub use vector::{assemble_vector, element_residual, for_each_element};
