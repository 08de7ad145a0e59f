//! Sensors that come with truegap.
//!
//! Limits: their files are part of the program; edit a copy to change one.

use super::{description::Sensor, error::SensorError};

/// A sensor file that is part of the program.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct BuiltIn {
    /// name, as on the command line
    pub name: &'static str,
    /// text of the file
    pub toml: &'static str,
}

macro_rules! built_in {
    ($name:literal) => {
        BuiltIn { name: $name, toml: include_str!(concat!("../../../../meshes/sensors/", $name, ".toml")) }
    };
}

const SENSORS: [BuiltIn; 6] = [
    built_in!("singletact-s15-4.5n"),
    built_in!("singletact-s15-4.5n-stiffening"),
    built_in!("singletact-s8-optimised"),
    built_in!("foam-s15"),
    built_in!("single-metal-s15"),
    built_in!("mutual-s10"),
];

/// The built-in sensors, the default one first.
pub fn builtin_sensors() -> &'static [BuiltIn] {
    &SENSORS
}

/// A built-in sensor by name; `None` where there is none of that name.
///
/// # Errors
/// [`SensorError`] where its file is at fault, which the tests rule out.
pub fn builtin_sensor(name: &str) -> Option<Result<Sensor, SensorError>> {
    SENSORS.iter().find(|s| s.name == name).map(BuiltIn::sensor)
}

impl BuiltIn {
    /// The sensor of this file.
    ///
    /// # Errors
    /// As [`Sensor::from_toml`]; the tests rule it out.
    pub fn sensor(&self) -> Result<Sensor, SensorError> {
        Sensor::from_toml(self.toml, &format!("{}.toml", self.name))
    }
}
