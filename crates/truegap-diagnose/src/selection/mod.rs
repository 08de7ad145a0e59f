//! Which effects, alone and together, explain a recording, and how sure that is.
//!
//! Limits: at most three effects at once.

pub(crate) mod candidates;
pub(crate) mod detectability;
pub(crate) mod effect_set;
pub(crate) mod examine;
pub(crate) mod model_space;
pub(crate) mod posterior;
pub(crate) mod prior;
pub(crate) mod refitted;
pub(crate) mod rival_sets;
pub(crate) mod start;
pub(crate) mod tempering;
pub(crate) mod tuning;
pub(crate) mod unmodelled;
pub(crate) mod verdict;
pub(crate) mod weak_effects;
pub(crate) mod whole;
