//! Assumptions about the beads, the dielectric and the field.
//!
//! Limits: one bead stands for all; interaction with the plate's shape is in [`super::plate`].

use crate::Assumption;

/// The list, in the order of the model's chain.
pub const ASSUMPTIONS: &[&dyn Assumption] = &[];
