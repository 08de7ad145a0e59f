//! Locate, name and model the physics that a simulation leaves out of a recording.
//!
//! Limits: sees a model only through [`truegap_core::Simulator`]; one scalar response.

pub mod context;
pub mod effect;
pub mod effects;
pub mod memory;

pub use context::Context;
pub use effect::{About, Effect, Family, FittedParameter};
pub use effects::library;

mod alternatives;
pub mod answer;
pub mod augmented;
pub mod bank;
pub mod burst;
pub mod conflicts;
pub mod control;
pub(crate) mod descent;
pub mod detectability;
pub mod diagnose;
pub mod diagnosis;
pub mod directions;
pub mod evidence;
pub mod examine;
pub mod fit;
mod fit_facts;
pub mod flexible;
pub mod gate;
pub mod heard;
pub mod held_out;
pub mod importance;
pub mod issues;
pub mod joint;
pub mod latent;
pub mod locate;
pub mod next;
pub mod noise;
pub mod notice;
pub mod number;
pub mod problem;
pub mod score;
pub mod screen;
pub mod search;
pub mod select;
mod temper;
pub mod thin;
pub mod tone;
mod traces;
mod tries;
pub mod unlisted;
pub mod verdict;
pub mod whiten;

pub use augmented::Augmented;
pub use diagnose::{Options, Outcome, diagnose};
pub use diagnosis::{Diagnosis, RecordingFacts, Traces, Verdict};
pub use issues::DiagnoseError;
pub use problem::Problem;
pub use search::Progress;
