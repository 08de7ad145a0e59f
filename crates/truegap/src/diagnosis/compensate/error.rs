//! Why readings are not corrected.

use crate::diagnosis::{DiagnosisError, SaysOtherwise};
use crate::models::{AnswerError, ModelFileError};
use std::path::PathBuf;
use truegap_sweep::SweepError;

/// Why readings are not corrected.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
#[allow(missing_docs)] // the fields are named by the messages
pub enum CompensateError {
    /// Not a model file.
    #[error(transparent)]
    Model(#[from] ModelFileError),
    /// The recording cannot be taken as it is.
    #[error(transparent)]
    Recording(#[from] DiagnosisError),
    /// The recording says something else of itself than the model.
    #[error(transparent)]
    Otherwise(#[from] SaysOtherwise),
    /// Nothing to correct for.
    #[error(
        "{model}: no physics is added to its base model, so there is nothing to correct for; give the augmented.toml of a diagnosis that found a cause"
    )]
    NothingAdded { model: String },
    /// Nothing that can be corrected.
    #[error("{model}: a reading cannot be corrected for {reasons}; nothing else was added")]
    NothingLeft { model: String, reasons: String },
    /// Another kind of reading.
    #[error(
        "{recording}: its response is in {found}, the model's in {wanted}; name the unit under [units], or give a recording of the same kind"
    )]
    Unit { recording: String, found: String, wanted: String },
    /// Readings of which nothing can be said.
    #[error(
        "{recording}: its response goes from {low:e} to {high:e} {unit}, farther than a number can hold; leave such rows out, or mark them with nan"
    )]
    Range { recording: String, low: f64, high: f64, unit: String },
    /// A number that is none.
    #[error("{recording}: {what} is no finite number; check the unit of the response, and the numbers of the model file")]
    NotFinite { recording: String, what: String },
    /// A column that is needed.
    #[error(
        "{recording}: there is no column for {column}, which {who} needs; name it with {map}, or under [columns] or [drivers] of its TOML"
    )]
    Missing { recording: String, column: String, who: String, map: String },
    /// A base model that is not inverted.
    #[error(
        "{model}: its base model `{base}` may answer a row by the rows before it, so its input cannot be estimated from the reading; give a recording that has its input ({columns}), or \
         diagnose with a simulated column or a table as the base"
    )]
    NotInverted { model: String, base: String, columns: String },
    /// A base model that stands still.
    #[error(
        "{model}: its base model `{base}` does not move with {column}, so {column} cannot be estimated from the reading; diagnose with another base"
    )]
    StandsStill { model: String, base: String, column: String },
    /// A base model that hardly moves.
    #[error(
        "{model}: its base model `{base}` hardly moves with {column}: in {far} of {rows} rows the {column} that it needs for the reading is far beyond any that it was fitted to ({estimated}, where it was \
         {fitted}), since what was added follows the reading in its place; diagnose with --library-only, or with another base"
    )]
    HardlyMoves { model: String, base: String, column: String, far: usize, rows: usize, estimated: String, fitted: String },
    /// Most rows are far beyond what the model gives.
    #[error(
        "{recording}: in {outside} of {rows} rows no {input} of the base model of {model} gives the corrected reading: these go from {read}, and the base model gives \
         {gives}; it looks like another sensor, another range or a wrong unit: name the column and unit of the reading with --map response=COLUMN:UNIT, or diagnose \
         a recording of this sensor that covers the range, and give its augmented.toml"
    )]
    Outside { recording: String, model: String, outside: usize, rows: usize, input: String, read: String, gives: String },
    /// The model has no answer there.
    #[error(transparent)]
    NoAnswer(#[from] AnswerError),
    /// A file that would be lost.
    #[error("{file}: is there already, and is no earlier result of `truegap compensate`; give -o another name, or move it")]
    WouldBeLost { file: PathBuf },
    /// The disk says no.
    #[error(transparent)]
    Write(#[from] SweepError),
}
