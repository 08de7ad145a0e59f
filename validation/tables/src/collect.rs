//! The result file of the real recordings, from the folders that `truegap diagnose` wrote.
//!
//! Limits: reads `diagnosis.json` alone; a folder is named as its recording, with `--` where the recording's path has `/`.

use crate::{
    error::TablesError,
    real::{Finding, Real, Recording},
};
use serde::Deserialize;
use std::path::{Path, PathBuf};

/// The command that makes a folder.
const COMMAND: &str = "truegap diagnose $TRUEGAP_RECORDINGS/NAME.toml -o DIR/NAME";

/// The part of `diagnosis.json` that is kept.
#[derive(Deserialize)]
struct Diagnosis {
    recording: Facts,
    base: Base,
    verdict: String,
    findings: Vec<Found>,
    fit: Fit,
    seconds: f64,
}

#[derive(Deserialize)]
struct Facts {
    rows: u64,
    sha256: String,
}

#[derive(Deserialize)]
struct Base {
    model: String,
}

#[derive(Deserialize)]
struct Found {
    effect: String,
    probability: f64,
    rivals: Vec<String>,
}

#[derive(Deserialize)]
struct Fit {
    in_sample: Errors,
    held_out: Option<HeldOut>,
    noise_floor: f64,
    unit: String,
}

#[derive(Deserialize)]
struct Errors {
    rmse_before: f64,
    rmse_after: f64,
}

#[derive(Deserialize)]
struct HeldOut {
    rmse_before: Option<f64>,
    rmse_after: Option<f64>,
    shuffled_control: Option<f64>,
}

/// Answers in the folders of `dir`, in order of their names; files beside them are not looked at.
///
/// # Errors
/// [`TablesError`] where there is no folder, or one without a readable answer.
pub fn collect(dir: &Path) -> Result<Real, TablesError> {
    let mut folders: Vec<PathBuf> = Vec::new();
    for entry in std::fs::read_dir(dir).map_err(TablesError::at(dir))? {
        folders.push(entry.map_err(TablesError::at(dir))?.path());
    }
    folders.retain(|path| path.is_dir());
    folders.sort();
    if folders.is_empty() {
        return Err(TablesError::NoFolders { path: dir.to_owned() });
    }
    let recordings = folders.iter().map(|folder| recording(folder)).collect::<Result<_, _>>()?;
    Ok(Real { command: COMMAND.to_owned(), recordings })
}

fn recording(folder: &Path) -> Result<Recording, TablesError> {
    let path = folder.join("diagnosis.json");
    if !path.exists() {
        return Err(TablesError::NoAnswer { path: folder.to_owned() });
    }
    let text = std::fs::read_to_string(&path).map_err(TablesError::at(&path))?;
    let diagnosis: Diagnosis = serde_json::from_str(&text).map_err(|source| TablesError::Json { path, source })?;
    let name = folder.file_name().unwrap_or_default().to_string_lossy().replace("--", "/");
    Ok(record(name, diagnosis))
}

fn record(name: String, diagnosis: Diagnosis) -> Recording {
    let Diagnosis { recording, base, verdict, findings, fit, seconds } = diagnosis;
    let finding = |found: Found| Finding { effect: found.effect, probability: found.probability, rivals: found.rivals };
    Recording {
        name,
        sha256: recording.sha256.chars().take(12).collect(),
        rows: recording.rows,
        base: base.model,
        unit: fit.unit,
        verdict,
        findings: findings.into_iter().map(finding).collect(),
        in_sample: (fit.in_sample.rmse_before, fit.in_sample.rmse_after),
        held_out: fit.held_out.as_ref().and_then(|held_out| held_out.rmse_before.zip(held_out.rmse_after)),
        permutation_control: fit.held_out.and_then(|held_out| held_out.shuffled_control),
        noise: fit.noise_floor,
        seconds,
    }
}
