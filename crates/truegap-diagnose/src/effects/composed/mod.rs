//! Effects composed of words: where, what they follow, how in time, by which law, how they act.
//!
//! A word is a value in [`words`]; [`signal`] makes the column that a mechanism follows, [`acting`] lets it change a quantity of the chain.
//!
//! Limits: one driver a mechanism.

pub(crate) mod acting;
pub(crate) mod describe;
pub(crate) mod effect;
pub(crate) mod file;
pub(crate) mod mechanism;
pub(crate) mod signal;
pub(crate) mod units;
pub(crate) mod words;
pub(crate) mod written_units;
