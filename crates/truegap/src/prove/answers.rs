//! Diagnoses every recording of a study that has no diagnosis yet.
//!
//! Limits: opens `CASE/recording.toml` and its CSV only, never the key; a diagnosis that was broken off is not kept.

use super::error::{ProveError, read};
use super::{process, sparse};
use crate::diagnosis::{Diagnosed, Request, diagnose, open};
use crate::output::OutputFolder;
use std::path::Path;
use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use truegap_core::Recording;
use truegap_generator::study::WITHOUT;

/// One case is done.
#[derive(Clone, Debug)]
pub struct Told {
    /// its name
    pub case: String,
    /// how many have been diagnosed by this call
    pub done: usize,
    /// how many it has to diagnose
    pub of: usize,
}

/// How far the diagnoses have got.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Answered {
    /// cases with a diagnosis on disk
    pub diagnosed: usize,
    /// cases of the study
    pub cases: usize,
    /// cases that the diagnosis refused, with its reason
    pub refused: Vec<(String, String)>,
}

impl Answered {
    /// Whether every case was diagnosed or refused.
    pub fn is_complete(&self) -> bool {
        self.diagnosed + self.refused.len() == self.cases
    }
}

/// Names of the study's cases, in order.
///
/// # Errors
/// [`ProveError::File`] without `commitments.txt`.
pub fn cases(folder: &Path) -> Result<Vec<String>, ProveError> {
    let commitments = read(&folder.join("commitments.txt"))?;
    let files = commitments.lines().filter_map(|line| line.split_once("  "));
    Ok(files.map(|(_, file)| file.trim_end_matches(".json").to_owned()).collect())
}

/// Diagnoses what is left to diagnose, `jobs` at a time; `stop` ends it, and what is done is kept.
///
/// # Errors
/// [`ProveError`] where the study cannot be read or a diagnosis not be written; a recording that is refused goes into [`Answered::refused`].
pub fn answer(folder: &Path, jobs: usize, told: &(dyn Fn(Told) + Sync), stop: &AtomicBool) -> Result<Answered, ProveError> {
    let cases = cases(folder)?;
    let left: Vec<&String> = cases.iter().filter(|case| !place(folder, case).join("diagnosis.json").exists()).collect();
    let (next, done) = (AtomicUsize::new(0), AtomicUsize::new(0));
    let refused = Mutex::new(Vec::new());
    let failed = Mutex::new(None);
    let work = || {
        while let Some(case) = left.get(next.fetch_add(1, Ordering::Relaxed)) {
            match one(folder, case, stop) {
                _ if stop.load(Ordering::Relaxed) => return,
                Ok(None) => {}
                Ok(Some(reason)) => lock(&refused).push(((*case).clone(), reason)),
                Err(error) => {
                    stop.store(true, Ordering::Relaxed);
                    *lock(&failed) = Some(error);
                    return;
                }
            }
            let done = 1 + done.fetch_add(1, Ordering::Relaxed);
            told(Told { case: (*case).clone(), done, of: left.len() });
        }
    };
    std::thread::scope(|scope| (0..jobs.clamp(1, left.len().max(1))).for_each(|_| drop(scope.spawn(work))));
    if let Some(error) = lock(&failed).take() {
        return Err(error);
    }
    let mut refused = std::mem::take(&mut *lock(&refused));
    refused.sort();
    let diagnosed = cases.iter().filter(|case| place(folder, case).join("diagnosis.json").exists()).count();
    Ok(Answered { diagnosed, cases: cases.len(), refused })
}

/// Folder of a case's diagnosis.
pub(super) fn place(folder: &Path, case: &str) -> std::path::PathBuf {
    folder.join("diagnoses").join(case)
}

fn lock<T>(mutex: &Mutex<T>) -> std::sync::MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(std::sync::PoisonError::into_inner)
}

/// Diagnoses one case and writes it; the reason where the diagnosis refuses.
fn one(folder: &Path, case: &str, stop: &AtomicBool) -> Result<Option<String>, ProveError> {
    if stop.load(Ordering::Relaxed) {
        return Ok(None);
    }
    let diagnosed = match recorded(&folder.join(case).join("recording.toml"), stop) {
        Ok(diagnosed) => diagnosed,
        Err(error) => return Ok(Some(error.to_string())),
    };
    if stop.load(Ordering::Relaxed) {
        return Ok(None); // broken off: what it says is not its last word
    }
    let target = place(folder, case);
    let out = OutputFolder::begin(&target)?;
    let text = serde_json::to_string_pretty(&diagnosed.outcome.diagnosis);
    let text = text.map_err(|source| ProveError::Json { path: target.join("diagnosis.json"), source })?;
    if let Some(model) = diagnosed.model_file().ok().and_then(|model| model.to_toml().ok()) {
        out.write("augmented.toml", model)?; // without it the case has no figure on fresh histories, which is said there
    }
    out.write("controls.json", controls(&diagnosed).to_string() + "\n")?;
    out.write("diagnosis.json", text + "\n")?;
    out.publish()?;
    Ok(None)
}

/// What a sparse regression and a Gaussian process make of the residual of the calibrated model.
fn controls(diagnosed: &Diagnosed) -> serde_json::Value {
    let (recording, traces) = (&diagnosed.recording, &diagnosed.outcome.traces);
    let noise = diagnosed.outcome.diagnosis.fit.noise_floor;
    let residual: Vec<f64> = recording.response.iter().zip(&traces.before).map(|(r, b)| r - b).collect();
    serde_json::json!({
        "sparse": sparse::claims(&recording.inputs, &residual, noise),
        "process_misfit_removed": process::misfit_removed(&recording.inputs, &residual, noise),
    })
}

/// What is asked of a case: all effects, or all but the one that a file beside the recording names.
fn request(path: &Path) -> Request {
    let mut request = Request { command: "truegap prove".into(), ..Request::default() };
    if let Ok(without) = std::fs::read_to_string(path.with_file_name(WITHOUT)) {
        let ids = request.library.ids();
        request.effects = ids.into_iter().filter(|id| *id != without.trim()).map(str::to_owned).collect();
    }
    request
}

fn recorded(path: &Path, stop: &AtomicBool) -> Result<Diagnosed, crate::diagnosis::DiagnosisError> {
    let recording = Recording::open(path)?;
    let files = vec![(path.display().to_string(), recording.sha256.clone())];
    let request = request(path);
    diagnose(open(vec![recording], &request)?, files, &request, &|_| (), stop)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_effect_named_beside_a_recording_is_the_only_one_that_is_not_tried() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("recording.toml");
        assert!(request(&path).effects.is_empty());
        std::fs::write(path.with_file_name(WITHOUT), "thermal_lag\n").unwrap();
        let request = request(&path);
        let all = request.library.ids();
        assert_eq!(request.effects.len() + 1, all.len());
        assert!(all.contains(&"thermal_lag") && !request.effects.iter().any(|id| id == "thermal_lag"));
    }
}
