//! The register: every assumption by its stable name.
//!
//! Limits: ids never change their meaning.

use crate::{
    Assumption,
    assumptions::{cell, plate},
};

/// Every assumption, in the order of the model's chain: beads and field first, then the plate.
pub fn register() -> Vec<&'static dyn Assumption> {
    cell::ASSUMPTIONS.iter().chain(plate::ASSUMPTIONS).copied().collect()
}
