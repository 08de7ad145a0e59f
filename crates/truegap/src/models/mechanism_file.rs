//! Effects of one's own from files: `truegap diagnose ... --effect FILE`.
//!
//! Limits: one mechanism a file; its format is that of [`truegap_diagnose::mechanism::MechanismFile`].

use serde::de::DeserializeOwned;
use std::path::{Path, PathBuf};
use truegap_core::Recording;
use truegap_core::nearest::instead;
use truegap_diagnose::Library;
use truegap_diagnose::mechanism::{Action, Driver, Form, Kinetics, MechanismError, MechanismFile, Quantity, Sum};

/// Keys of a mechanism's file.
const KEYS: [&str; 19] = [
    "schema",
    "id",
    "says",
    "quantity",
    "action",
    "driver",
    "kinetics",
    "form",
    "even",
    "below",
    "passing",
    "sum",
    "size",
    "tau",
    "width",
    "threshold",
    "exponent",
    "scale",
    "period",
];
/// Keys of one of its numbers.
const NUMBER: [&str; 3] = ["value", "sd", "unit"];
/// Other words for them.
const OTHER_WORDS: [(&str, &str); 5] =
    [("place", "quantity"), ("follows", "driver"), ("law", "form"), ("time_constant", "tau"), ("name", "id")];

/// Why a file is no effect.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
#[allow(missing_docs)] // the fields are named by the messages
pub enum EffectFileError {
    /// The file cannot be read.
    #[error("{file}: cannot be read: {source}; give a mechanism's TOML, as `discovered.toml` of a diagnosis")]
    Read { file: PathBuf, source: std::io::Error },
    /// Not TOML, or not these words.
    #[error("{file}: {message}; docs/mechanisms.md lists the words")]
    Parse { file: PathBuf, message: String },
    /// Words without their numbers, or numbers that cannot be.
    #[error("{file}: {source}")]
    Mechanism { file: PathBuf, source: MechanismError },
    /// A name that is taken.
    #[error("{file}: the library has an effect `{id}` already; give yours another id")]
    Taken { file: PathBuf, id: String },
}

/// What a file describes.
fn read(file: &Path) -> Result<MechanismFile, EffectFileError> {
    let text = truegap_limits::read_text(file).map_err(|source| EffectFileError::Read { file: file.to_owned(), source })?;
    let refused = |message: String| EffectFileError::Parse { file: file.to_owned(), message };
    let table: toml::Table = toml::from_str(&text).map_err(|error| {
        let line = 1 + text.bytes().take(error.span().map_or(0, |span| span.start)).filter(|b| *b == b'\n').count();
        refused(format!("line {line}: {}", error.message()))
    })?;
    words(&table).map_err(refused)?;
    toml::from_str(&text).map_err(|error| refused(error.message().to_owned()))
}

/// Refuses a key or a word that means nothing, by the name of its key.
fn words(table: &toml::Table) -> Result<(), String> {
    let known: Vec<&str> = KEYS.into_iter().chain(["phase"]).collect();
    if let Some(key) = table.keys().find(|key| !known.contains(&key.as_str())) {
        return Err(format!("a mechanism has no key `{key}`; {}", instead(key, &OTHER_WORDS, &known)));
    }
    for (name, number) in
        table.iter().filter_map(|(name, value)| Some((name, value.as_table()?))).filter(|(name, _)| *name != "driver")
    {
        if let Some(key) = number.keys().find(|key| !NUMBER.contains(&key.as_str())) {
            return Err(format!(
                "{name} has no key `{key}`; {}",
                instead(key, &[("std", "sd"), ("sigma", "sd"), ("mean", "value")], &NUMBER)
            ));
        }
    }
    word::<Quantity>(table, "quantity")?;
    word::<Action>(table, "action")?;
    word::<Driver>(table, "driver")?;
    word::<Kinetics>(table, "kinetics")?;
    word::<Form>(table, "form")?;
    word::<Sum>(table, "sum")
}

fn word<T: DeserializeOwned>(table: &toml::Table, key: &str) -> Result<(), String> {
    let Some(value) = table.get(key) else { return Ok(()) };
    T::deserialize(value.clone()).map(|_| ()).map_err(|error| format!("{key} = {value}: {}", error.message()))
}

/// The library with the effects of these files, their numbers in the units that `recording` gives them.
///
/// # Errors
/// [`EffectFileError`] where a file is not there or describes no effect; [`EffectFileError::Taken`] where an id is in the library.
pub fn with_effects(library: Library, files: &[PathBuf], recording: Option<&Recording>) -> Result<Library, EffectFileError> {
    files.iter().try_fold(library, |library, file| {
        let refused = |source| EffectFileError::Mechanism { file: file.clone(), source };
        let mechanism = read(file)?;
        let effect = mechanism.effect().map_err(refused)?;
        if let Some(recording) = recording {
            mechanism.check_units(&recording.inputs, &recording.response_unit).map_err(refused)?;
        }
        if library.find(effect.id.0).is_some() {
            return Err(EffectFileError::Taken { file: file.clone(), id: effect.id.0.to_owned() });
        }
        Ok(library.with(Box::new(effect)))
    })
}
