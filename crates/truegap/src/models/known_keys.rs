//! Whether the words of a model file mean something: each key is one that the file has, and its verdict is one of a diagnosis.
//!
//! Limits: a key is known by the file as it would be written again, so one that stands for nothing, as an empty list does, is passed over.

use super::model_file::ModelFile;
use super::model_file_error::ModelFileError;
use toml::{Table, Value};
use truegap_core::nearest::instead;
use truegap_diagnose::Verdict;

const VERDICTS: [Verdict; 6] =
    [Verdict::Agrees, Verdict::Explained, Verdict::Ambiguous, Verdict::WrongForm, Verdict::Unexplained, Verdict::Undecided];

/// Keys that are not written where they say nothing.
const UNWRITTEN: [&str; 1] = ["inside"];

impl ModelFile {
    /// Whether the verdict is one, and each key of `given`, which this file was read from, is known.
    ///
    /// # Errors
    /// [`ModelFileError::Verdict`] or [`ModelFileError::UnknownKey`].
    pub(super) fn check_words(&self, given: &Table) -> Result<(), ModelFileError> {
        let words = VERDICTS.map(Verdict::word);
        if !words.contains(&self.verdict.as_str()) {
            return Err(ModelFileError::Verdict { found: self.verdict.clone(), known: words.join(", ") });
        }
        let known = Table::try_from(self)?;
        match surplus("", given, &known) {
            None => Ok(()),
            Some((table, key, instead)) => Err(ModelFileError::UnknownKey { table, key, instead }),
        }
    }
}

/// The first key of `given` that `known` lacks: its table, itself, and what may stand there.
fn surplus(place: &str, given: &Table, known: &Table) -> Option<(String, String, String)> {
    given.iter().find_map(|(key, value)| match known.get(key) {
        None if says_nothing(value) || UNWRITTEN.contains(&key.as_str()) => None,
        None => {
            let keys: Vec<&str> = known.keys().map(String::as_str).collect();
            let table = if place.is_empty() { "the top".to_owned() } else { format!("[{place}]") };
            Some((table, key.clone(), instead(key, &[], &keys)))
        }
        Some(known) => inside(&if place.is_empty() { key.clone() } else { format!("{place}.{key}") }, value, known),
    })
}

fn inside(place: &str, given: &Value, known: &Value) -> Option<(String, String, String)> {
    match (given, known) {
        (Value::Table(given), Value::Table(known)) => surplus(place, given, known),
        (Value::Array(given), Value::Array(known)) => {
            given.iter().zip(known).find_map(|(given, known)| inside(place, given, known))
        }
        _ => None,
    }
}

fn says_nothing(value: &Value) -> bool {
    match value {
        Value::Array(list) => list.is_empty(),
        Value::Table(table) => table.is_empty(),
        _ => false,
    }
}
