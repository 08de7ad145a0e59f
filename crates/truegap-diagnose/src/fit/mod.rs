//! Fits of a model with effects, their evidence, and score tests beside them.
//!
//! Limits: one mode of the posterior at a time.

pub(crate) mod few_jumps;
pub(crate) mod importance;
pub(crate) mod laplace;
pub(crate) mod levenberg_marquardt;
pub(crate) mod maximum_a_posteriori;
pub(crate) mod model;
pub(crate) mod optimum;
pub(crate) mod prior;
pub(crate) mod remembered;
pub(crate) mod score_test;
pub(crate) mod several_starts;
pub(crate) mod tuning;
pub(crate) mod under_noise;
pub(crate) mod ways;
