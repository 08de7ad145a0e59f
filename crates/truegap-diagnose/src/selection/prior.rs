//! What a model is worth before the recording is seen: fewer effects are likelier, and many candidates share what their number is worth.
//!
//! Limits: every set of one size is as likely as another.

use crate::{selection::candidates::Tried, selection::tuning::NUMBER_PRIOR};

/// Log prior of a model with `count` of `library` effects.
pub(crate) fn log_prior(count: usize, library: usize) -> f64 {
    let combinations: f64 = (0..count).map(|i| (library.max(count) - i) as f64 / (i + 1) as f64).product();
    (number_prior(count) / combinations).ln()
}

/// Log prior of one thing more beside `count` effects, over that of those alone; minus infinity where there are as many as there may be.
pub(crate) fn one_more(count: usize) -> f64 {
    (number_prior(count + 1) / number_prior(count)).ln()
}

fn number_prior(count: usize) -> f64 {
    NUMBER_PRIOR.get(count).copied().unwrap_or(0.0)
}

/// Log posterior of a model, up to a constant: its log evidence over `temper`, and its log prior.
pub(crate) fn weight(temper: f64, library: usize) -> impl Fn(&Tried) -> f64 + Copy + Sync {
    move |m| m.fit.log_evidence / temper + log_prior(m.effects.len(), library)
}
