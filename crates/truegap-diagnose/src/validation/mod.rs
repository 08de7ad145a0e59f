//! How far an answer can be trusted: rows left out, permuted histories, recordings whose cause is known.
//!
//! Limits: decides nothing.

pub(crate) mod cross_validation;
pub(crate) mod permutation;
pub mod recovery;
pub(crate) mod veto;
