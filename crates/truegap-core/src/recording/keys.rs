//! Keys of a recording's TOML that mean nothing: which, in which table, and what was meant.
//!
//! Limits: the tables that every recording has; what stands under `[base]` is the base model's.

use super::{error::RecordingError, roles::ROLES};
use crate::nearest::{instead, meant};
use std::path::Path;
use toml::Spanned;
use toml::de::{DeString, DeTable, DeValue};

/// Keys of the whole.
const TOP: [&str; 7] = ["schema", "file", "dayfirst", "columns", "units", "drivers", "base"];
/// Keys of a driver.
const DRIVER: [&str; 2] = ["column", "unit"];
/// Keys that stand under `[base]`; `truegap init` writes that line as a comment, and who takes the next one out of its comment may leave it. A `run` that is a text is the column that numbers the runs: a
/// program is a list.
const BASE: [&str; 2] = ["model", "run"];
const UNDER_BASE: &str = "it belongs under [base]: write that line above it";
/// Keys that every file has, and what to write.
const NEEDED: [(&str, &str); 2] = [
    ("schema", "schema = \"truegap.recording/1\" as its first line"),
    ("file", "file = \"NAME.csv\" above the first table, the name of the table that it describes"),
];
/// Other words for a role.
pub(super) const ROLES_CALLED: [(&str, &str); 14] = [
    ("t", "time"),
    ("f", "force"),
    ("load", "force"),
    ("p", "pressure"),
    ("t_c", "temperature"),
    ("thermometer", "temperature"),
    ("rh", "humidity"),
    ("capacitance", "response"),
    ("cap", "response"),
    ("c", "response"),
    ("reading", "response"),
    ("signal", "response"),
    ("output", "response"),
    ("simulation", "simulated"),
];

/// Refuses a key that means nothing.
pub(super) fn check(file: &Path, text: &str, line: impl Fn(usize) -> usize) -> Result<(), RecordingError> {
    // what is no TOML is told by whoever reads it
    let Ok(table) = DeTable::parse(text) else { return Ok(()) };
    let roles = ROLES.map(crate::inputs::Role::key);
    let refuse = |table: &str, key: &Spanned<DeString<'_>>, synonyms: &[(&str, &'static str)], known: &[&str]| {
        let name = key.get_ref().to_string();
        let (line, instead) = (line(key.span().start), instead(&name, synonyms, known));
        RecordingError::UnknownKey { file: file.to_owned(), line, table: table.to_owned(), key: name, instead }
    };
    for (key, value) in table.get_ref() {
        let name: &str = key.get_ref();
        if !TOP.contains(&name) {
            return Err(refuse("the file", key, &[("csv", "file"), ("data", "file"), ("model", "base")], &TOP));
        }
        let Some(inner) = inner(value) else {
            no_table(name, value).map_or(Ok(()), |says| Err(told(file, line(key.span().start), says)))?;
            continue;
        };
        for (key, value) in inner {
            let name_inside: &str = key.get_ref();
            if name == "base" && !inner.contains_key("model") && meant(name_inside, &["model"]).is_some() {
                return Err(refuse("[base]", key, &[], &["model", "sensor", "warp"]));
            }
            let is_column = roles.contains(&name_inside) && matches!(value.get_ref(), DeValue::String(_));
            let of_base = BASE.contains(&name_inside) && !is_column && !table.get_ref().contains_key("base");
            if matches!(name, "columns" | "units") && of_base {
                let at = line(key.span().start);
                let (file, key, instead) = (file.to_owned(), name_inside.to_owned(), UNDER_BASE.to_owned());
                return Err(RecordingError::UnknownKey { file, line: at, table: format!("[{name}]"), key, instead });
            }
            if matches!(name, "columns" | "units") && !roles.contains(&name_inside) {
                return Err(refuse(&format!("[{name}]"), key, &ROLES_CALLED, &roles));
            }
            let driver = inner_of_driver(name, value);
            let known = |key: &Spanned<DeString<'_>>| DRIVER.contains(&key.get_ref().as_ref());
            if let Some((key, _)) = driver.and_then(|keys| keys.iter().find(|(key, _)| !known(key))) {
                return Err(refuse(&format!("[drivers], {name_inside}"), key, &[("name", "column")], &DRIVER));
            }
        }
        if name == "base" && !inner.contains_key("model") {
            let says = "[base] names no model; write model = \"linear\" below it, or another one of docs/recordings.md";
            return Err(told(file, line(key.span().start), says.to_owned()));
        }
    }
    let missing = NEEDED.into_iter().find(|(key, _)| !table.get_ref().contains_key(*key));
    missing.map_or(Ok(()), |(key, write)| Err(told(file, 1, format!("the file has no `{key}`; write {write}"))))
}

fn told(file: &Path, line: usize, message: String) -> RecordingError {
    RecordingError::Manifest { file: file.to_owned(), line, message }
}

/// What to write where a word stands in place of a table.
fn no_table(name: &str, value: &Spanned<DeValue<'_>>) -> Option<String> {
    let example = match name {
        "base" => match value.get_ref() {
            DeValue::String(model) => format!("model = \"{model}\""),
            _ => "model = \"linear\"".to_owned(),
        },
        "columns" => "response = \"NAME\"".to_owned(),
        "units" => "response = \"mV\"".to_owned(),
        "drivers" => "position = { column = \"NAME\", unit = \"mm\" }".to_owned(),
        _ => return None,
    };
    Some(format!("`{name}` is a table; write [{name}] on a line of its own, and below it {example}"))
}

fn inner<'a, 'i>(value: &'a Spanned<DeValue<'i>>) -> Option<&'a DeTable<'i>> {
    match value.get_ref() {
        DeValue::Table(table) => Some(table),
        _ => None,
    }
}

fn inner_of_driver<'a, 'i>(table: &str, value: &'a Spanned<DeValue<'i>>) -> Option<&'a DeTable<'i>> {
    inner(value).filter(|_| table == "drivers")
}
