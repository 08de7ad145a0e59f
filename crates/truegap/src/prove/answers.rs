//! Diagnoses every recording of a study that has no diagnosis yet.
//!
//! Limits: opens `CASE/recording.toml` and its CSV only; of the key nothing but its hashes is looked at. A diagnosis that was broken off is not kept.

use super::error::ProveError;
use super::plan::Plan;
use super::seal::{self, ANSWER, Answers, REFUSED, commitments};
use super::{process, sparse};
use crate::diagnosis::{Diagnosed, Request, diagnose, open};
use crate::output::OutputFolder;
use std::path::Path;
use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use truegap_core::Recording;
use truegap_generator::commitment::Sums;
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
    /// cases that were diagnosed or refused
    pub answered: usize,
    /// cases of the study
    pub cases: usize,
}

impl Answered {
    /// Whether every case was diagnosed or refused.
    pub fn is_complete(&self) -> bool {
        self.answered == self.cases
    }
}

/// Diagnoses what is left to diagnose, `jobs` at a time; `stop` ends it, and what is done is kept.
///
/// Every answer is written down by its hash in `answers.txt`; what has no hash there was broken off, and is diagnosed again.
///
/// # Errors
/// [`ProveError`] where the study is not what it was, an answer was changed, or one cannot be written; a recording that is refused is an answer.
pub fn answer(folder: &Path, jobs: usize, told: &(dyn Fn(Told) + Sync), stop: &AtomicBool) -> Result<Answered, ProveError> {
    let cases = Plan::read(folder)?.names();
    let commitments = commitments(folder, &cases)?;
    let answers = Answers::open(folder)?;
    let left: Vec<String> = cases.iter().filter(|case| !answers.has(case)).cloned().collect();
    let jobs = jobs.clamp(1, left.len().max(1));
    let (next, done, failed) = (AtomicUsize::new(0), AtomicUsize::new(0), Mutex::new(None));
    let queue = Queue { folder, left, commitments, answers: Mutex::new(answers), next, done, failed, told, stop };
    std::thread::scope(|scope| (0..jobs).for_each(|_| drop(scope.spawn(|| queue.work()))));
    if let Some(error) = lock(&queue.failed).take() {
        return Err(error);
    }
    let answers = lock(&queue.answers);
    Ok(Answered { answered: cases.iter().filter(|case| answers.has(case)).count(), cases: cases.len() })
}

/// What is left to diagnose, for several at a time.
struct Queue<'a> {
    folder: &'a Path,
    left: Vec<String>,
    commitments: Sums,
    answers: Mutex<Answers>,
    next: AtomicUsize,
    done: AtomicUsize,
    failed: Mutex<Option<ProveError>>,
    told: &'a (dyn Fn(Told) + Sync),
    stop: &'a AtomicBool,
}

impl Queue<'_> {
    /// Diagnoses case after case, until none is left or all are stopped.
    fn work(&self) {
        while let Some(case) = self.left.get(self.next.fetch_add(1, Ordering::Relaxed)) {
            let said = one(self.folder, case, &self.commitments, self.stop);
            if self.stop.load(Ordering::Relaxed) {
                return;
            }
            if let Err(error) = said.and_then(|()| lock(&self.answers).add(case)) {
                self.stop.store(true, Ordering::Relaxed);
                *lock(&self.failed) = Some(error);
                return;
            }
            let done = 1 + self.done.fetch_add(1, Ordering::Relaxed);
            (self.told)(Told { case: case.clone(), done, of: self.left.len() });
        }
    }
}

/// Folder of a case's diagnosis.
pub(super) fn place(folder: &Path, case: &str) -> std::path::PathBuf {
    folder.join("diagnoses").join(case)
}

fn lock<T>(mutex: &Mutex<T>) -> std::sync::MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(std::sync::PoisonError::into_inner)
}

/// Diagnoses one case and writes what is said of it, which may be the reason of a refusal.
fn one(folder: &Path, case: &str, commitments: &Sums, stop: &AtomicBool) -> Result<(), ProveError> {
    if stop.load(Ordering::Relaxed) {
        return Ok(());
    }
    let said = recorded(&folder.join(case).join("recording.toml"), stop);
    if stop.load(Ordering::Relaxed) {
        return Ok(()); // broken off: what it says is not its last word
    }
    let target = place(folder, case);
    let out = OutputFolder::begin(&target)?.replacing(&ANSWER);
    match said {
        Ok(diagnosed) if diagnosed.recording.sha256 != commitments.get(&seal::recorded(case, "csv"))? => {
            let path = folder.join(case).join("recording.csv");
            return Err(ProveError::OtherRecording { path, recording: seal::recorded(case, "csv") });
        }
        Ok(diagnosed) => write(&out, &target, &diagnosed)?,
        Err(reason) => out.write(REFUSED, format!("{reason}\n"))?,
    }
    out.publish()?;
    Ok(())
}

fn write(out: &OutputFolder, target: &Path, diagnosed: &Diagnosed) -> Result<(), ProveError> {
    let text = serde_json::to_string_pretty(&diagnosed.outcome.diagnosis);
    let text = text.map_err(|source| ProveError::Json { path: target.join("diagnosis.json"), source })?;
    if let Some(model) = diagnosed.model_file().ok().and_then(|model| model.to_toml().ok()) {
        out.write("augmented.toml", model)?; // without it the case has no figure on fresh histories, which is said there
    }
    out.write("controls.json", controls(diagnosed).to_string() + "\n")?;
    Ok(out.write("diagnosis.json", text + "\n")?)
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
