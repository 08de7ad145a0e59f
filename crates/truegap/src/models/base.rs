//! From what a recording says of its base model to the model itself.
//!
//! Limits: a key that the model does not have is an error, whether another has it or none.

mod columns;
mod command;
mod declared;
mod identity;
mod kept;
mod process;
mod programs;
mod remembered;

pub use columns::columns;
pub use declared::declared;
use declared::{EXAMPLE, Undeclared};
pub use programs::{Function, Programs};
pub(crate) use remembered::SLOW_S;
pub use remembered::{Calls, Remembered};

use crate::predict::{FindSensorError, find_sensor, sensor_names};
use std::path::{Path, PathBuf};
use truegap_audit::corrections::curves;
use truegap_core::nearest::instead;
use truegap_core::recording::BaseSpec;
use truegap_core::{Corrections, Recording, RecordingError, Sensor, Simulator};
use truegap_model::{
    BaseError, BaseModel, BaseOptions, DRIVERS, ExternalOptions, GAIN_SD, Grid, GridError, Recorded, SeriesOrder, StackOptions,
};

/// Keys of their own that models have under `[base]`, beside `model` and `sensor`.
const KEYS: [(&str, &[&str]); 9] = [
    ("stack", &["warp", "series"]),
    ("parallel-plate", &[]),
    ("gap-plate", &[]),
    ("linear", &["driver", "order"]),
    ("table", &["table", "free", "gain", "offset"]),
    ("constant", &[]),
    ("external", &["free", "gain", "offset"]),
    ("command", &["run", "parameters", "timeout", "inside"]),
    ("function", &["run", "parameters", "timeout", "inside"]),
];

/// Whether a base model has a key under `[base]`; a model that is not known is refused by its name.
pub(crate) fn has_key(model: &str, key: &str) -> bool {
    KEYS.iter().find(|(name, _)| *name == model).is_none_or(|(_, keys)| keys.contains(&key))
}

/// Other words for them.
const OTHER_WORDS: [(&str, &str); 6] =
    [("program", "run"), ("command", "run"), ("cmd", "run"), ("name", "model"), ("type", "model"), ("degree", "order")];
/// Words for a driver.
const DRIVER_WORDS: &str = "\"force\", \"pressure\", \"gap\", \"temperature\", \"humidity\", \"time\" or a name under [drivers]";

/// Why there is no base model.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
#[allow(missing_docs)] // the fields are named by the messages
pub enum BaseModelError {
    /// No such sensor.
    #[error("{recording}: {source}")]
    Sensor { recording: String, source: FindSensorError },
    /// No such model, or not enough to build it.
    #[error("{recording}: {source}")]
    Model { recording: String, source: BaseError },
    /// A key that means nothing.
    #[error("{recording}: {table} has no key `{key}`; {instead}")]
    UnknownKey { recording: String, table: String, key: String, instead: String },
    /// A parameter of a program that cannot be.
    #[error("{recording}: [base.parameters]: `{name}` {why}; write {example}")]
    Parameter { recording: String, name: String, why: String, example: &'static str },
    /// A recording that does not say what it is to be compared with.
    #[error(
        "{recording}: neither a sensor nor a base model is named, and the columns found ({columns}) do not say what the load acted on; add {choices}, or write \
         model = \"...\" under [base] of the TOML beside it (docs/recordings.md)"
    )]
    Unstated { recording: String, columns: String, choices: String },
    /// A word that means nothing.
    #[error("{recording}: under [base], {key} = {found} is not known; use {use_}")]
    Word { recording: String, key: &'static str, found: String, use_: String },
    /// The table cannot be read.
    #[error("{recording}: its table: {source}")]
    TableFile { recording: String, source: RecordingError },
    /// What was read is no table.
    #[error("{file}: {source}")]
    Table { file: PathBuf, source: GridError },
}

/// The model that a recording is compared with, how it is described, and its sensor where it has one.
pub struct Base {
    /// description, from which the model can be built again
    pub spec: BaseModel,
    /// sensor of a `stack`
    pub sensor: Option<Sensor>,
    /// the model
    pub simulator: Box<dyn Simulator>,
}

/// The base model of a recording, priors scaled by it.
///
/// # Errors
/// [`BaseModelError`] where the model or its sensor is not known, or a column is missing.
pub fn base_model(recording: &Recording) -> Result<Base, BaseModelError> {
    base_model_with(recording, &Programs::default())
}

/// As [`base_model`], asking `programs` where the model is a program or a function.
///
/// # Errors
/// As [`base_model`].
pub fn base_model_with(recording: &Recording, programs: &Programs) -> Result<Base, BaseModelError> {
    let named = |source| BaseModelError::Model { recording: recording.path.display().to_string(), source };
    if !recording.base.is_stated() {
        return Err(unstated(recording));
    }
    let mut options = base_options(recording)?;
    if recording.base.model == "function" {
        options.asked = programs.function().cloned();
    }
    let asked = &recording.base;
    let recorded = Recorded { inputs: &recording.inputs, response: &recording.response, unit: &recording.response_unit };
    let spec = BaseModel::of(&asked.model, asked.sensor.as_deref(), options, recorded).map_err(named)?;
    let sensor = spec.sensor().map(|name| find_sensor(name, recording.path.parent())).transpose();
    let sensor = sensor.map_err(|source| BaseModelError::Sensor { recording: recording.path.display().to_string(), source })?;
    let simulator = programs.model(&spec, sensor.as_ref(), sensor.as_ref().and_then(foreseen)).map_err(named)?;
    Ok(Base { spec, sensor, simulator })
}

/// What a recording lacks that names no base model, and what may be written.
fn unstated(recording: &Recording) -> BaseModelError {
    let columns: Vec<String> = recording.columns.iter().map(|(role, name)| format!("{} = `{name}`", role.key())).collect();
    let mut choices = Vec::new();
    if recording.inputs.force_n.is_some() && recording.response_unit == "pF" {
        choices.push(format!("--sensor NAME for a sensor ({}, or its TOML)", sensor_names().join(", ")));
    }
    choices.push("--base parallel-plate for plates on foam or rubber of unknown size".to_owned());
    choices.push("--base linear for a straight line in the load".to_owned());
    BaseModelError::Unstated {
        recording: recording.path.display().to_string(),
        columns: columns.join(", "),
        choices: choices.join(", "),
    }
}

/// What finite elements say of a sensor; `None` where their tables do not reach.
pub fn foreseen(sensor: &Sensor) -> Option<Corrections> {
    curves(sensor).ok()
}

/// Options that stand under `[base]`.
///
/// # Errors
/// [`BaseModelError`] for keys and words that mean nothing, and for a table that cannot be read.
pub fn base_options(recording: &Recording) -> Result<BaseOptions, BaseModelError> {
    let name = || recording.path.display().to_string();
    let base = &recording.base;
    let further = &base.further;
    only_own_keys(base).map_err(|(key, instead)| BaseModelError::UnknownKey {
        recording: name(),
        table: "[base]".into(),
        key,
        instead,
    })?;
    let wrong = |key: &'static str, use_: &str| {
        let found = further.get(key).map(ToString::to_string).unwrap_or_default();
        BaseModelError::Word { recording: name(), key, found, use_: use_.to_owned() }
    };
    // a model file may be run from anywhere
    let beside = recording.path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let folder = &std::path::absolute(beside).unwrap_or_else(|_| beside.to_owned());
    let series = match further.get("series") {
        None => SeriesOrder::default(),
        Some(value) => value.as_str().and_then(series_order).ok_or_else(|| wrong("series", "\"printed\" or \"exact\""))?,
    };
    let word = |value: &toml::Value| value.as_str().and_then(|word| DRIVERS.into_iter().find(|role| role.key() == word));
    let named_driver = further.get("driver").and_then(|value| named_driver(recording, value));
    let role = further.get("driver").filter(|_| named_driver.is_none());
    let driver = role.map(|value| word(value).ok_or_else(|| wrong("driver", DRIVER_WORDS))).transpose()?;
    let whole = |value: &toml::Value| value.as_integer().and_then(|order| usize::try_from(order).ok());
    let order =
        further.get("order").map(|value| whole(value).ok_or_else(|| wrong("order", "a whole number from 1 to 6"))).transpose()?;
    Ok(BaseOptions {
        stack: StackOptions { warp: base.warp.unwrap_or(true), series },
        adjusted: adjusted(recording, &wrong)?,
        driver,
        named_driver,
        order,
        table: further.get("table").map(|value| table(recording, value)).transpose()?,
        asked: declared::command(further, folder).map_err(|undeclared| match undeclared {
            Undeclared::Word { key, use_ } => wrong(key, &use_),
            Undeclared::Key { table, key, instead } => BaseModelError::UnknownKey { recording: name(), table, key, instead },
            Undeclared::Parameter { name: parameter, why } => {
                BaseModelError::Parameter { recording: name(), name: parameter, why, example: EXAMPLE }
            }
        })?,
    })
}

/// Refuses a key under `[base]` that the model does not have: the key, and what may stand there.
fn only_own_keys(base: &BaseSpec) -> Result<(), (String, String)> {
    let given = base.further.keys().map(String::as_str).chain(base.warp.map(|_| "warp"));
    // of a model that is not known its name is refused, and here a key that none has
    let is_model = KEYS.iter().any(|(name, _)| *name == base.model);
    let own = KEYS.iter().filter(|(name, _)| *name == base.model || !is_model).flat_map(|(_, keys)| keys.iter().copied());
    let own: Vec<&str> = ["model", "sensor"].into_iter().chain(own).collect();
    let Some(key) = given.into_iter().find(|key| !own.contains(key)) else { return Ok(()) };
    let others: Vec<String> = KEYS
        .iter()
        .filter(|(name, keys)| *name != "function" && keys.contains(&key))
        .map(|(name, _)| format!("`{name}`"))
        .collect();
    let says = match others.as_slice() {
        [] => instead(key, &OTHER_WORDS, &own),
        others => {
            let (others, own) = (others.join(" and "), own.join(", "));
            format!("it is a key of {others}, and the model is `{}`; known there: {own}", base.model)
        }
    };
    Err((key.to_owned(), says))
}

/// The name of a column under `[drivers]`, where this is one.
fn named_driver(recording: &Recording, value: &toml::Value) -> Option<String> {
    let name = value.as_str()?;
    recording.inputs.drivers.iter().any(|driver| driver.name == name).then(|| name.to_owned())
}

/// What of a simulation or a table may be adjusted: an offset where nothing is said, since readings have a zero of their own.
fn adjusted(
    recording: &Recording,
    wrong: &dyn Fn(&'static str, &str) -> BaseModelError,
) -> Result<ExternalOptions, BaseModelError> {
    let further = &recording.base.further;
    let mut offset = true;
    if let Some(value) = further.get("free") {
        let words: Option<Vec<&str>> = value.as_array().and_then(|list| list.iter().map(toml::Value::as_str).collect());
        let words = words.filter(|words| words.iter().all(|word| matches!(*word, "gain" | "offset")));
        let words = words.ok_or_else(|| wrong("free", "[], [\"gain\"], [\"offset\"] or [\"gain\", \"offset\"]"))?;
        offset = words.contains(&"offset");
    }
    let mut about_1 = None;
    if let Some(value) = further.get("gain").filter(|value| !value.is_bool()) {
        let sd = value.as_float().or_else(|| value.as_integer().map(|sd| sd as f64)).filter(|sd| *sd > 0.0 && sd.is_finite());
        let use_ = "true, false, or its standard deviation about 1, as in gain = 0.05";
        about_1 = Some(sd.ok_or_else(|| wrong("gain", use_))?);
    }
    if let Some(value) = further.get("offset") {
        offset = value.as_bool().ok_or_else(|| wrong("offset", "true or false"))?;
    }
    let own_unit = recording.simulated_unit.clone().filter(|_| about_1.is_none());
    let unless_said = || if own_unit.is_some() { 10.0 * ratio(recording) } else { GAIN_SD };
    let gain_sd = recording.base.frees_gain().then(|| about_1.unwrap_or_else(unless_said));
    Ok(ExternalOptions { gain_sd, offset, own_unit })
}

/// Range of the response over that of the simulation: the size of a gain between two units. 1 where the simulation does not move.
fn ratio(recording: &Recording) -> f64 {
    let range = |column: &[f64]| {
        let finite = || column.iter().copied().filter(|value| value.is_finite());
        finite().fold(f64::NEG_INFINITY, f64::max) - finite().fold(f64::INFINITY, f64::min)
    };
    let simulated = recording.inputs.simulated.as_deref().map_or(0.0, range);
    Some(range(&recording.response) / simulated).filter(|ratio| ratio.is_finite() && *ratio > 0.0).unwrap_or(1.0)
}

/// The table that a recording's `[base]` names: a CSV as a recording is one, its file relative to the TOML.
fn table(recording: &Recording, value: &toml::Value) -> Result<Grid, BaseModelError> {
    let name = || recording.path.display().to_string();
    let file = value.as_str().ok_or_else(|| BaseModelError::Word {
        recording: name(),
        key: "table",
        found: value.to_string(),
        use_: "the name of a CSV in quotes".to_owned(),
    })?;
    let path = recording.path.parent().unwrap_or(Path::new("")).join(file);
    let read = Recording::open(&path).map_err(|source| BaseModelError::TableFile { recording: name(), source })?;
    Grid::of(&read.inputs, &read.response, &read.response_unit).map_err(|source| BaseModelError::Table { file: path, source })
}

/// The order of (19) and (21) that a word means: `printed` or `exact`.
pub fn series_order(word: &str) -> Option<SeriesOrder> {
    match word {
        "printed" => Some(SeriesOrder::IntegrateThenSeries),
        "exact" => Some(SeriesOrder::SeriesThenIntegrate),
        _ => None,
    }
}
