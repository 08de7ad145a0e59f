//! Why there is no diagnosis, or why it cannot be written.
//!
//! Limits: what is wrong with the recording's content is told by the crates that find it.

use crate::models::{BaseModelError, ModelFileError};
use crate::output::OutputError;
use truegap_core::RecordingError;
use truegap_diagnose::DiagnoseError;

/// Why there is no diagnosis.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
#[allow(missing_docs)] // the fields are named by the messages
pub enum DiagnosisError {
    /// A recording cannot be read.
    #[error(transparent)]
    Recording(#[from] RecordingError),
    /// More than can be held.
    #[error(transparent)]
    TooLarge(#[from] truegap_limits::TooLarge),
    /// There is no base model.
    #[error(transparent)]
    Base(#[from] BaseModelError),
    /// Nothing can be concluded.
    #[error("{recording}: {source}")]
    Diagnose { recording: String, source: DiagnoseError },
    /// Something is wrong with the recording, and the model has no answer to it.
    #[error("{recording}: {says}")]
    Untrusted { recording: String, says: String },
    /// A load that the sensor cannot bear.
    #[error(
        "{recording}, row {row}: {load} {unit} closes the gap of `{model}` (strain {strain:.3}); leave the row out, or describe a thicker or stiffer dielectric"
    )]
    GapCloses { recording: String, row: usize, load: f64, unit: &'static str, model: String, strain: f64 },
    /// No number came out.
    #[error(
        "{recording}, row {row}: `{model}` has no finite response there{parameters}; check load and temperature of the row, and the sensor's file or the simulator that was asked"
    )]
    NoAnswer { recording: String, row: usize, model: String, parameters: String },
    /// The files cannot be written.
    #[error(transparent)]
    Output(#[from] OutputError),
    /// The model file cannot be written.
    #[error(transparent)]
    ModelFile(#[from] ModelFileError),
    /// The answer cannot be written as JSON.
    #[error("the diagnosis cannot be written as JSON: {0}")]
    Json(#[from] serde_json::Error),
    /// A discovered mechanism cannot be written as TOML.
    #[error("the mechanism cannot be written as TOML: {0}")]
    Mechanism(#[from] toml::ser::Error),
    /// No recording.
    #[error("no recording is given; name a TOML or a CSV, or `example` for the built-in one")]
    NoRecording,
    /// Recordings that do not belong together.
    #[error("{second} has {what} `{second_has}` where {first} has `{first_has}`; diagnose them one at a time")]
    Different { first: String, second: String, what: &'static str, first_has: String, second_has: String },
    /// A recording with several sensors.
    #[error("{recording}: holds the sensors {names}; choose one with --channel, as in --channel \"{first}\"")]
    SeveralSensors { recording: String, names: String, first: String },
    /// No such sensor in the file.
    #[error("{recording}: there is no sensor column `{name}`; there are {names}")]
    NoSuchChannel { recording: String, name: String, names: String },
    /// A sensor column of a recording that has none.
    #[error(
        "{recording}: --channel {name} chooses among several sensors, and the table names none; leave it out, or name the column that is read: --map response=\"{name}\""
    )]
    NoChannels { recording: String, name: String },
    /// Recordings that cannot be joined.
    #[error(transparent)]
    Joint(#[from] truegap_diagnose::joint::JointError),
    /// Not a thing that a recording can have of its own.
    #[error(
        "--free {word} is not known; a recording may have its own gain, offset, or both: --free gain,offset (its clock is its own always; `clock` is for a recording that takes no part: truegap confirm)"
    )]
    UnknownFree { word: String },
    /// One recording has nothing to be compared with.
    #[error("--free gives each of several recordings a gain or offset against the first; name at least two, or leave --free out")]
    NothingToFree,
    /// A recording that is given twice, which would count each of its rows twice.
    #[error("{first} and {second} hold the same rows, which would count twice; leave one of them out")]
    SameRecording { first: String, second: String },
    /// A driver that one of several recordings lacks: a number in its place would be taken for physics.
    #[error(
        "{without}: has no driver `{name}`, which {with} has; name its column under [drivers], or take the driver out of {with}"
    )]
    DriverMissing { without: String, with: String, name: String },
    /// A driver that two recordings have in different units.
    #[error(
        "{second}: the driver `{name}` is in `{second_has}`, and in `{first_has}` in {first}; convert one of the columns, or correct its unit"
    )]
    DriverUnit { first: String, second: String, name: String, first_has: String, second_has: String },
    /// A column to be concealed that is not there.
    #[error("{recording}: there is no input column `{column}` to conceal; there are {names}")]
    NothingToConceal { recording: String, column: String, names: String },
    /// An effect that the library does not have.
    #[error("the library has no effect `{id}`; {hint}")]
    UnknownEffect { id: String, hint: String },
}
