//! A slow input that was not recorded: whether the recording asks for one, and how well its course is recovered.
//!
//! Limits: one course, through the zero or the gain of the reading.

pub(crate) mod course;
pub(crate) mod knots;
pub(crate) mod opened;
pub(crate) mod slow_input;
