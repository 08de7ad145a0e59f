//! Whether a study is what it was: every file against the hash that was written down for it, and none too few or too many.
//!
//! Limits: who changes a file and every hash of it is found only by who holds `commitments.txt` or the score as they were published.

use super::error::{ProveError, read, write};
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use truegap_generator::commitment::{COMMITMENTS, Sums};
use truegap_generator::study::{PLAN, WITHOUT, checked};

/// The file with the hashes of everything that the diagnosis has said.
pub(super) const ANSWERS: &str = "answers.txt";
/// The reason, where the diagnosis refuses a recording.
pub(super) const REFUSED: &str = "refused.txt";
/// Every file that an answer may consist of.
pub(super) const ANSWER: [&str; 4] = ["diagnosis.json", "augmented.toml", "controls.json", REFUSED];

/// The commitments of these cases, once all that they bind to was found as it was.
///
/// # Errors
/// [`ProveError`] naming the file that differs.
pub(super) fn commitments(folder: &Path, cases: &BTreeSet<String>) -> Result<Sums, ProveError> {
    if !folder.join(COMMITMENTS).exists() {
        return Err(ProveError::NoCommitments { folder: folder.to_owned() });
    }
    let sums = checked(folder)?;
    sums.get(PLAN)?;
    for case in cases {
        for file in [format!("{case}.json"), recorded(case, "csv"), recorded(case, "toml")] {
            sums.get(&file)?;
        }
        let without = format!("{case}/{WITHOUT}");
        if folder.join(&without).exists() && !sums.has(&without) {
            return Err(ProveError::NotWritten { path: folder.join(without) });
        }
    }
    let known = |file: &str| file == PLAN || cases.contains(file.split_once(['.', '/']).map_or(file, |(case, _)| case));
    if let Some(file) = sums.files().find(|file| !known(file)) {
        return Err(ProveError::Surplus { path: folder.join(COMMITMENTS), file: file.to_owned(), cases: cases.len() });
    }
    Ok(sums)
}

/// Name of a case's recording in the commitments.
pub(super) fn recorded(case: &str, kind: &str) -> String {
    format!("{case}/recording.{kind}")
}

/// What has been answered: the hashes in `answers.txt`, written anew after each case.
pub(super) struct Answers {
    folder: PathBuf,
    sums: Sums,
}

impl Answers {
    /// The answers so far, once each was found as it was written.
    ///
    /// # Errors
    /// [`ProveError`] naming the file that differs, or where answers that were scored are no longer those.
    pub(super) fn open(folder: &Path) -> Result<Self, ProveError> {
        let path = folder.join(ANSWERS);
        let text = if path.exists() { read(&path)? } else { String::new() };
        let sums = Sums::parse(ANSWERS, &text).map_err(ProveError::Answer)?;
        if scored(folder)?.is_some_and(|scored| scored != truegap_generator::commitment::sha256(&text)) {
            return Err(ProveError::ScoredOthers { path });
        }
        for file in sums.files() {
            sums.check(file, read(&folder.join(file))?).map_err(ProveError::Answer)?;
        }
        Ok(Self { folder: folder.to_owned(), sums })
    }

    /// Whether this case was diagnosed or refused.
    pub(super) fn has(&self, case: &str) -> bool {
        self.sums.has(&name(case, "diagnosis.json")) || self.sums.has(&name(case, REFUSED))
    }

    /// Writes down what was said of a case.
    ///
    /// # Errors
    /// [`ProveError::File`].
    pub(super) fn add(&mut self, case: &str) -> Result<(), ProveError> {
        for file in ANSWER.map(|file| name(case, file)) {
            let path = self.folder.join(&file);
            if path.exists() {
                self.sums.insert(&file, read(&path)?);
            }
        }
        write(&self.folder.join(ANSWERS), &self.sums.text())
    }

    /// Cases that were refused, with the reason; every other one has its diagnosis, of the recording that was committed to.
    ///
    /// # Errors
    /// [`ProveError`] where one has neither, or the diagnosis is of another recording.
    pub(super) fn refused(&self, cases: &BTreeSet<String>, commitments: &Sums) -> Result<Vec<(String, String)>, ProveError> {
        let mut refused = Vec::new();
        for case in cases {
            self.nothing_beside(case)?;
            if self.sums.has(&name(case, REFUSED)) {
                let reason = read(&self.folder.join(name(case, REFUSED)))?;
                refused.push((case.clone(), reason.trim_end().to_owned()));
                continue;
            }
            self.sums.get(&name(case, "diagnosis.json")).map_err(ProveError::Answer)?;
            let path = self.folder.join(name(case, "diagnosis.json"));
            let diagnosis: serde_json::Value = super::error::json(&path)?;
            if diagnosis["recording"]["sha256"] != commitments.get(&recorded(case, "csv"))? {
                return Err(ProveError::OtherRecording { path, recording: recorded(case, "csv") });
            }
        }
        Ok(refused)
    }

    /// A file laid beside an answer would be read with it.
    fn nothing_beside(&self, case: &str) -> Result<(), ProveError> {
        let mut beside = ANSWER.iter().map(|file| name(case, file)).filter(|file| self.folder.join(file).exists());
        match beside.find(|file| !self.sums.has(file)) {
            Some(file) => Err(ProveError::NotWritten { path: self.folder.join(file) }),
            None => Ok(()),
        }
    }

    /// SHA-256 of `answers.txt`.
    pub(super) fn sha256(&self) -> String {
        truegap_generator::commitment::sha256(self.sums.text())
    }
}

/// Name of a file of an answer in `answers.txt`.
fn name(case: &str, file: &str) -> String {
    format!("diagnoses/{case}/{file}")
}

/// The answers that the score in this folder was counted from.
fn scored(folder: &Path) -> Result<Option<String>, ProveError> {
    let path = folder.join("score.json");
    if !path.exists() {
        return Ok(None);
    }
    let score: serde_json::Value = super::error::json(&path)?;
    Ok(Some(score["answers_sha256"].as_str().unwrap_or_default().to_owned()))
}
