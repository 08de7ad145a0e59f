//! Why a model file cannot be written, read or run: what, where, and what to write in its place.
//!
//! Limits: an error that is made without the name of its file is told with it by [`ModelFileError::of`].

use std::path::{Path, PathBuf};
use truegap_core::SimulationError;
use truegap_core::sensor::SensorError;
use truegap_diagnose::answer::UnknownEffect;
use truegap_model::BaseError;

/// Why a model file cannot be written, read or run.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
#[allow(missing_docs)] // the fields are named by the messages
pub enum ModelFileError {
    /// The file cannot be read.
    #[error("{file}: cannot be read: {source}; give the augmented.toml of a diagnosis")]
    Read { file: PathBuf, source: std::io::Error },
    /// Not TOML, or not a model.
    #[error("{file}: {message}; a model file is written by `truegap diagnose` as augmented.toml")]
    Parse { file: PathBuf, message: String },
    /// A document of a diagnosis.
    #[error("{file}: it is JSON, and a model file is TOML; give the augmented.toml that `truegap diagnose` wrote beside it")]
    Json { file: PathBuf },
    /// Another kind of file.
    #[error("{file}: schema is `{found}`; a model's is `truegap.model/1`")]
    Schema { file: PathBuf, found: String },
    /// What is wrong, and where.
    #[error("{file}: {}", without_place(.source))]
    In { file: PathBuf, source: Box<ModelFileError> },
    /// A key that means nothing.
    #[error("the model file: {table} has no key `{key}`; {instead}")]
    UnknownKey { table: String, key: String, instead: String },
    /// A verdict that no diagnosis comes to.
    #[error("the model file: verdict = \"{found}\" is none; use one of {known}")]
    Verdict { found: String, known: String },
    /// The sensor's file cannot be read.
    #[error("the sensor file {file} cannot be read: {source}; it must stay where it was while the model is written")]
    SensorFile { file: PathBuf, source: std::io::Error },
    /// The sensor inside is wrong.
    #[error("sensor of the model file: {0}")]
    Sensor(#[from] SensorError),
    /// The base model cannot be built.
    #[error(transparent)]
    Base(#[from] BaseError),
    /// A parameter of the base model is not there.
    #[error(
        "the model file gives no value for `{name}` of the base model `{model}`; add a [[parameter]] with its name, unit, value, sd"
    )]
    MissingParameter { name: String, model: String },
    /// A parameter that the base model does not have.
    #[error("the base model `{model}` has no parameter `{name}`; take the [[parameter]] out, or correct its name")]
    SurplusParameter { name: String, model: String },
    /// A number that an effect's equations need is not there.
    #[error(
        "the model file: the effect `{id}` gives no value for `{name}`; add {{ name = \"{name}\", unit = \"{unit}\", value = ..., sd = ... }} to its parameters"
    )]
    MissingNumber { id: String, name: String, unit: String },
    /// A number that an effect's equations do not have.
    #[error(
        "the model file: the effect `{id}` has no number `{name}`, which is {value} there; correct its name, or take it out; {instead}"
    )]
    SurplusNumber { id: String, name: String, value: f64, instead: String },
    /// A name that is given twice.
    #[error("the model file: {of} gives `{name}` twice, as {first} and as {second}; leave one of them out")]
    Twice { of: String, name: String, first: f64, second: f64 },
    /// An effect that is added twice.
    #[error("the model file: [[effect]] adds `{id}` twice; leave one of them out")]
    EffectTwice { id: String },
    /// A number that cannot be.
    #[error("the model file: {what} is {value}; write {wanted}")]
    Number { what: String, value: f64, wanted: &'static str },
    /// A number in a unit of another kind.
    #[error(
        "the model file: `{name}` of {of} is {value} in `{}`, where its unit is `{wanted}`; give its value in that unit, and write unit = \"{wanted}\"",
        .found.replace(char::is_control, " ")
    )]
    NumberUnit { of: String, name: String, value: f64, found: String, wanted: String },
    /// A column that an effect follows and the inputs do not have.
    #[error(
        "`{effect}` follows `{column}`, which the inputs do not have; name it under [drivers] as in the recording that the model was fitted to"
    )]
    MissingDriver { effect: String, column: String },
    /// An effect that the library does not have.
    #[error(transparent)]
    Effect(#[from] UnknownEffect),
    /// The model has no answer at these inputs.
    #[error(transparent)]
    Simulation(#[from] SimulationError),
    /// A unit that is not the model's.
    #[error("unit is `{found}`, and the base model `{model}` answers in {unit}; write unit = \"{unit}\"")]
    Unit { found: String, model: String, unit: String },
    /// The model cannot be written as TOML.
    #[error("the model cannot be written as TOML: {0}")]
    Write(#[from] toml::ser::Error),
}

/// The words of an error that is told with its file.
fn without_place(error: &ModelFileError) -> String {
    let says = error.to_string();
    says.strip_prefix("the model file: ").map_or(says.clone(), str::to_owned)
}

impl ModelFileError {
    /// The same, told with its file.
    #[must_use]
    pub fn of(self, file: &Path) -> Self {
        match self {
            Self::In { .. } | Self::Read { .. } | Self::Parse { .. } | Self::Schema { .. } => self,
            other => Self::In { file: file.to_owned(), source: Box::new(other) },
        }
    }
}
