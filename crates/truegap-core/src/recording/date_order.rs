//! Which of day and month stands first in a column of dates such as `01/03/2026`: a number above 12 shows it, or somebody has to say it.
//!
//! Limits: one column; a table whose dates are all one and the same day needs no order, as time is counted from the first row.

use super::{
    error::RecordingError,
    stamp::{First, unordered},
    table::Table,
    text::text,
};
use std::io::{Read, Seek};

/// What the dates of a column have shown.
#[derive(Default)]
struct Seen {
    /// the first date, and the byte of its row
    first: Option<([i64; 3], String, u64)>,
    /// whether another day came after it
    several: bool,
    /// a date with a number above 12 in front, and one with it behind
    day_first: Option<(String, u64)>,
    month_first: Option<(String, u64)>,
}

/// The order of the dates in the column of that index, which `told` says or the table shows; reads the table to its end.
///
/// # Errors
/// [`RecordingError::DayOrMonth`] where neither does, [`RecordingError::BothOrders`] where rows contradict one another or what was told.
pub(super) fn order<R: Read + Seek>(table: &mut Table<R>, column: usize, told: Option<bool>) -> Result<First, RecordingError> {
    let mut seen = Seen::default();
    while table.advance()? {
        seen.see(table.row().get(column).unwrap_or_default(), table.byte());
    }
    let (file, name) = (table.file(), table.header[column].name.clone());
    let contradiction = match told {
        None => seen.day_first.clone().zip(seen.month_first.clone()).map(|(one, other)| (other, format!("`{}` above it", one.0))),
        Some(true) => seen.month_first.clone().map(|cell| (cell, "dayfirst = true".to_owned())),
        Some(false) => seen.day_first.clone().map(|cell| (cell, "dayfirst = false".to_owned())),
    };
    if let Some(((text, byte), other)) = contradiction {
        return Err(RecordingError::BothOrders { file, line: table.line(byte)?, column: name, text, other });
    }
    match (told, &seen.day_first, &seen.month_first, seen.first) {
        (Some(true), ..) | (None, Some(_), ..) => Ok(First::Day),
        (Some(false), ..) | (None, _, Some(_), _) => Ok(First::Month),
        (_, _, _, Some((_, text, byte))) if seen.several => {
            Err(RecordingError::DayOrMonth { file, line: table.line(byte)?, column: name, text })
        }
        _ => Ok(First::default()),
    }
}

impl Seen {
    fn see(&mut self, cell: &[u8], byte: u64) {
        let Some(date @ [one, other, _]) = unordered(cell) else { return };
        let shown = || (text(cell).0.into_owned(), byte);
        match &self.first {
            None => self.first = Some((date, shown().0, byte)),
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
