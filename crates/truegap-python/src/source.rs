//! Recordings as Python gives them: a path, or columns in memory with what a TOML would say of them.
//!
//! Limits: columns are contiguous arrays of 64-bit floats; the Python half makes them so.

use numpy::PyReadonlyArray1;
use pyo3::create_exception;
use pyo3::exceptions::PyException;
use pyo3::prelude::*;
use std::path::{Path, PathBuf};
use truegap::core::{BaseSpec, Note};
use truegap::diagnosis::{EXAMPLE, example_recording};
use truegap::{Recording, RecordingError};

create_exception!(truegap, TruegapError, PyException, "What truegap cannot do, and what to do about it.");

/// The exception for an error of the library.
pub(crate) fn failed(error: impl std::fmt::Display) -> PyErr {
    TruegapError::new_err(error.to_string())
}

/// A recording, as Python gives it.
#[derive(FromPyObject)]
pub(crate) enum Source<'py> {
    /// path of a TOML, a CSV or a folder, or `example`
    Path(PathBuf),
    /// name, what a TOML would say as JSON, columns
    Frame(String, String, Vec<(String, PyReadonlyArray1<'py, f64>)>),
}

impl Source<'_> {
    /// The recording, and its name.
    pub fn read(&self) -> PyResult<(Recording, String)> {
        match self {
            Self::Path(path) => Ok((opened(path).map_err(failed)?, path.display().to_string())),
            Self::Frame(name, says, columns) => Ok((framed(name, says, columns)?, name.clone())),
        }
    }
}

/// The built-in recording where its name is given and nothing on disk has that name.
fn opened(path: &Path) -> Result<Recording, RecordingError> {
    if path == Path::new(EXAMPLE) && !path.exists() { example_recording() } else { Recording::open(path) }
}

fn framed(name: &str, says: &str, columns: &[(String, PyReadonlyArray1<'_, f64>)]) -> PyResult<Recording> {
    let says: toml::Table = serde_json::from_str(says).map_err(failed)?;
    let says = toml::to_string(&says).map_err(failed)?;
    let columns = columns.iter().map(|(name, column)| Ok((name.clone(), column.as_slice()?)));
    let columns = columns.collect::<Result<Vec<_>, numpy::AsSliceError>>().map_err(failed)?;
    Recording::from_columns(name, &says, &columns).map_err(failed)
}

/// The recording with another base model, as JSON gives it.
pub(crate) fn rebased(mut recording: Recording, base: Option<&str>) -> PyResult<Recording> {
    if let Some(base) = base {
        recording.base = serde_json::from_str::<BaseSpec>(base).map_err(failed)?;
        recording.notes.retain(|note| !matches!(note, Note::BaseAssumed { .. }));
    }
    Ok(recording)
}
