//! How much each quantity matters: one at a time as in the paper, locally by derivatives, and over the tolerances by Sobol indices.
//!
//! Limits: the number of beads counts as a real number.

mod local;
mod one_at_a_time;
mod sobol;
mod tolerances;

pub use local::{LocalSensitivity, local};
pub use one_at_a_time::{OneAtATime, PAPER_QUANTITIES, one_at_a_time, ranked};
pub use sobol::{Index, SobolOptions};
pub use tolerances::{QuantityIndices, ToleranceIndices, tolerance_indices};
