//! Assumptions about the warping and bending electrode.
//!
//! Limits: beads act as an elastic layer; their own mechanics is in [`super::cell`].

use crate::Assumption;

/// The list, in the order of the model's chain.
pub const ASSUMPTIONS: &[&dyn Assumption] = &[];
