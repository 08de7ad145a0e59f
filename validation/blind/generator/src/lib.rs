//! Recordings with a concealed cause, made by equations that share nothing with the fitter.
//!
//! A [`Study`] draws sensors, protocols, noise and causes from a seed; [`score`] compares diagnoses with the sealed answers. The package
//! depends on no other part of truegap, on purpose: an error made in the model cannot be made here as well. It knows the `stack` sensor
//! only, and says nothing about how a diagnosis should be found.

pub mod answer;
mod bath;
pub mod case;
pub mod causes;
pub mod chain;
pub mod commitment;
pub mod detectability;
pub mod draws;
pub mod fresh;
pub mod history;
pub mod logger;
pub mod mechanism;
pub mod noise;
pub mod physics;
pub mod protocol;
pub mod recording;
pub mod score;
pub mod sensor;
pub mod settings;
pub mod state;
pub mod stranger;
pub mod study;
pub mod wild;

pub use answer::Answer;
pub use case::{BlindCase, CaseError};
pub use fresh::Fresh;
pub use settings::Options;
pub use study::{Study, StudyError};
