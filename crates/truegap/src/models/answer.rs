//! What a model file answers at points, or along a recorded history.
//!
//! Limits: at a point the sensor has no past: every effect starts afresh there, so creep, lag and hysteresis show along a history only.

use crate::models::model_file::RunningModel;
use crate::models::model_file_error::ModelFileError;
use serde::Serialize;
use truegap_core::units::{Dimension, readable};
use truegap_core::{Inputs, Recording, Role, SimulationError};
use truegap_diagnose::Library;
use truegap_diagnose::experiment::{PROFILES, inputs};
use truegap_diagnose::text::listed;

/// Why a model file has no answer.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
#[allow(missing_docs)] // the fields are named by the messages
pub enum AnswerError {
    /// A base model whose load cannot be typed.
    #[error(
        "the base model `{model}` follows {needs}, and --load gives a force or a pressure alone; give --drive RECORDING, which has the columns"
    )]
    NoLoad { model: String, needs: String },
    /// A base model that a profile does not drive.
    #[error(
        "the base model `{model}` follows {needs}, and a profile has time, load and temperature alone; give --drive RECORDING, which has the columns"
    )]
    NoProfileSuits { model: String, needs: String },
    /// A profile that nobody knows.
    #[error("there is no profile `{name}`; use one of {}", PROFILES.iter().map(|p| p.name).collect::<Vec<_>>().join(", "))]
    NoProfile { name: String },
    /// The plates touch.
    #[error("{place} closes the gap (strain {strain:.3}); stay below that load")]
    GapCloses { place: String, strain: f64 },
    /// No number, or one that is not finite, came out.
    #[error(
        "{place}: the model has no finite response there; check load and temperature there, and the numbers of the model file"
    )]
    NotFinite { place: String },
    /// A place that a table does not hold.
    #[error(
        "{place}: {column} is {value} (SI), outside the table of the model, which goes from {low} to {high}; stay within the table, or leave the row out"
    )]
    OutsideTable { place: String, column: &'static str, value: f64, low: f64, high: f64 },
    /// A column that is missing.
    #[error(
        "{place}: there is no column for {column}, which `{effect}` needs; name it with --map {column}=COLUMN, or under [columns] of its TOML"
    )]
    NoColumn { place: String, column: &'static str, effect: String },
    /// A column that is missing, or an effect that cannot be.
    #[error("{place}: {source}")]
    Model { place: String, source: ModelFileError },
}

/// One answer.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Answer {
    /// run of the row; absent at a point
    #[serde(skip_serializing_if = "Option::is_none")]
    pub run: Option<u32>,
    /// clock, s
    #[serde(skip_serializing_if = "Option::is_none")]
    pub time_s: Option<f64>,
    /// load, N
    #[serde(skip_serializing_if = "Option::is_none")]
    pub force_n: Option<f64>,
    /// load, Pa
    #[serde(skip_serializing_if = "Option::is_none")]
    pub pressure_pa: Option<f64>,
    /// separation of the plates, m
    #[serde(skip_serializing_if = "Option::is_none")]
    pub gap_m: Option<f64>,
    /// thermometer, degrees Celsius
    #[serde(skip_serializing_if = "Option::is_none")]
    pub temperature_c: Option<f64>,
    /// response, in `unit`
    pub response: f64,
    /// unit of the response
    pub unit: String,
}

/// What `--load` gives to this model: a force or a pressure.
///
/// # Errors
/// [`AnswerError::NoLoad`] for a model that is loaded by neither.
pub fn load_dimension(model: &RunningModel) -> Result<Dimension, AnswerError> {
    let needs = model.simulator().needs();
    if needs.contains(&Role::Force) {
        Ok(Dimension::Force)
    } else if needs.contains(&Role::Pressure) {
        Ok(Dimension::Pressure)
    } else {
        Err(AnswerError::NoLoad { model: model.simulator().name().to_owned(), needs: needed(model) })
    }
}

/// What a model needs, in the words of `[columns]` and `[drivers]`.
fn needed(model: &RunningModel) -> String {
    let needs: Vec<String> = model.simulator().needs().iter().map(|role| format!("the column `{}`", role.key())).collect();
    if needs.is_empty() { "no load".to_owned() } else { listed(&needs, "and") }
}

/// The model at every load (N or Pa, by [`load_dimension`]) and temperature (degrees Celsius), each point by itself.
///
/// # Errors
/// [`AnswerError`] for the first point that has no answer.
pub fn at_points(model: &RunningModel, loads: &[f64], temperatures_c: &[f64]) -> Result<Vec<Answer>, AnswerError> {
    let dimension = load_dimension(model)?;
    let points = temperatures_c.iter().flat_map(|&t| loads.iter().map(move |&load| (load, t)));
    points
        .map(|(load, temperature_c)| {
            let column = |of: Dimension| (dimension == of).then(|| vec![load]);
            let inputs = Inputs {
                run: vec![1],
                time_s: Some(vec![0.0]),
                force_n: column(Dimension::Force),
                pressure_pa: column(Dimension::Pressure),
                temperature_c: Some(vec![temperature_c]),
                ..Inputs::default()
            };
            let [load, temperature] = [load, temperature_c].map(readable);
            let place = |_| format!("{load} {} at {temperature} degC", dimension.si_unit());
            let response = model.respond(&inputs).map_err(|error| refused(error, place))?;
            let answer = answer(&inputs, 0, response[0], model);
            Ok(Answer { run: None, time_s: None, ..answer })
        })
        .collect()
}

/// The model along the rows of a recording, effects with a memory included.
///
/// # Errors
/// [`AnswerError`] for the first row that has no answer, or a column that is not there.
pub fn along(model: &RunningModel, recording: &Recording) -> Result<Vec<Answer>, AnswerError> {
    let place = of_recording(recording.path.display().to_string());
    if let (None, Some(effect)) = (&recording.inputs.temperature_c, model.follows_temperature(&Library::default())) {
        return Err(AnswerError::NoColumn { place: place(None), column: Role::Temperature.key(), effect });
    }
    let mut followed = recording.inputs.clone();
    model.as_followed(&mut followed);
    let responses = model.respond(&followed).map_err(|error| refused(error, place))?;
    Ok(responses.into_iter().enumerate().map(|(row, response)| answer(&recording.inputs, row, response, model)).collect())
}

/// The model along one of the built-in profiles, as a next experiment names them, up to its full load.
///
/// # Errors
/// [`AnswerError::NoProfile`] for a name that is none, else as [`along`].
pub fn on_profile(model: &RunningModel, name: &str) -> Result<Vec<Answer>, AnswerError> {
    let profile = PROFILES.iter().find(|p| p.name == name).ok_or_else(|| AnswerError::NoProfile { name: name.to_owned() })?;
    let simulator = model.simulator();
    let in_profile = |role: &Role| matches!(role, Role::Time | Role::Force | Role::Pressure | Role::Temperature);
    if !simulator.needs().iter().all(in_profile) {
        return Err(AnswerError::NoProfileSuits { model: simulator.name().to_owned(), needs: needed(model) });
    }
    let role = if simulator.needs().contains(&Role::Pressure) { Role::Pressure } else { Role::Force };
    let inputs = inputs(profile, simulator.full_load().unwrap_or(0.0), role, simulator.reference_c());
    let responses = model.respond(&inputs).map_err(|error| refused(error, of_recording(format!("profile {name}"))))?;
    Ok(responses.into_iter().enumerate().map(|(row, response)| answer(&inputs, row, response, model)).collect())
}

fn answer(inputs: &Inputs, row: usize, response: f64, model: &RunningModel) -> Answer {
    let at = |column: &Option<Vec<f64>>| column.as_ref().map(|values| values[row]);
    Answer {
        run: Some(inputs.run[row]),
        time_s: at(&inputs.time_s),
        force_n: at(&inputs.force_n),
        pressure_pa: at(&inputs.pressure_pa),
        gap_m: at(&inputs.gap_m),
        temperature_c: at(&inputs.temperature_c),
        response,
        unit: model.simulator().unit().to_owned(),
    }
}

/// A place in a recording, rows counted from 1.
pub(crate) fn of_recording(name: String) -> impl Fn(Option<usize>) -> String {
    move |row| row.map_or_else(|| name.clone(), |row| format!("{name}, row {}", row + 1))
}

/// The error with its place, given the row where one is known.
pub(crate) fn refused(error: ModelFileError, place: impl Fn(Option<usize>) -> String) -> AnswerError {
    match error {
        ModelFileError::Simulation(SimulationError::GapCloses { row, strain, .. }) => {
            AnswerError::GapCloses { place: place(Some(row)), strain }
        }
        ModelFileError::Simulation(SimulationError::NotFinite { row, .. }) => AnswerError::NotFinite { place: place(Some(row)) },
        ModelFileError::Simulation(SimulationError::OutsideTable { row, role, value, low, high }) => {
            AnswerError::OutsideTable { place: place(Some(row)), column: role.key(), value, low, high }
        }
        source => AnswerError::Model { place: place(None), source },
    }
}
