//! A sensor as text, so that a study can be sent elsewhere and is named by what the sensor is.
//!
//! Limits: comments in a sensor's file count: a changed comment is another study.

use crate::predict::{FindSensorError, find_sensor};
use serde::{Deserialize, Serialize};
use std::path::{Path, PathBuf};
use truegap_core::Sensor;
use truegap_core::sensor::{SensorError, builtin_sensors};

/// A sensor's file.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct SensorText {
    /// name of the sensor
    pub name: String,
    /// its file
    pub toml: String,
}

impl SensorText {
    /// The file that a built-in name or a path means.
    ///
    /// # Errors
    /// As [`find_sensor`].
    pub fn find(name: &str) -> Result<Self, FindSensorError> {
        let sensor = find_sensor(name, None)?;
        let built_in = builtin_sensors().iter().find(|b| b.name == name).map(|b| b.toml.to_owned());
        let read = || {
            truegap_limits::read_text(Path::new(name))
                .map_err(|source| FindSensorError::Read { file: PathBuf::from(name), source })
        };
        Ok(Self { name: sensor.name, toml: built_in.map_or_else(read, Ok)? })
    }

    /// The sensor.
    ///
    /// # Errors
    /// As [`Sensor::from_toml`].
    pub fn sensor(&self) -> Result<Sensor, SensorError> {
        Sensor::from_toml(&self.toml, &self.name)
    }
}
