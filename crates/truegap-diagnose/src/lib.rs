//! Locate, name and model the physics that a simulation leaves out of a recording.
//!
//! Limits: sees a model only through [`truegap_core::Simulator`]; one scalar response.
//!
//! # What is where
//!
//! | what | items |
//! |---|---|
//! | a recording and the model of it | [`Problem`], [`joint`] for several recordings as one |
//! | run a diagnosis | [`diagnose_recording`], or [`diagnose`] with progress and a stop; [`Options`], [`Progress`] |
//! | the answer | [`Outcome`]: [`Diagnosis`], [`Traces`], [`Augmented`]; all of `diagnosis.json` is in [`answer`] |
//! | the omitted physics that is known, and how to add some | [`effects`], [`Effect`], [`Library`], [`Context`] |
//! | what is wrong with the recording itself | [`quality`] |
//! | how far to trust an answer | [`confirmation`] by another recording (with a clock of its own: [`other_clock`]), [`recovery`] of known causes |
//! | calibration alone | [`calibration`] |
//! | readings corrected for what was found | [`compensation`] |
//!
//! `examples/diagnose_csv.rs` goes from a CSV to a verdict; how the stages work is in `docs/diagnosis.md`.
//!
//! # A simulator of your own
//!
//! A level that should not move, and a recording in which it follows the temperature:
//!
//! ```
//! use std::sync::atomic::AtomicBool;
//! use truegap_core::{Inputs, Parameter, Readout, Role, SimulationError, Simulator, Stage, StageName, named_values, walk_without_plates};
//! use truegap_diagnose::{Known, Options, Problem, Verdict, diagnose};
//!
//! struct Level([Parameter; 1]);
//!
//! impl Simulator for Level {
//!     fn name(&self) -> &str { "level" }
//!     fn unit(&self) -> &str { "mV" }
//!     fn parameters(&self) -> &[Parameter] { &self.0 }
//!     fn needs(&self) -> &[Role] { &[] }
//!     fn lacks(&self, stage: StageName) -> Option<&'static str> {
//!         (!matches!(stage, StageName::ThermalPath | StageName::Readout)).then_some("a level has neither load nor plates")
//!     }
//!     fn full_load(&self) -> Option<f64> { None }
//!     fn respond(&self, values: &[f64], inputs: &Inputs, stages: &[&dyn Stage]) -> Result<Vec<f64>, SimulationError> {
//!         let [zero] = named_values(self, values)?;
//!         walk_without_plates(self, values, inputs, stages, |_| Ok((vec![zero; inputs.len()], Readout { zero, span: 1.0 })))
//!     }
//! }
//!
//! let rows = 600;
//! let temperature: Vec<f64> = (0..rows).map(|row| 20.0 + 10.0 * (row as f64 / 60.0).sin()).collect();
//! let noise = |row: usize| 0.01 * ((row * row * 7919 % 1009) as f64 / 1009.0 - 0.5);
//! let response: Vec<f64> = (0..rows).map(|row| 3.0 + 0.004 * (temperature[row] - 20.0) + noise(row)).collect();
//! let inputs = Inputs {
//!     time_s: Some((0..rows).map(|row| row as f64).collect()),
//!     run: vec![1; rows],
//!     temperature_c: Some(temperature),
//!     ..Inputs::default()
//! };
//!
//! let level = Level([Parameter::normal("zero", "mV", 3.0, 1.0, "value that should not move")]);
//! let problem = Problem { inputs: &inputs, response: &response, simulator: &level };
//! let found = diagnose(&problem, Known::default(), &Options::default(), &|_| (), &AtomicBool::new(false))?.diagnosis;
//! assert_eq!(found.verdict, Verdict::Explained);
//! assert_eq!(found.findings[0].effect, "temperature_coefficient");
//! println!("{}", found.findings[0].says);
//! # Ok::<(), truegap_diagnose::DiagnoseError>(())
//! ```

#[cfg(test)]
extern crate self as truegap_diagnose;

mod adequacy;
pub mod answer;
pub mod compensation;
mod data;
mod discovery;
pub mod effects;
mod explain;
mod fit;
mod noise;
mod pipeline;
pub mod quality;
mod seeds;
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
    sentence::{sentence, sentence_of_seen},
};
pub use pipeline::{Options, Restriction, diagnose, recording::diagnose_recording};
pub use seeds::{SEEDS, Seeds};
pub use selection::candidates::Progress;
pub use stats::rms;

pub use validation::{ceiling, confirmation, cross_validation::parts, other_clock, recovery};

/// Runs that a next experiment may be: what `truegap simulate --profile` plays.
pub mod experiment {
    pub use crate::explain::next_experiment::{PROFILES, Points, Profile, inputs};
}

/// Mechanisms composed of words: as effects, and as files.
pub mod mechanism {
    pub use crate::{
        discovery::marginals::WordProbabilities,
        effects::composed::{
            effect::Composed,
            file::{Known, MechanismError, MechanismFile, SCHEMA},
            mechanism::{Mechanism, Numbers, Sentence, Sum},
            words::{Action, Driver, Form, InWords, Kinetics, Place, Quantity},
        },
    };
}

/// Calibration of a model to a recording, noise and all: what a diagnosis does first.
pub mod calibration {
    pub use crate::{
        fit::{levenberg_marquardt::FitOptions, maximum_a_posteriori::fit, model::Model, optimum::Fit},
        whitening::whitener::{InputError, Noise, Whitener},
    };
}

#[cfg(test)]
#[path = "../tests/common/mod.rs"]
mod common;
#[cfg(test)]
mod tests;
