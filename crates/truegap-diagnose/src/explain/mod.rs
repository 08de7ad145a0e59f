//! Where a recording and its model differ, what calibration hid, and what to measure next.
//!
//! Limits: names no cause.

pub(crate) mod conflicts;
pub(crate) mod hidden_input;
pub(crate) mod locate;
pub(crate) mod narrowing;
pub(crate) mod next_experiment;
pub(crate) mod play;
pub(crate) mod tuning;
