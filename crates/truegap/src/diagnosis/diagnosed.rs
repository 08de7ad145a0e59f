//! A diagnosis with everything that its report needs, and the folder of files that tells it.
//!
//! Limits: what is there is replaced as a whole or left as it was.

use super::beside_model::hash_of_readings;
use super::{DiagnosisError, prediction};
use crate::diagnosis::report::{self, DISCOVERED, Provenance, Subject};
use crate::models::{Base, ModelFile, ModelFileError, Programs};
use crate::output::OutputFolder;
use std::path::{Path, PathBuf};
use truegap_core::Recording;
use truegap_diagnose::{Library, Outcome};

/// Names of the files that a diagnosis writes.
pub const FILES: [&str; 6] = ["diagnosis.json", "augmented.toml", "prediction.csv", "report.html", DISCOVERED[0], DISCOVERED[1]];

/// A recording and what was found in it.
pub struct Diagnosed {
    /// the recording as it was diagnosed; of several, all rows behind one another
    pub recording: Recording,
    /// each of several by itself
    pub parts: Vec<Recording>,
    /// its base model; of several recordings, the first one's
    pub base: Base,
    /// what was found
    pub outcome: Outcome,
    /// where it comes from
    pub provenance: Provenance,
    /// the effects that were known
    pub library: Library,
    /// who was asked where the base model is a program or a function
    pub programs: Programs,
}

impl Diagnosed {
    /// What the report is about.
    pub fn subject(&self) -> Subject<'_> {
        Subject {
            diagnosis: &self.outcome.diagnosis,
            traces: &self.outcome.traces,
            inputs: &self.recording.inputs,
            response: &self.recording.response,
            provenance: &self.provenance,
            library: &self.library,
        }
    }

    /// Every row with all predictions, as CSV.
    pub fn prediction_csv(&self) -> String {
        prediction::csv(&self.recording, &self.parts, &self.outcome.traces)
    }

    /// The columns of that CSV, not rounded.
    pub fn prediction_table(&self) -> Vec<(String, Vec<f64>)> {
        prediction::table(&self.recording, &self.parts, &self.outcome.traces)
    }

    /// Writes diagnosis.json, report.html, augmented.toml and prediction.csv, and discovered.toml where there is one, all or none.
    ///
    /// # Errors
    /// [`DiagnosisError`] where the disk refuses or the model cannot be written.
    pub fn write(&self, folder: &Path) -> Result<PathBuf, DiagnosisError> {
        let out = OutputFolder::begin(folder)?.replacing(&FILES);
        let json = serde_json::to_string_pretty(&self.outcome.diagnosis)?;
        out.write("diagnosis.json", json + "\n")?;
        out.write("augmented.toml", self.model_file()?.to_toml()?)?;
        out.write("prediction.csv", self.prediction_csv())?;
        out.write("report.html", report::html(&self.subject()))?;
        for (mechanism, name) in self.outcome.diagnosis.discovered.iter().zip(DISCOVERED) {
            let head = "# Written by `truegap diagnose`; `truegap diagnose OTHER --effect FILE` tries it on another recording.\n";
            out.write(name, head.to_owned() + &toml::to_string(&mechanism.file)?)?;
        }
        Ok(out.publish()?)
    }

    /// The model that the diagnosis ends with.
    ///
    /// # Errors
    /// [`ModelFileError::SensorFile`] where the sensor's own file has gone.
    pub fn model_file(&self) -> Result<ModelFile, ModelFileError> {
        let parts = if self.parts.is_empty() { std::slice::from_ref(&self.recording) } else { &self.parts };
        let readings: Vec<String> = parts.iter().map(hash_of_readings).collect();
        let drivers = self.recording.inputs.drivers.iter().map(|driver| (driver.name.clone(), driver.unit.clone())).collect();
        let file = ModelFile::of(&self.outcome, &self.base.spec, self.recording.path.parent())?;
        Ok(ModelFile { readings_sha256: Some(readings.join(" ")), drivers, ..file })
    }
}
