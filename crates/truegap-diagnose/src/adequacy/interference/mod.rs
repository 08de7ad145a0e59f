//! What is in the reading on every row and is no physics of the sensor: bursts, and a tone.
//!
//! Limits: judged on what one model leaves.

pub(crate) mod burst;
pub(crate) mod every_row;
pub(crate) mod steady;
pub(crate) mod tone;
