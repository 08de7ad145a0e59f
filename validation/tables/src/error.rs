//! Why a table cannot be written.
//!
//! Limits: plain data.

use std::path::PathBuf;

/// Why a table cannot be written.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
#[allow(missing_docs)] // the fields are named by the messages
pub enum TablesError {
    /// A file cannot be read or written.
    #[error("{path}: {source}")]
    File { path: PathBuf, source: std::io::Error },
    /// A result file that is not as it should be.
    #[error("{path}: {source}; write it again by the command that made it (docs/results.md)")]
    Json { path: PathBuf, source: serde_json::Error },
    /// A result file without a row that a table shows.
    #[error("{path}: there is no row `{row}`, which a table of the pages shows")]
    NoRow { path: PathBuf, row: String },
    /// Rows of different lengths.
    #[error("{path}, line {line}: {cells} cells where the header has {columns}")]
    Cells { path: PathBuf, line: usize, cells: usize, columns: usize },
    /// A mark without its end.
    #[error("line {line}: the table `{name}` has no `<!-- end -->`; put one below it")]
    NoEnd { line: usize, name: String },
    /// A name that means nothing.
    #[error("line {line}: there is no table `{name}`; use {known} or `csv PATH`")]
    Unknown { line: usize, name: String, known: String },
    /// What went wrong in a page.
    #[error("{page}: {source}")]
    Page { page: PathBuf, source: Box<TablesError> },
    /// A folder without an answer.
    #[error("{path}: there is no diagnosis.json in it; run `truegap diagnose RECORDING -o {path}` first")]
    NoAnswer { path: PathBuf },
    /// Sources that cannot be counted.
    #[error("the sources cannot be counted: {0}")]
    House(#[from] truegap_house::HouseError),
    /// Nothing to collect.
    #[error("{path}: there is no folder in it; give the folder that holds one folder a recording")]
    NoFolders { path: PathBuf },
}

impl TablesError {
    /// The error of a file operation at a path.
    pub(crate) fn at(path: &std::path::Path) -> impl FnOnce(std::io::Error) -> Self + '_ {
        |source| Self::File { path: path.to_owned(), source }
    }
}
