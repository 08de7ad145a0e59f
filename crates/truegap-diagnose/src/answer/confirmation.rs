//! What another recording says of the model that a diagnosis ended with: the contents of `confirmation.json`.
//!
//! Limits: plain data.

use crate::text::spoken;
use crate::validation::confirmation::{Compared, Judgement, NoiseFloor, Reading};
use crate::validation::other_clock::OtherClock;
use serde::Serialize;

/// The model that was judged.
#[derive(Clone, Debug, Serialize)]
pub struct ModelFacts {
    /// its file
    pub file: String,
    /// recording that it was fitted to
    pub recording: String,
    /// SHA-256 of that recording
    pub sha256: String,
    /// verdict of that diagnosis
    pub verdict: String,
    /// ids of the added effects
    pub effects: Vec<String>,
    /// whether the file has the values of the base model calibrated alone
    pub base_is_known: bool,
}

/// The recording that took no part.
#[derive(Clone, Debug, Serialize)]
pub struct OtherFacts {
    /// its file
    pub source: String,
    /// SHA-256
    pub sha256: String,
    /// rows
    pub rows: usize,
    /// runs
    pub runs: usize,
}

/// One model on the other recording.
#[derive(Clone, Debug, Serialize)]
pub struct Errors {
    /// root-mean-square error, response unit
    pub rmse: f64,
    /// gain and offset that were fitted, as far as they were free
    #[serde(flatten)]
    pub reading: Reading,
    /// clock that was fitted, where it was free
    #[serde(skip_serializing_if = "Option::is_none")]
    pub clock: Option<OtherClock>,
}

/// A rival on the other recording: what the first recording could not tell from a named effect.
#[derive(Clone, Debug, Serialize)]
pub struct RivalErrors {
    /// id of the named effect
    pub instead_of: String,
    /// id of the rival
    pub id: String,
    /// errors of the model that holds it
    #[serde(flatten)]
    pub errors: Errors,
    /// the best of all models against this one: `confirmed` where the best predicts better; absent of the best itself
    #[serde(skip_serializing_if = "Option::is_none")]
    pub behind_the_best: Option<Compared>,
}

impl RivalErrors {
    /// Its model in a row of a table: `viscoelastic creep for readout lag`.
    pub fn row(&self) -> String {
        format!("{} for {}", spoken(&self.id), spoken(&self.instead_of))
    }
}

/// What the other recording says of the rivals.
#[derive(Clone, Debug, Serialize)]
pub struct AmongRivals {
    /// rivals that could be judged
    pub judged: Vec<RivalErrors>,
    /// rivals that could not be, each with the reason
    pub refused: Vec<String>,
    /// the best of all models against the augmented one; absent where that is the best
    #[serde(skip_serializing_if = "Option::is_none")]
    pub augmented_behind_the_best: Option<Compared>,
    /// level of each comparison: that of the verdict, shared by all of them
    pub level: f64,
    /// the answer in a sentence
    pub says: String,
}

/// The answer, as `confirmation.json` holds it.
#[derive(Clone, Debug, Serialize)]
pub struct Confirmation {
    /// always `truegap.confirmation/1`
    pub schema: &'static str,
    /// program and version
    pub made_by: String,
    /// the model
    pub model: ModelFacts,
    /// the recording that took no part
    pub recording: OtherFacts,
    /// unit of the response
    pub unit: String,
    /// what was fitted to this recording
    pub free: Vec<&'static str>,
    /// base model alone
    pub base: Errors,
    /// augmented model
    pub augmented: Errors,
    /// noise
    pub noise: NoiseFloor,
    /// level of the verdict
    pub level: f64,
    /// verdict
    pub verdict: Judgement,
    /// what it rests on
    pub test: Compared,
    /// verdict where gain and offset are free as well, whatever was asked
    pub verdict_if_gain_and_offset_are_free: Judgement,
    /// the answer in a sentence
    pub says: String,
    /// what this recording says of what the first one could not tell apart; absent where the model file has no rivals
    #[serde(skip_serializing_if = "Option::is_none")]
    pub rivals: Option<AmongRivals>,
    /// what a reader should know beside it
    pub notes: Vec<String>,
}

/// What came of a recording that was set against the answer of the same run.
#[derive(Clone, Debug, Serialize)]
#[serde(untagged)]
pub enum Confirmed {
    /// it was judged
    Judged(Box<Confirmation>),
    /// it could not be
    Refused {
        /// the recording
        source: String,
        /// why not
        refused: String,
    },
}
