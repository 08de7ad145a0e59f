//! The TOML beside a CSV: which column is what, in which unit, and what the recording is to be compared with.
//!
//! Limits: one CSV a TOML; `[base]` may hold further keys, which the base model reads.

use super::{error::RecordingError, keys};
use crate::inputs::Role;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::path::Path;
use toml::Spanned;

/// Schema of a recording's TOML.
pub(super) const SCHEMA: &str = "truegap.recording/1";

/// The base model that the recording is to be compared with.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct BaseSpec {
    /// `stack`, `linear`, `table`, `parallel-plate`, `gap-plate`, `constant` or `external`; empty where the recording does not say
    pub model: String,
    /// built-in sensor or path of a sensor's TOML
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub sensor: Option<String>,
    /// whether the base model's electrode warps
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub warp: Option<bool>,
    /// what else stands under `[base]`
    #[serde(flatten)]
    pub further: toml::Table,
}

/// A text and its line.
#[derive(Clone, Debug)]
pub(super) struct Named {
    pub text: String,
    pub line: usize,
}

/// A column under `[drivers]`.
#[derive(Clone, Debug)]
pub(super) struct NamedDriver {
    pub name: String,
    pub column: String,
    pub unit: Option<String>,
    pub line: usize,
}

/// The TOML, checked.
#[derive(Clone, Debug, Default)]
pub(super) struct Manifest {
    pub file: String,
    pub columns: BTreeMap<Role, Named>,
    pub units: BTreeMap<Role, Named>,
    pub drivers: Vec<NamedDriver>,
    /// whether the day stands first in dates such as 01/03/2026
    pub dayfirst: Option<bool>,
    /// whether the response may be absent; no TOML says so
    pub inputs_alone: bool,
    pub base: Option<BaseSpec>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Raw {
    schema: Spanned<String>,
    file: String,
    /// whether the day stands first in dates such as 01/03/2026; needed where no date of the column shows it
    dayfirst: Option<bool>,
    #[serde(default)]
    columns: BTreeMap<Role, Spanned<String>>,
    #[serde(default)]
    units: BTreeMap<Role, Spanned<String>>,
    #[serde(default)]
    drivers: BTreeMap<String, Spanned<RawDriver>>,
    base: Option<BaseSpec>,
}

impl BaseSpec {
    /// Whether a base model is named, or follows from the columns.
    pub fn is_stated(&self) -> bool {
        !self.model.is_empty()
    }

    /// Whether the gain of a simulation may be adjusted: `free` holds `"gain"`, or `gain` is `true` or its standard deviation.
    pub fn frees_gain(&self) -> bool {
        let listed = self.further.get("free").and_then(toml::Value::as_array);
        match self.further.get("gain") {
            Some(gain) => gain.as_bool() != Some(false),
            None => listed.is_some_and(|words| words.iter().any(|word| word.as_str() == Some("gain"))),
        }
    }
}

/// A driver as it is written: `{ column = "...", unit = "..." }`.
#[derive(Deserialize)]
#[serde(deny_unknown_fields, expecting = "{ column = \"...\", unit = \"...\" }")]
struct RawDriver {
    column: String,
    unit: Option<String>,
}

impl Manifest {
    /// Reads a TOML; `path` is for messages.
    pub fn parse(path: &Path, text: &str) -> Result<Self, RecordingError> {
        let line = |byte: usize| 1 + text.bytes().take(byte).filter(|b| *b == b'\n').count();
        keys::check(path, text, line)?;
        let raw: Raw = toml::from_str(text).map_err(|error| RecordingError::Manifest {
            file: path.to_owned(),
            line: line(error.span().map_or(0, |span| span.start)),
            message: error.message().to_owned(),
        })?;
        if raw.schema.get_ref() != SCHEMA {
            let line = line(raw.schema.span().start);
            return Err(RecordingError::Schema { file: path.to_owned(), line, found: raw.schema.into_inner() });
        }
        let named = |table: BTreeMap<Role, Spanned<String>>| {
            table
                .into_iter()
                .map(|(role, text)| (role, Named { line: line(text.span().start), text: text.into_inner() }))
                .collect()
        };
        let driver = |(name, driver): (String, Spanned<RawDriver>)| {
            let line = line(driver.span().start);
            let RawDriver { column, unit } = driver.into_inner();
            NamedDriver { name, column, unit, line }
        };
        let drivers = raw.drivers.into_iter().map(driver).collect();
        let (columns, units) = (named(raw.columns), named(raw.units));
        Ok(Self { file: raw.file, columns, units, drivers, dayfirst: raw.dayfirst, inputs_alone: false, base: raw.base })
    }
}
