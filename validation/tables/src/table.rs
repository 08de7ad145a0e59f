//! The tables by their names.
//!
//! Limits: every table is made from files of this repository.

use crate::{csv, error::TablesError, front, real::Real, review, sources, speed, study, worded};
use std::path::Path;

/// Names that may stand in a mark, beside `csv PATH`, `mechanisms PATH`, `mechanism-counts PATH`, `coverage PATH` and `calibration PATH`.
pub(crate) const NAMES: [&str; 10] =
    ["front", "limits", "study", "study-size", "study-causes", "real", "speed", "crates", "stages", "review"];

/// The text of a table; `line` is that of its mark, for messages.
///
/// # Errors
/// [`TablesError`] where the name means nothing or a result file is not as it should be.
pub(crate) fn table(root: &Path, name: &str, line: usize) -> Result<String, TablesError> {
    if let Some(path) = name.strip_prefix("csv ") {
        return Ok(csv::read(&root.join(path))?.text());
    }
    if let Some(path) = name.strip_prefix("mechanisms ") {
        return Ok(worded::one_by_one(&root.join(path))?.text());
    }
    if let Some(path) = name.strip_prefix("mechanism-counts ") {
        return Ok(worded::counts(&root.join(path), &worded::OF_MECHANISMS)?.text());
    }
    if let Some(path) = name.strip_prefix("coverage ") {
        return Ok(worded::counts(&root.join(path), &worded::OF_NUMBERS)?.text());
    }
    if let Some(path) = name.strip_prefix("calibration ") {
        return Ok(worded::counts(&root.join(path), &worded::OF_PROBABILITIES)?.text());
    }
    let table = match name {
        "front" => front::table(root)?,
        "limits" => front::limits(root)?,
        "study" => study::targets(root)?,
        "study-size" => study::by_size(root)?,
        "study-causes" => study::by_cause(root)?,
        "real" => Real::read(root)?.table(),
        "speed" => speed::table(root)?,
        "crates" => sources::crates(root)?,
        "stages" => sources::stages(root)?,
        "review" => review::table(root)?,
        _ => return Err(TablesError::Unknown { line, name: name.to_owned(), known: NAMES.join(", ") }),
    };
    Ok(table.text())
}
