//! Columns whose numbers are so small, so large or so alike that sums of their squares are none.
//!
//! Limits: the span of a whole column; a column that never changes has none, and is for the diagnosis to judge.

use super::{columns::Column, data::Recording, error::RecordingError};
use crate::column::ends;
use crate::inputs::Role;
use std::path::Path;

/// Smallest and largest span: squares of what is smaller or larger, summed over rows and taken apart again, are beyond what a number holds.
const SPANS: (f64, f64) = (1e-100, 1e100);
/// Smallest span of a clock, s: no logger is so fast, and what physics there is in sensors is slower.
const SHORTEST_S: f64 = 1e-15;
/// Part of the largest reading below which all that differs is the last digits that a number holds.
const LAST_DIGITS: f64 = 1e-14;

/// Time since 1970 from which a clock is doubted, s: the year 5138.
const FAR_S: f64 = 1e11;
const YEAR_S: f64 = 365.25 * 86_400.0;
/// Units in which computers count from 1970, with their seconds.
const SMALLER_UNITS: [(&str, f64); 3] = [("ms", 1e-3), ("us", 1e-6), ("ns", 1e-9)];

/// Refuses a column whose numbers cannot be reckoned with.
///
/// # Errors
/// [`RecordingError::Span`], and [`RecordingError::SinceWhen`] of a clock.
pub(super) fn check(file: &Path, recording: &Recording, columns: &[Column]) -> Result<(), RecordingError> {
    let inputs = &recording.inputs;
    for column in columns {
        let values = match column.role {
            Role::Response => Some(recording.response.as_slice()),
            role => inputs.column(role),
        };
        if let Some(values) = values {
            span(file, column.role, &column.name, &column.unit, values)?;
            if column.role == Role::Time && !column.dated {
                since_1970(file, column, values)?;
            }
        }
    }
    inputs.drivers.iter().try_for_each(|driver| span(file, Role::Force, &driver.name, &driver.unit, &driver.values))
}

/// Refuses a clock that counts from 1970 in a smaller unit than it is read in: by its numbers it would stand thousands of years from now.
fn since_1970(file: &Path, column: &Column, values: &[f64]) -> Result<(), RecordingError> {
    let Some(first) = values.first().copied().filter(|first| *first >= FAR_S) else { return Ok(()) };
    let counted = first / column.scale.0;
    let from_1973_to_2286 = 1e8..1e10;
    let meant = SMALLER_UNITS.into_iter().find(|(_, factor)| from_1973_to_2286.contains(&(counted * factor)));
    let Some((unit, _)) = meant else { return Ok(()) };
    let year = 1970.0 + first / YEAR_S;
    let name = &column.name;
    let remedy = match unit {
        "ns" => "divide them by 1e9, and write time = \"s\" under [units]".to_owned(),
        unit => format!("write time = \"{unit}\" under [units], or give --map time=\"{name}:{unit}\""),
    };
    Err(RecordingError::SinceWhen { file: file.to_owned(), column: name.clone(), year, unit, remedy })
}

fn span(file: &Path, role: Role, column: &str, unit: &str, values: &[f64]) -> Result<(), RecordingError> {
    let (low, high) = ends(values.iter().copied());
    let (span, largest) = (high - low, low.abs().max(high.abs()));
    let says = match role {
        _ if span == 0.0 || values.is_empty() => return Ok(()),
        Role::Time if span < SHORTEST_S => "all times lie within 1e-15 s",
        Role::Response if span < LAST_DIGITS * largest => "they differ in the last digits that a number holds alone",
        _ if span < SPANS.0 => "they differ by less than 1e-100, which is too little to be squared and summed",
        _ if span > SPANS.1 || !span.is_finite() => "they differ by more than 1e100, which is too much to be squared and summed",
        _ => return Ok(()),
    };
    let (file, column, unit) = (file.to_owned(), column.to_owned(), unit.to_owned());
    Err(RecordingError::Span { file, column, low, high, unit, says })
}
