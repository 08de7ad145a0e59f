//! A quote that opens and never closes where it should: the rows behind it stand in one cell.
//!
//! Limits: a cell may hold line ends, as spreadsheets write remarks of several lines; what shows the fault is a line inside of it that is a row.

use super::{layout::cells, number::number};

/// The cell that holds rows of its table, where there is one.
pub(super) fn swallowing(row: &csv::ByteRecord, separator: u8) -> Option<usize> {
    let long = |text: &[u8]| text.iter().any(|b| matches!(b, b'\n' | b'\r'));
    if !long(row.as_slice()) {
        return None;
    }
    let holds_rows = |cell: &[u8]| cell.split(|b| matches!(b, b'\n' | b'\r')).any(|line| is_row(line, row.len(), separator));
    row.iter().position(|cell| long(cell) && holds_rows(cell))
}

/// Whether a line is a row of so many cells, or what the quote has left of one: numbers alone, two or more.
fn is_row(line: &[u8], width: usize, separator: u8) -> bool {
    let cells = cells(line, separator);
    let filled = cells.iter().filter(|cell| !cell.is_empty()).count();
    let numbers = cells.iter().filter(|cell| number(cell, separator != b',').is_ok()).count();
    cells.len() > 1 && numbers > 0 && (cells.len() == width || numbers == filled)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_of_words_are_no_rows() {
        let row = |cells: [&str; 3]| csv::ByteRecord::from(cells.map(str::as_bytes).to_vec());
        assert_eq!(swallowing(&row(["0", "heater on\n15.5,1.1,11.2", "1"]), b','), Some(1));
        assert_eq!(swallowing(&row(["0", "12,0.48,10.5\n20.0,12", "1"]), b','), Some(1));
        assert_eq!(swallowing(&row(["0", "1", "on\r15,5;1,1;"]), b';'), Some(2));
        assert_eq!(swallowing(&row(["0", "heater on,\nthen off, by hand", "1"]), b','), None);
        assert_eq!(swallowing(&row(["0", "heater on\n12", "1"]), b','), None);
        assert_eq!(swallowing(&row(["0", "1,2", "1"]), b','), None);
    }
}
