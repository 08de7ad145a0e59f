//! Why a study cannot be made, answered or scored.
//!
//! Limits: a recording that cannot be diagnosed is no error here; it is listed beside the scores.

use crate::output::OutputError;
use std::path::{Path, PathBuf};
use truegap_generator::StudyError;
use truegap_generator::score::claim::ClaimError;
use truegap_generator::score::folder::FolderError;

/// Why there is no score.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
#[allow(missing_docs)] // the fields are named by the messages
pub enum ProveError {
    /// No case asked for.
    #[error("--cases 0: a study has at least one case")]
    NoCases,
    /// The place is taken.
    #[error("{folder}: holds `{entry}`; give -o a folder that is new, or go on with the study in it by --resume")]
    Taken { folder: PathBuf, entry: String },
    /// Nothing to go on with.
    #[error("{folder}: holds no study to go on with (no key/plan.json); leave --resume out to begin one")]
    NoStudy { folder: PathBuf },
    /// The plan does not say what was asked.
    #[error(
        "{folder}: the study has {what} {there}, asked was {asked}; leave --{what} out to go on with it, or give -o a new folder"
    )]
    OtherPlan { folder: PathBuf, what: &'static str, there: String, asked: String },
    /// A file could not be read or written.
    #[error("{path}: {source}; check the folder and its permissions")]
    File { path: PathBuf, source: std::io::Error },
    /// A file is not what it was.
    #[error("{path}: {source}; take the file as it was written, or delete its folder and --resume")]
    Json { path: PathBuf, source: serde_json::Error },
    /// A diagnosis that the scorer cannot read.
    #[error("{path}: {source}; delete its folder and --resume")]
    Claim { path: PathBuf, source: ClaimError },
    /// The study cannot be made or its key does not fit.
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
    let part = path.with_extension("part");
    let folder = path.parent().unwrap_or(Path::new("."));
    std::fs::create_dir_all(folder)
        .and_then(|()| std::fs::write(&part, text))
        .and_then(|()| std::fs::rename(&part, path))
        .map_err(|source| ProveError::File { path: path.to_owned(), source })
}
