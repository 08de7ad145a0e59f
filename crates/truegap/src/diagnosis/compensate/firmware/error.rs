//! Why no firmware is written.

use crate::diagnosis::compensate::CompensateError;
use crate::models::ModelFileError;
use std::path::PathBuf;
use truegap_sweep::SweepError;

/// Why no firmware is written.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
#[allow(missing_docs)] // the fields are named by the messages
pub enum FirmwareError {
    /// Not a model file, or one of which nothing is to be corrected.
    #[error(transparent)]
    Compensate(#[from] CompensateError),
    /// The model has no answer at a place of the tables.
    #[error("{model}: the model has no answer at a place of the tables: {source}; give a narrower --range")]
    NoAnswer { model: String, source: ModelFileError },
    /// A base model that a table does not hold.
    #[error(
        "{model}: its base model `{base}` may answer a row by the rows before it, so that no table holds it; diagnose with a simulated column or a table as the base"
    )]
    Recorded { model: String, base: String },
    /// A base model that follows the clock.
    #[error(
        "{model}: its base model `{base}` follows the clock of the recording, which a sensor in use does not have; diagnose with another base"
    )]
    OfTheClock { model: String, base: String },
    /// More columns than a table of a microcontroller has room for.
    #[error(
        "{model}: the correction follows {count} columns besides the reading ({columns}), and a table for a microcontroller has room for two; correct the readings on a computer \
         with `truegap compensate`, or diagnose with fewer --effects"
    )]
    TooManyColumns { model: String, count: usize, columns: String },
    /// A range of something that is not followed.
    #[error("--range {name}: the correction follows no column of that name; it follows {known}")]
    UnknownRange { name: String, known: String },
    /// A range that is none.
    #[error("--range {text}: {why}; write NAME=LOW:HIGH, for example temperature=-10:60 (degC)")]
    NoRange { text: String, why: &'static str },
    /// A column whose range nobody knows.
    #[error("{model}: it does not tell the range of {column}; give it with --range {column}=LOW:HIGH")]
    RangeIsNotKnown { model: String, column: String },
    /// A number of the command line.
    #[error("{option} is {value}; write {wanted}")]
    Option { option: &'static str, value: String, wanted: &'static str },
    /// A table that is too coarse.
    #[error(
        "{model}: a table of at most {bytes} bytes is wrong by {error} {unit}, more than the noise of a reading ({noise} {unit}); allow more --bytes, or give a narrower --range"
    )]
    TooCoarse { model: String, bytes: usize, error: String, noise: String, unit: String },
    /// Readings that have no answer.
    #[error(
        "{model}: of readings within its range the correction leaves up to {left} {unit}, more than their noise ({noise} {unit}): what was added cannot be taken out there; give a narrower \
         --range reading=LOW:HIGH"
    )]
    NotInverted { model: String, left: String, noise: String, unit: String },
    /// A correction that corrects nothing.
    #[error(
        "{model}: what was added for {effects} moves no reading of the table by more than {moved} {unit}, or cannot be told from the reading, as beyond a limit at which it stops; there is nothing to write"
    )]
    NothingMoves { model: String, effects: String, moved: String, unit: String },
    /// A number that a `float` does not hold.
    #[error("{model}: {value:e} does not fit into a `float` of C; diagnose with another unit of the reading")]
    NoFloat { model: String, value: f64 },
    /// A file that would be lost.
    #[error("{file}: is there already, and is no earlier result of `truegap firmware`; give -o another name, or move it")]
    WouldBeLost { file: PathBuf },
    /// The disk says no.
    #[error(transparent)]
    Write(#[from] SweepError),
}
