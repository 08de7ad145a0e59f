//! Which of day and month stands first in a column of dates such as `01/03/2026`: a number above 12 shows it, or somebody has to say it. Which of day and year does in `26.03.01`.
//!
//! Limits: one column; a table whose dates are all one and the same day needs no order, as time is counted from the first row.

use super::{
    error::RecordingError,
    short_years::ShortYears,
    stamp::{First, unordered},
    table::Table,
    text::text,
};
use std::io::{Read, Seek};
use std::path::{Path, PathBuf};

/// What the dates of a column have shown.
#[derive(Default)]
struct Seen {
    /// the first date, and the place of its row: a byte, or a line
    first: Option<([i64; 3], String, u64)>,
    /// whether another day came after it
    several: bool,
    /// a date with a number above 12 in front, and one with it behind
    day_first: Option<(String, u64)>,
    month_first: Option<(String, u64)>,
    /// dates with two digits of a year
    short: ShortYears,
}

/// The order of the dates in the column of that index, which `told` says or the table shows; reads the table to its end.
///
/// # Errors
/// [`RecordingError::DayOrMonth`] and [`RecordingError::DayOrYear`] where neither does, [`RecordingError::BothOrders`] where rows contradict one another or what was told.
pub(super) fn order<R: Read + Seek>(table: &mut Table<R>, column: usize, told: Option<bool>) -> Result<First, RecordingError> {
    let mut seen = Seen::default();
    while table.advance()? {
        seen.see(table.row().get(column).unwrap_or_default(), table.byte());
    }
    let (file, name) = (table.file(), table.header[column].name.clone());
    match seen.order(told) {
        Ok(order) => Ok(order),
        Err((doubt, byte)) => {
            let line = table.line(byte)?;
            Err(doubt.at(file, line, name))
        }
    }
}

/// The order of the dates in cells that are in memory; lines are counted from 1.
///
/// # Errors
/// As [`order`].
pub(super) fn order_of(file: &Path, column: &str, cells: &[Option<&str>], told: Option<bool>) -> Result<First, RecordingError> {
    let mut seen = Seen::default();
    for (row, cell) in cells.iter().enumerate() {
        seen.see(cell.unwrap_or_default().as_bytes(), row as u64 + 1);
    }
    seen.order(told).map_err(|(doubt, line)| doubt.at(file.to_owned(), line as usize, column.to_owned()))
}

/// Why the order of dates is not known; the line is still to be found.
enum Doubt {
    Unordered { text: String },
    Short { text: String },
    Both { text: String, other: String },
}

impl Doubt {
    fn at(self, file: PathBuf, line: usize, column: String) -> RecordingError {
        match self {
            Self::Unordered { text } => RecordingError::DayOrMonth { file, line, column, text },
            Self::Short { text } => RecordingError::DayOrYear { file, line, column, text },
            Self::Both { text, other } => RecordingError::BothOrders { file, line, column, text, other },
        }
    }
}

impl Seen {
    /// What the dates and what is told of them come to, or the doubt with the place of its row.
    fn order(self, told: Option<bool>) -> Result<First, (Doubt, u64)> {
        let contradiction = match told {
            None => {
                self.day_first.clone().zip(self.month_first.clone()).map(|(one, other)| (other, format!("`{}` above it", one.0)))
            }
            Some(true) => self.month_first.clone().map(|cell| (cell, "dayfirst = true".to_owned())),
            Some(false) => self.day_first.clone().map(|cell| (cell, "dayfirst = false".to_owned())),
        };
        if let Some(((text, place), other)) = contradiction {
            return Err((Doubt::Both { text, other }, place));
        }
        if let Some(order) = self.short.order(told) {
            return order.map_err(|(text, place)| (Doubt::Short { text }, place));
        }
        match (told, &self.day_first, &self.month_first, self.first) {
            (Some(true), ..) | (None, Some(_), ..) => Ok(First::Day),
            (Some(false), ..) | (None, _, Some(_), _) => Ok(First::Month),
            (_, _, _, Some((_, text, place))) if self.several => Err((Doubt::Unordered { text }, place)),
            _ => Ok(First::default()),
        }
    }

    fn see(&mut self, cell: &[u8], place: u64) {
        self.short.see(cell, place);
        let Some(date @ [one, other, _]) = unordered(cell) else { return };
        let shown = || (text(cell).0.into_owned(), place);
        match &self.first {
            None => self.first = Some((date, shown().0, place)),
            Some((first, ..)) => self.several |= *first != date,
        }
        if one > 12 && self.day_first.is_none() {
            self.day_first = Some(shown());
        }
        if other > 12 && self.month_first.is_none() {
            self.month_first = Some(shown());
        }
    }
}
