//! A sensor by its built-in name or from a file.
//!
//! Limits: what ends in `.toml` or holds a `/` is a file, anything else a name.

use std::path::{Path, PathBuf};
use truegap_core::Sensor;
use truegap_core::nearest::nearest;
use truegap_core::sensor::{SensorError, builtin_sensor, builtin_sensors};

/// The sensor that is taken where none is named.
pub const DEFAULT_SENSOR: &str = "singletact-s15-4.5n";

/// Why there is no such sensor.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
#[allow(missing_docs)] // the fields are named by the messages
pub enum FindSensorError {
    /// No built-in sensor has that name.
    #[error(
        "there is no sensor `{name}`; {hint}, or give the path of a sensor's TOML (`truegap sensors` lists what is built in)"
    )]
    Unknown { name: String, hint: String },
    /// The file cannot be read.
    #[error("{file}: cannot be read: {source}; give the path of a sensor's TOML, or a built-in name (`truegap sensors`)")]
    Read { file: PathBuf, source: std::io::Error },
    /// The file is wrong.
    #[error(transparent)]
    Sensor(#[from] SensorError),
}

/// The sensor that `name` means; a relative path is sought in `folder` first, then where the program runs.
///
/// # Errors
/// [`FindSensorError`] names what was sought and what comes close to it.
pub fn find_sensor(name: &str, folder: Option<&Path>) -> Result<Sensor, FindSensorError> {
    if !is_path(name) {
        let found = builtin_sensor(name).ok_or_else(|| unknown(name))?;
        return Ok(found?);
    }
    let inside = folder.map(|f| f.join(name)).filter(|path| path.is_file());
    let file = inside.unwrap_or_else(|| PathBuf::from(name));
    let text = truegap_limits::read_text(&file).map_err(|source| FindSensorError::Read { file: file.clone(), source })?;
    Ok(Sensor::from_toml(&text, &file.display().to_string())?)
}

/// Names of the sensors that are built in.
pub fn sensor_names() -> Vec<&'static str> {
    builtin_sensors().iter().map(|sensor| sensor.name).collect()
}

fn is_path(name: &str) -> bool {
    name.ends_with(".toml") || name.contains(['/', std::path::MAIN_SEPARATOR])
}

fn unknown(name: &str) -> FindSensorError {
    let names = || builtin_sensors().iter().map(|sensor| sensor.name);
    let close = nearest(name, names());
    let (lead, listed) = if close.is_empty() { ("built in are", names().collect()) } else { ("did you mean", close) };
    let listed: Vec<String> = listed.iter().map(|name| format!("`{name}`")).collect();
    FindSensorError::Unknown { name: name.to_owned(), hint: format!("{lead} {}", listed.join(" or ")) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_built_in_sensor_is_found_by_its_name() {
        for sensor in builtin_sensors() {
            assert_eq!(find_sensor(sensor.name, None).unwrap().name, sensor.name);
        }
        assert_eq!(find_sensor(DEFAULT_SENSOR, None).unwrap().full_scale, 4.5);
    }

    #[test]
    fn a_misspelt_name_is_answered_with_the_nearest() {
        let told = find_sensor("singletact-s15-45n", None).unwrap_err().to_string();
        assert!(told.contains("did you mean `singletact-s15-4.5n`"), "{told}");
        let told = find_sensor("zzzzzzzzzz", None).unwrap_err().to_string();
        assert!(told.contains("built in are `singletact-s15-4.5n`"), "{told}");
    }

    #[test]
    fn a_file_that_is_not_there_is_named() {
        let told = find_sensor("nowhere/s.toml", None).unwrap_err().to_string();
        assert!(told.contains("nowhere/s.toml") && told.contains("truegap sensors"), "{told}");
    }
}
