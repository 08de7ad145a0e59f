//! What was recorded, and what should have been: problems, facts of their inputs, several recordings as one.
//!
//! Limits: no equation, no noise.

pub(crate) mod angle;
pub(crate) mod context;
pub(crate) mod error;
pub mod joint;
pub(crate) mod load;
pub(crate) mod moved;
pub(crate) mod pauses;
pub(crate) mod problem;
