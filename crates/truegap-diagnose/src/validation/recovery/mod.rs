//! The recovery bank: what this tool answers when the cause is known, for the protocol, noise and priors of *this* recording.
//!
//! Limits: counts are small; they are printed as counts.

pub(crate) mod case;
pub(crate) mod confusion;
pub(crate) mod fill;
pub(crate) mod key;
pub(crate) mod power;
pub(crate) mod truth;

pub use case::{BankCase, Truth};
pub use confusion::{Bank, Recovered};
pub use fill::{BankOptions, BankStore};
