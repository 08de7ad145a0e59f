//! Why nothing can be judged.

use crate::diagnosis::{DiagnosisError, SaysOtherwise};
use crate::models::{AnswerError, ModelFileError};
use crate::output::OutputError;
use truegap_diagnose::DiagnoseError;
use truegap_diagnose::quality::FEWEST_ROWS;

/// Why nothing can be judged.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
#[allow(missing_docs)] // the fields are named by the messages
pub enum ConfirmError {
    /// Not a model file.
    #[error(transparent)]
    Model(#[from] ModelFileError),
    /// The recording cannot be taken as it is.
    #[error(transparent)]
    Recording(#[from] DiagnosisError),
    /// The recording says something else of itself than the model.
    #[error(transparent)]
    Otherwise(#[from] SaysOtherwise),
    /// Nothing to be judged.
    #[error(
        "{model}: no physics is added to its base model, so there is nothing to confirm; give the augmented.toml of a diagnosis that found a cause (whether the base model alone holds for another recording, `truegap diagnose` of that one says)"
    )]
    NothingAdded { model: String },
    /// The recording took part.
    #[error("{recording}: the model was fitted to this recording; give one that took no part")]
    TookPart { recording: String },
    /// Too few rows to tell two models apart.
    #[error("{recording}: {rows} row{} too few to judge a model by; give at least {FEWEST_ROWS}", if *.rows == 1 { " is" } else { "s are" })]
    TooFewRows { recording: String, rows: usize },
    /// Another kind of reading.
    #[error(
        "{recording}: its response is in {found}, the model's in {wanted}; name the unit under [units], or give a recording of the same kind"
    )]
    Unit { recording: String, found: String, wanted: String },
    /// Numbers that belong to the runs of one recording.
    #[error(
        "{model}: {effects} has a number for each run of the recording that it was fitted to, which means nothing in the runs of another; diagnose without it \
         (--effects), or join the recordings in one diagnosis"
    )]
    BoundToRuns { model: String, effects: String },
    /// Numbers that mean nothing in another recording.
    #[error("{model}: nothing is left that another recording could confirm or refute: {reasons}")]
    LeftOut { model: String, reasons: String },
    /// The recording could not show what was added.
    #[error("{recording}: could not show {reasons}; give a recording that drives what was added")]
    NotShown { recording: String, reasons: String },
    /// The model has no answer there.
    #[error(transparent)]
    NoAnswer(#[from] AnswerError),
    /// The noise has no answer.
    #[error("{recording}: its noise: {source}")]
    Noise { recording: String, source: DiagnoseError },
    /// A word that means nothing.
    #[error("--free {word}: only `gain`, `offset` and `clock` can be free")]
    Free { word: String },
    /// A clock to be fitted where none was recorded.
    #[error(
        "{recording}: it has no time, so no clock can be fitted to it; name its column of time under [columns], or leave `clock` out of --free"
    )]
    NoClock { recording: String },
    /// The answer cannot be written.
    #[error(transparent)]
    Output(#[from] OutputError),
    /// The answer cannot be written as JSON.
    #[error("the confirmation cannot be written as JSON: {0}")]
    Json(#[from] serde_json::Error),
}
