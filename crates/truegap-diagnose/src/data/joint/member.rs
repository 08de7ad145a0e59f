//! One recording of several.
//!
//! Limits: plain data.

use truegap_core::{Inputs, Simulator};

/// A recording that is to be joined with others.
pub struct Member<'a> {
    /// name, for a reader
    pub name: String,
    /// its base model
    pub simulator: &'a dyn Simulator,
    /// number of its sensor or specimen: members with the same number are the same one
    pub specimen: usize,
    /// what was done, on its own clock
    pub inputs: &'a Inputs,
    /// what was read
    pub response: &'a [f64],
}
