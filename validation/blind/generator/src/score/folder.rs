//! Scoring from disk: a study or the shared open recordings on one side, a folder of diagnoses on the other.
//!
//! Limits: a case without a diagnosis is not scored; how many there are is said, so that leaving out hard cases shows.

use super::claim::ClaimError;
use super::truth::Truth;
use super::{Scored, score};
use crate::study::{StudyError, open};
use serde_json::Value;
use std::path::{Path, PathBuf};

/// Why a folder cannot be scored.
#[derive(Debug, thiserror::Error)]
pub enum FolderError {
    /// The study does not open.
    #[error(transparent)]
    Study(#[from] StudyError),
    /// A file could not be read.
    #[error("{path}: {source}; check that it exists and may be read")]
    File {
        /// File.
        path: PathBuf,
        /// Cause.
        source: std::io::Error,
    },
    /// A file is not JSON.
    #[error("{path}: {source}")]
    Json {
        /// File.
        path: PathBuf,
        /// Cause.
        source: serde_json::Error,
    },
    /// A diagnosis breaks the contract.
    #[error("{path}: {source}")]
    Claim {
        /// File.
        path: PathBuf,
        /// Cause.
        source: ClaimError,
    },
    /// A shared truth has another shape.
    #[error("{path}: no effects, detectability or protocol; expected the truth.json of a blind recording")]
    Truth {
        /// File.
        path: PathBuf,
    },
    /// Nothing to score.
    #[error("{path}: no diagnosis found; expected CASE/diagnosis.json or CASE.json")]
    Empty {
        /// Folder.
        path: PathBuf,
    },
}

/// What a folder of diagnoses scores.
#[derive(Debug)]
pub struct Scores {
    /// Cases with a diagnosis.
    pub scored: Vec<Scored>,
    /// Names of the cases without one.
    pub absent: Vec<String>,
}

/// Scores `diagnoses` against the answers in `study`; the key must fit the commitments.
pub fn score_folder(study: &Path, diagnoses: &Path) -> Result<Scores, FolderError> {
    let mut scores = Scores { scored: Vec::new(), absent: Vec::new() };
    for truth in truths(study)? {
        let places = [diagnoses.join(&truth.case).join("diagnosis.json"), diagnoses.join(format!("{}.json", truth.case))];
        match places.into_iter().find(|path| path.exists()) {
            None => scores.absent.push(truth.case),
            Some(path) => {
                let diagnosis = json(&path)?;
                scores.scored.push(score(truth, &diagnosis).map_err(|source| FolderError::Claim { path, source })?);
            }
        }
    }
    if scores.scored.is_empty() {
        return Err(FolderError::Empty { path: diagnoses.to_owned() });
    }
    Ok(scores)
}

/// Answers of a study (verified), or the truths of shared open recordings (CASE/truth.json), by name.
pub fn truths(study: &Path) -> Result<Vec<Truth>, FolderError> {
    if study.join("commitments.txt").exists() {
        return Ok(open(study)?.iter().map(Truth::from).collect());
    }
    let failed = |source| FolderError::File { path: study.to_owned(), source };
    let mut truths = Vec::new();
    for entry in std::fs::read_dir(study).map_err(failed)? {
        let folder = entry.map_err(failed)?.path();
        let path = folder.join("truth.json");
        if path.exists() {
            let case = folder.file_name().unwrap_or_default().to_string_lossy().into_owned();
            truths.push(Truth::of_shared(&case, &json(&path)?).ok_or(FolderError::Truth { path })?);
        }
    }
    truths.sort_by(|a, b| a.case.cmp(&b.case));
    Ok(truths)
}

fn json(path: &Path) -> Result<Value, FolderError> {
    let text = std::fs::read_to_string(path).map_err(|source| FolderError::File { path: path.to_owned(), source })?;
    serde_json::from_str(&text).map_err(|source| FolderError::Json { path: path.to_owned(), source })
}
