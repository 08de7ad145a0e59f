//! Why a cell is refused: alone, or with its whole column.
//!
//! Limits: looks on from the first row only, so that a table is read twice at most.

use super::{error::RecordingError, hint::hint, number::number, table::Table, text::text};
use std::io::{Read, Seek};

/// The error of a cell; `is_first` in the first row, where the whole column may be at fault.
pub(super) fn refuse<R: Read + Seek>(
    table: &mut Table<R>,
    index: usize,
    column: &str,
    role: &str,
    is_first: bool,
) -> RecordingError {
    let cell = text(table.row().get(index).unwrap_or_default()).0.into_owned();
    let hint = if cell == column { "it is the header once more; leave the row out" } else { hint(&cell, table.decimal_comma) };
    let (file, name, byte) = (table.file(), column.to_owned(), table.byte());
    let line = match table.line(byte) {
        Ok(line) => line,
        Err(error) => return error,
    };
    if let Some(rows) = is_first.then(|| rows_without_number(table, index, &cell)).flatten() {
        return RecordingError::NoNumbers { file, column: name, role: role.to_owned(), rows, text: cell };
    }
    RecordingError::NotANumber { file, line, column: name, text: cell, hint }
}

/// Rows from this one on, where none has a number in this column and there is more than one.
fn rows_without_number<R: Read + Seek>(table: &mut Table<R>, index: usize, first: &str) -> Option<usize> {
    let mut rows = 1;
    let slip = |cell: &str, comma: bool| hint(cell, comma) != hint("", comma);
    if slip(first, table.decimal_comma) {
        return None;
    }
    while table.advance().ok()? {
        let cell = table.row().get(index).unwrap_or_default();
        if number(cell, table.decimal_comma).is_ok() || slip(&text(cell).0, table.decimal_comma) {
            return None;
        }
        rows += 1;
    }
    (rows > 1).then_some(rows)
}
