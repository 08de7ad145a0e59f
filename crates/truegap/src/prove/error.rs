//! Why a study cannot be made, answered or scored.
//!
//! Limits: a recording that cannot be diagnosed is no error here; it is listed beside the scores.

use crate::output::OutputError;
use std::path::{Path, PathBuf};
use truegap_generator::StudyError;
use truegap_generator::commitment::CommitmentError;
use truegap_generator::score::claim::ClaimError;
use truegap_generator::score::folder::FolderError;
use truegap_sweep::{SweepError, write_atomically};

/// Why there is no score.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
#[allow(missing_docs)] // the fields are named by the messages
pub enum ProveError {
    /// No case asked for.
    #[error("--cases 0: a study has at least one case")]
    NoCases,
    /// The place is taken by a study.
    #[error("{folder}: holds a study; go on with it by --resume, or give -o a folder that is new")]
    Begun { folder: PathBuf },
    /// The place is taken.
    #[error("{folder}: holds `{entry}` and no study (no key/plan.json); give -o a folder that is new")]
    Taken { folder: PathBuf, entry: String },
    /// Nothing to go on with.
    #[error("{folder}: holds no study to go on with; leave --resume out to begin one")]
    NoStudy { folder: PathBuf },
    /// What lies there cannot be gone on with.
    #[error(
        "{folder}: holds `{entry}`, but no key/plan.json, and without its plan a study cannot be gone on with; put the plan back, or leave --resume out and give -o a folder that is new"
    )]
    NoPlan { folder: PathBuf, entry: String },
    /// Nothing says what the study was.
    #[error(
        "{folder}: commitments.txt is gone, and nothing else says that key and recordings are those of the study; put it back as it was written, or begin a study in a new folder"
    )]
    NoCommitments { folder: PathBuf },
    /// The plan has fewer cases than were committed to.
    #[error(
        "{path}: has a line for {file}, which is none of the {cases} cases of the plan; put commitments.txt and key/plan.json back as they were written"
    )]
    Surplus { path: PathBuf, file: String, cases: usize },
    /// A file that this study never wrote.
    #[error("{path}: no hash was written down for it, so it was put there later; take it away")]
    NotWritten { path: PathBuf },
    /// What was said is not what is there.
    #[error("{0}, or delete `diagnoses`, answers.txt and score.json, and --resume answers all of it again")]
    Answer(CommitmentError),
    /// The answers have changed since they were scored.
    #[error(
        "{path}: is not what score.json was counted from; put it back as it was, or delete `diagnoses`, answers.txt and score.json, and --resume answers all of it again"
    )]
    ScoredOthers { path: PathBuf },
    /// A diagnosis of something else.
    #[error(
        "{path}: answers another recording than {recording}; put it back as it was, or delete `diagnoses`, answers.txt and score.json, and --resume answers all of it again"
    )]
    OtherRecording { path: PathBuf, recording: String },
    /// The plan does not say what was asked.
    #[error(
        "{folder}: the study has {what} {there}, asked was {asked}; leave --{what} out to go on with it, or give -o a new folder"
    )]
    OtherPlan { folder: PathBuf, what: &'static str, there: String, asked: String },
    /// A file could not be written.
    #[error(transparent)]
    Written(#[from] SweepError),
    /// A file could not be read.
    #[error("{path}: {source}; put it back where it is gone, or check the permissions")]
    File { path: PathBuf, source: std::io::Error },
    /// A file is not what it was.
    #[error("{path}: {source}; put the file back as it was written")]
    Json { path: PathBuf, source: serde_json::Error },
    /// A diagnosis that the scorer cannot read.
    #[error("{path}: {source}; put the file back as it was written")]
    Claim { path: PathBuf, source: ClaimError },
    /// A file of the study is not what it was.
    #[error(transparent)]
    Commitment(#[from] CommitmentError),
    /// The study cannot be made or is not what it was.
    #[error(transparent)]
    Study(#[from] StudyError),
    /// The diagnoses cannot be scored.
    #[error(transparent)]
    Score(#[from] FolderError),
    /// A diagnosis cannot be written.
    #[error(transparent)]
    Output(#[from] OutputError),
}

/// The text of a file.
pub(super) fn read(path: &Path) -> Result<String, ProveError> {
    std::fs::read_to_string(path).map_err(|source| ProveError::File { path: path.to_owned(), source })
}

/// The JSON in a file.
pub(super) fn json<T: serde::de::DeserializeOwned>(path: &Path) -> Result<T, ProveError> {
    serde_json::from_str(&read(path)?).map_err(|source| ProveError::Json { path: path.to_owned(), source })
}

/// Writes a file whole or not at all.
pub(super) fn write(path: &Path, text: &str) -> Result<(), ProveError> {
    Ok(write_atomically(path, text.as_bytes())?)
}
