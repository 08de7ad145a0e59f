//! Is a fitted model adequate? Tests that know no effect.
//!
//! Limits: what no test looks at goes unseen.

pub(crate) mod directions;
pub(crate) mod interference;
pub(crate) mod lack_of_fit;
pub(crate) mod tuning;
