//! Locate, name and model the physics that a simulation leaves out of a recording.
//!
//! Limits: sees a model only through [`truegap_core::Simulator`]; one scalar response.

#[cfg(test)]
extern crate self as truegap_diagnose;

mod adequacy;
pub mod answer;
mod data;
pub mod effects;
mod explain;
mod fit;
mod noise;
mod pipeline;
pub mod quality;
mod selection;
mod stats;
pub mod text;
mod validation;
mod whitening;

pub use answer::{Augmented, Diagnosis, Known, Outcome, RecordingFacts, Traces, Verdict};
pub use data::{context::Context, error::DiagnoseError, joint, problem::Problem};
pub use effects::{
    collection::Library,
    effect::{About, Effect, Family, FittedParameter, Separation, ZeroCourse},
    library,
    sentence::sentence,
};
pub use pipeline::{Options, Restriction, diagnose};
pub use selection::candidates::Progress;

pub use validation::{confirmation, cross_validation::parts, recovery};

/// Runs that a next experiment may be: what `truegap simulate --profile` plays.
pub mod experiment {
    pub use crate::explain::next_experiment::{PROFILES, Points, Profile, inputs};
}

/// Calibration of a model to a recording, noise and all: what a diagnosis does first.
pub mod calibration {
    pub use crate::{
        fit::{
            levenberg_marquardt::FitOptions,
            maximum_a_posteriori::{fit, fit_onwards},
            model::Model,
            optimum::Fit,
        },
        whitening::whitener::{InputError, Noise, Whitener},
    };
}

#[cfg(test)]
#[path = "../tests/common/mod.rs"]
mod common;
#[cfg(test)]
mod tests;
