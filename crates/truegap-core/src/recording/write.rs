//! A recording as `recording.csv` and `recording.toml`, so that reading them back gives the same numbers.
//!
//! Limits: columns are written in SI (response in its own unit) with the shortest digits that read back exactly; the folder must exist.

use super::{
    data::Recording,
    error::RecordingError,
    manifest::{BaseSpec, SCHEMA},
    roles::ROLES,
    table::hexadecimal,
};
use crate::inputs::{Driver, Role};
use serde::Serialize;
use sha2::{Digest, Sha256};
use std::collections::BTreeMap;
use std::fs::{self, File};
use std::io::{self, BufWriter, Write};
use std::path::Path;

impl Recording {
    /// Writes `recording.csv` and `recording.toml` into a folder that exists.
    ///
    /// # Errors
    /// [`RecordingError::Write`] where the folder does not take them.
    pub fn write(&self, folder: impl AsRef<Path>) -> Result<(), RecordingError> {
        let folder = folder.as_ref();
        let csv = folder.join("recording.csv");
        let written = File::create(&csv).and_then(|file| write_csv(self, BufWriter::new(file)));
        written.map_err(|source| RecordingError::Write { file: csv, source })?;
        let file = folder.join("recording.toml");
        let text = self.manifest_text().map_err(|message| RecordingError::NotToml { file: file.clone(), message })?;
        fs::write(&file, text).map_err(|source| RecordingError::Write { file, source })
    }

    fn manifest_text(&self) -> Result<String, String> {
        let named = names(self).into_iter().map(|(role, name)| (role.key(), name)).collect();
        let units = [(Role::Response, &self.response_unit)]
            .into_iter()
            .filter(|(_, unit)| *unit != "pF" && self.recorded_response().is_some());
        let units = units.chain(self.simulated_unit.iter().map(|unit| (Role::Simulated, unit)));
        let units = units.map(|(role, unit)| (role.key(), unit.clone())).collect();
        let driver = |d: &Driver| (d.name.clone(), WrittenDriver { column: heading(d), unit: d.unit.clone() });
        let manifest = Written {
            schema: SCHEMA,
            file: "recording.csv",
            columns: named,
            units,
            drivers: self.inputs.drivers.iter().map(driver).collect(),
            base: Some(&self.base).filter(|base| base.is_stated()),
        };
        toml::to_string(&manifest).map_err(|error| error.to_string())
    }
}

#[derive(Serialize)]
struct Written<'a> {
    schema: &'a str,
    file: &'a str,
    columns: BTreeMap<&'a str, String>,
    #[serde(skip_serializing_if = "BTreeMap::is_empty")]
    units: BTreeMap<&'a str, String>,
    #[serde(skip_serializing_if = "BTreeMap::is_empty")]
    drivers: BTreeMap<String, WrittenDriver>,
    #[serde(skip_serializing_if = "Option::is_none")]
    base: Option<&'a BaseSpec>,
}

#[derive(Serialize)]
struct WrittenDriver {
    column: String,
    unit: String,
}

/// Name of a driver's column as it is written, which is no role's.
fn heading(driver: &Driver) -> String {
    format!("driver_{}", driver.name)
}

/// Name of each column as it is written.
pub(super) fn names(recording: &Recording) -> BTreeMap<Role, String> {
    let mut names: BTreeMap<Role, String> =
        recording.quantities().into_iter().map(|(role, _)| (role, name(role, recording).to_owned())).collect();
    names.insert(Role::Run, "run".to_owned());
    if recording.sensors.is_some() {
        names.insert(Role::Sensor, "sensor".to_owned());
    }
    names
}

fn name(role: Role, recording: &Recording) -> &'static str {
    match role {
        Role::Response if recording.response_unit == "pF" => "capacitance_pf",
        other => other.column_name(),
    }
}

/// SHA-256 of the CSV as it would be written.
pub(super) fn sha256(recording: &Recording) -> Result<String, RecordingError> {
    let mut sink = Sink(Sha256::new());
    let written = write_csv(recording, &mut sink);
    written.map_err(|source| RecordingError::Write { file: "recording.csv".into(), source })?;
    Ok(hexadecimal(sink.0))
}

struct Sink(Sha256);

impl Write for Sink {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.0.update(bytes);
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

fn write_csv(recording: &Recording, sink: impl Write) -> io::Result<()> {
    let names = names(recording);
    let quantities: BTreeMap<Role, &[f64]> = recording.quantities().into_iter().collect();
    let roles: Vec<Role> = ROLES.into_iter().filter(|role| names.contains_key(role)).collect();
    let mut csv = csv::Writer::from_writer(sink);
    let drivers = &recording.inputs.drivers;
    csv.write_record(roles.iter().filter_map(|role| names.get(role)).cloned().chain(drivers.iter().map(heading)))?;
    for row in 0..recording.len() {
        for role in &roles {
            csv.write_field(cell(recording, &quantities, *role, row))?;
        }
        for driver in drivers {
            csv.write_field(driver.values[row].to_string())?;
        }
        csv.write_record(None::<&[u8]>)?;
    }
    csv.flush()
}

fn cell(recording: &Recording, quantities: &BTreeMap<Role, &[f64]>, role: Role, row: usize) -> String {
    match (role, &recording.sensors) {
        (Role::Run, _) => recording.inputs.run[row].to_string(),
        (Role::Sensor, Some(sensors)) => sensors.names.get(sensors.of_row[row] as usize).cloned().unwrap_or_default(),
        _ => quantities.get(&role).map(|column| column[row].to_string()).unwrap_or_default(),
    }
}
