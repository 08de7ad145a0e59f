//! Recordings as Python gives them: a path, or columns in memory with what a TOML would say of them.
//!
//! Limits: columns are contiguous arrays of 64-bit floats; the Python half makes them so.

use numpy::{IntoPyArray, PyArray1, PyReadonlyArray1};
use pyo3::create_exception;
use pyo3::exceptions::PyException;
use pyo3::prelude::*;
use std::path::{Path, PathBuf};
use truegap::core::recording::{Cells, FrameColumn, Told, dates_of_text};
use truegap::core::{BaseSpec, Note};
use truegap::diagnosis::recorded;
use truegap::{Recording, RecordingError};

create_exception!(truegap, TruegapError, PyException, "What truegap cannot do, and what to do about it.");

/// The exception for an error of the library.
pub(crate) fn failed(error: impl std::fmt::Display) -> PyErr {
    TruegapError::new_err(error.to_string())
}

/// A column: name, values, and what they are seconds since where they are dates; an empty text where they are durations.
type Given<'py> = (String, PyReadonlyArray1<'py, f64>, Option<String>);

/// A recording, as Python gives it.
#[derive(FromPyObject)]
pub(crate) enum Source<'py> {
    /// path of a TOML, a table or a folder, or `example`
    Path(PathBuf),
    /// path of a table, and what a TOML would say of it as JSON
    Table(PathBuf, String),
    /// name, what a TOML would say as JSON, columns, names of columns without numbers
    Frame(String, String, Vec<Given<'py>>, Vec<String>),
}

impl Source<'_> {
    /// The recording, and its name.
    pub fn read(&self) -> PyResult<(Recording, String)> {
        match self {
            Self::Path(path) => Ok((recorded(path, &Told::default()).map_err(failed)?, path.display().to_string())),
            Self::Table(path, says) => {
                let read = Recording::open_table(path, &toml_of(says)?).map_err(|error| failed(in_python(error)))?;
                Ok((read, path.display().to_string()))
            }
            Self::Frame(name, says, columns, left_out) => Ok((framed(name, says, columns, left_out)?, name.clone())),
        }
    }
}

/// What a TOML says, as JSON gives it.
fn toml_of(says: &str) -> PyResult<String> {
    let says: toml::Table = serde_json::from_str(says).map_err(failed)?;
    toml::to_string(&says).map_err(failed)
}

fn framed(name: &str, says: &str, columns: &[Given<'_>], left_out: &[String]) -> PyResult<Recording> {
    let says = toml_of(says)?;
    let column = |(name, values, since): &Given<'_>| -> Result<FrameColumn<'static>, numpy::AsSliceError> {
        let cells = match since.as_deref() {
            None => Cells::Numbers,
            Some("") => Cells::Durations,
            Some(first) => Cells::Dates { first: first.to_owned() },
        };
        Ok(FrameColumn { name: name.clone(), values: std::borrow::Cow::Owned(values.as_slice()?.to_vec()), cells })
    };
    let columns = columns.iter().map(column);
    let columns = columns.collect::<Result<Vec<_>, numpy::AsSliceError>>().map_err(failed)?;
    Recording::from_frame(name, &says, &columns, left_out).map_err(|error| failed(in_python(error)))
}

/// What to do about a frame, said as Python says it: no TOML lies beside it.
fn in_python(error: RecordingError) -> String {
    match error {
        RecordingError::MissingColumn { file, role, wanted, near, found } => format!(
            "{}: no column for {role}: {wanted} is not among the columns; {near}found: {found}; name yours: columns={{\"{role}\": \"...\"}}",
            file.display()
        ),
        RecordingError::MissingUnit { file, column, role, example, known } => format!(
            "{}: column `{column}` ({role}) has no unit in its name; say it: units={{\"{role}\": \"{example}\"}}, or one of {known}",
            file.display()
        ),
        RecordingError::NotItsUnit { file, column, role, unit, known } => format!(
            "{}: column `{column}` is called after {role}, and `{unit}` is no unit of {role} ({known}); rename the column, or name the one that is meant: \
             columns={{\"{role}\": \"...\"}}",
            file.display()
        ),
        RecordingError::AmbiguousColumn { file, role, found, first } => {
            format!("{}: columns {found} could all be {role}; say which: columns={{\"{role}\": \"{first}\"}}", file.display())
        }
        RecordingError::WrongUnit { file, role, source, .. } => {
            format!("{}: units={{\"{role}\": ...}}: {source}", file.display())
        }
        RecordingError::UnknownKey { file, table, key, instead, .. } => {
            format!("{}: {} has no key `{key}`; {instead}", file.display(), table.trim_matches(['[', ']']))
        }
        other => other.to_string(),
    }
}

/// What reading changed, left out or assumed, said as Python says it.
pub(crate) fn note_in_python(note: &Note) -> String {
    match note {
        Note::NotRead { columns } => format!(
            "not read: {columns}; name what they are by columns={{\"force\": \"...\"}} or drivers={{\"NAME\": {{\"column\": \"...\", \"unit\": \"...\"}}}}, or leave \
             them as they are"
        ),
        Note::NoInput { columns } => format!(
            "nothing was read that the reading could follow, and these columns of numbers were not read: {columns}; if one is what was done, name it: \
             drivers={{\"NAME\": {{\"column\": \"...\", \"unit\": \"...\"}}}}; if one is your own simulation: columns={{\"simulated\": \"...\"}}"
        ),
        Note::ReadByName { columns } => {
            format!(
                "read because of their names: {columns}; if that is not what they are, say so: columns={{\"force\": \"...\"}}"
            )
        }
        other => other.to_string(),
    }
}

/// A column of texts as a clock; `None` where its first text is no date.
#[pyfunction]
pub(crate) fn read_dates<'py>(py: Python<'py>, column: &str, cells: Vec<Option<String>>) -> PyResult<Option<Clock<'py>>> {
    let cells: Vec<Option<&str>> = cells.iter().map(Option::as_deref).collect();
    let read = dates_of_text(Path::new("the frame"), column, &cells, None).map_err(|error| match error {
        RecordingError::DayOrMonth { line, column, text, .. } => failed(format!(
            "the frame, row {line}: `{text}` in column `{column}` may begin with the day or with the month; say which: \
             frame[\"{column}\"] = pandas.to_datetime(frame[\"{column}\"], dayfirst=True)"
        )),
        RecordingError::DayOrYear { line, column, text, .. } => failed(format!(
            "the frame, row {line}: `{text}` in column `{column}` may begin with the day or with the year; say which: \
             frame[\"{column}\"] = pandas.to_datetime(frame[\"{column}\"], format=\"%d.%m.%y ...\")"
        )),
        other => failed(other),
    })?;
    Ok(read.map(|column| {
        let first = if let Cells::Dates { first } = column.cells { first } else { String::new() };
        (column.values.into_owned().into_pyarray(py), first)
    }))
}

/// Seconds, and the date that they are counted from.
type Clock<'py> = (Bound<'py, PyArray1<f64>>, String);

/// The recording with another base model, as JSON gives it.
pub(crate) fn rebased(mut recording: Recording, base: Option<&str>) -> PyResult<Recording> {
    if let Some(base) = base {
        recording.base = serde_json::from_str::<BaseSpec>(base).map_err(failed)?;
        recording.notes.retain(|note| !matches!(note, Note::BaseAssumed { .. }));
    }
    Ok(recording)
}

/// A column of a file, as a frame has it.
type Columnar<'py> = (String, Bound<'py, PyArray1<f64>>, Option<String>);

/// The columns of a Parquet or Arrow file.
#[pyfunction]
pub(crate) fn read_columns<'py>(py: Python<'py>, file: PathBuf) -> PyResult<Vec<Columnar<'py>>> {
    let columns = truegap::core::recording::read_columns(&file).map_err(failed)?;
    let column = |column: FrameColumn<'static>| {
        let since = match column.cells {
            Cells::Numbers => None,
            Cells::Durations => Some(String::new()),
            Cells::Dates { first } => Some(first),
        };
        (column.name, column.values.into_owned().into_pyarray(py), since)
    };
    Ok(columns.into_iter().map(column).collect())
}
