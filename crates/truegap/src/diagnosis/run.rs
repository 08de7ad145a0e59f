//! A diagnosis with everything that its report needs.
//!
//! Limits: the base model is the recording's (or the request's); nothing is kept on disk here.

use super::request::{Request, named};
use super::{DiagnosisError, prediction, write};
use crate::base::{Base, base_model};
use crate::report::{Provenance, Subject};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};
use truegap_core::units::twelve_digits;
use truegap_core::{Recording, Role, SimulationError};
use truegap_diagnose::{DiagnoseError, Options, Outcome, Problem, Progress, RecordingFacts};

/// Said where the search was stopped.
const STOPPED: &str = "the search was stopped before its end: verdict and probabilities are among what had been tried by then";

/// A recording and what was found in it.
pub struct Diagnosed {
    /// the recording as it was diagnosed
    pub recording: Recording,
    /// its base model
    pub base: Base,
    /// what was found
    pub outcome: Outcome,
    /// where it comes from
    pub provenance: Provenance,
}

/// Diagnoses `recording`; `files` are what was read, with their SHA-256.
///
/// # Errors
/// [`DiagnosisError`] where there is no base model or nothing can be concluded.
pub fn diagnose(
    recording: Recording,
    files: Vec<(String, String)>,
    request: &Request,
    progress: &(dyn Fn(Progress) + Sync),
    stop: &AtomicBool,
) -> Result<Diagnosed, DiagnosisError> {
    let base = base_model(&recording)?;
    let problem = Problem { inputs: &recording.inputs, response: &recording.response, simulator: base.simulator.as_ref() };
    let options = Options { effects: request.effects.clone() };
    let outcome = truegap_diagnose::diagnose(&problem, facts(&recording, &files), &options, progress, stop);
    let mut outcome = outcome.map_err(|source| refused(source, &recording, &base))?;
    outcome.diagnosis.base.sensor = base.sensor.as_ref().map(|s| s.name.clone());
    let doubts = recording.notes.iter().map(ToString::to_string);
    outcome.diagnosis.recording_issues.extend(doubts);
    outcome
        .diagnosis
        .recording_issues
        .extend(request.conceal.iter().map(|c| format!("the column for {c} was hidden on request")));
    if stop.load(Ordering::Relaxed) {
        outcome.diagnosis.recording_issues.insert(0, STOPPED.to_owned());
    }
    let provenance = Provenance {
        command: request.command.clone(),
        made_at: write::utc_now(),
        files,
        interrupted: stop.load(Ordering::Relaxed),
        has_model: true,
    };
    Ok(Diagnosed { recording, base, outcome, provenance })
}

/// Rows are counted from 1 for the user, and the load carries its unit.
fn refused(source: DiagnoseError, recording: &Recording, base: &Base) -> DiagnosisError {
    let recording = named(recording);
    let DiagnoseError::Simulation(SimulationError::GapCloses { row, load_si, strain }) = source else {
        return DiagnosisError::Diagnose { recording, source };
    };
    let needs = base.simulator.needs();
    let unit = match needs.contains(&Role::Pressure) {
        true => "Pa",
        false if needs.contains(&Role::Gap) => "m",
        false => "N",
    };
    let model = base.sensor.as_ref().map_or_else(|| base.simulator.name().to_owned(), |s| s.name.clone());
    DiagnosisError::GapCloses { recording, row: row + 1, load: twelve_digits(load_si), unit, model, strain }
}

fn facts(recording: &Recording, files: &[(String, String)]) -> RecordingFacts {
    let names: Vec<&str> = files.iter().map(|(name, _)| name.as_str()).collect();
    let hashes: Vec<&str> = files.iter().map(|(_, hash)| hash.as_str()).collect();
    RecordingFacts {
        rows: recording.len(),
        runs: recording.inputs.runs().len(),
        sha256: hashes.join(" "),
        source: if names.is_empty() { named(recording) } else { names.join(", ") },
    }
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
        }
    }

    /// Every row with all predictions, as CSV.
    pub fn prediction_csv(&self) -> String {
        prediction::csv(&self.recording, &self.outcome.traces)
    }

    /// Writes diagnosis.json, report.html, augmented.toml and prediction.csv, all or none.
    ///
    /// # Errors
    /// [`DiagnosisError`] where the disk refuses or the model cannot be written.
    pub fn write(&self, folder: &Path) -> Result<PathBuf, DiagnosisError> {
        write::folder(self, folder)
    }
}
