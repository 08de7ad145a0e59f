//! From what a recording says of its base model to the model itself.
//!
//! Limits: the further keys under `[base]` are `series` and nothing else.

use crate::sensors::{FindSensorError, find_sensor};
use truegap_audit::corrections::curves;
use truegap_core::{Corrections, Recording, Sensor, Simulator};
use truegap_model::{BaseError, BaseModel, Recorded, SeriesOrder, StackOptions};

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
    #[error("{recording}: under [base], `{key}` is not known; use model, sensor, warp, series")]
    UnknownKey { recording: String, key: String },
    /// A word that means nothing.
    #[error("{recording}: under [base], series = {found} is not known; use \"printed\" or \"exact\"")]
    Series { recording: String, found: String },
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
    let named = |source| BaseModelError::Model { recording: recording.path.display().to_string(), source };
    let options = base_options(recording)?;
    let asked = &recording.base;
    let recorded = Recorded { inputs: &recording.inputs, response: &recording.response, unit: &recording.response_unit };
    let spec = BaseModel::of(&asked.model, asked.sensor.as_deref(), options, recorded).map_err(named)?;
    let sensor = spec.sensor().map(|name| find_sensor(name, recording.path.parent())).transpose();
    let sensor = sensor.map_err(|source| BaseModelError::Sensor { recording: recording.path.display().to_string(), source })?;
    let simulator = spec.informed(sensor.as_ref(), sensor.as_ref().and_then(foreseen)).map_err(named)?;
    Ok(Base { spec, sensor, simulator })
}

/// What finite elements say of a sensor; `None` where their tables do not reach.
pub fn foreseen(sensor: &Sensor) -> Option<Corrections> {
    curves(sensor).ok()
}

/// Options of the stack that stand under `[base]`.
///
/// # Errors
/// [`BaseModelError`] for keys and words that mean nothing.
pub fn base_options(recording: &Recording) -> Result<StackOptions, BaseModelError> {
    let name = || recording.path.display().to_string();
    let further = &recording.base.further;
    if let Some(key) = further.keys().find(|key| *key != "series") {
        return Err(BaseModelError::UnknownKey { recording: name(), key: key.clone() });
    }
    let series = match further.get("series") {
        None => SeriesOrder::default(),
        Some(value) => value
            .as_str()
            .and_then(series_order)
            .ok_or_else(|| BaseModelError::Series { recording: name(), found: value.to_string() })?,
    };
    Ok(StackOptions { warp: recording.base.warp.unwrap_or(true), series })
}

/// The order of (19) and (21) that a word means: `printed` or `exact`.
pub fn series_order(word: &str) -> Option<SeriesOrder> {
    match word {
        "printed" => Some(SeriesOrder::IntegrateThenSeries),
        "exact" => Some(SeriesOrder::SeriesThenIntegrate),
        _ => None,
    }
}
