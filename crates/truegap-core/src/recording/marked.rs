//! Lines that begin with a sign of remarks: remarks, or rows whose first cell is a word that begins so.
//!
//! Limits: a line that holds no number, or fewer cells than the header, is a remark and nothing is told of it.

use super::{error::RecordingError, layout::MARKERS, note::Note, number::number};

/// Whether a cell begins a remark.
pub(super) fn is_marked(cell: &[u8]) -> bool {
    MARKERS.iter().any(|marker| cell.starts_with(marker.as_bytes()))
}

/// Lines with a sign of remarks that look like rows.
#[derive(Clone, Debug, Default)]
pub(super) struct Marked {
    /// how many, and the byte of the first
    seen: Option<(usize, u64)>,
}

impl Marked {
    /// Whether the line is left out; `words` where the first column of the table holds words, so that one of them may begin with any sign.
    pub fn is_remark(&mut self, row: &csv::ByteRecord, width: usize, words: bool, byte: u64) -> bool {
        if !row.get(0).is_some_and(is_marked) {
            return false;
        }
        let enough = if words { row.len() == width } else { row.len() >= width };
        if !(enough && has_number(row)) {
            return true;
        }
        self.seen = Some(self.seen.map_or((1, byte), |(lines, first)| (lines + 1, first)));
        !words
    }

    /// What is told of them, where `line_of` finds the line of a byte; `words` as above.
    ///
    /// # Errors
    /// Those of `line_of`.
    pub fn note(
        &self,
        words: bool,
        line_of: impl FnOnce(u64) -> Result<usize, RecordingError>,
    ) -> Result<Option<Note>, RecordingError> {
        let told = |(lines, byte)| Ok(Note::MarkedRows { lines, first_line: line_of(byte)?, taken: words });
        self.seen.map(told).transpose()
    }
}

/// Whether one of the cells is a number, behind the sign or without it.
fn has_number(row: &csv::ByteRecord) -> bool {
    let bare = |cell: &[u8]| cell.iter().position(|b| !matches!(b, b'#' | b'%' | b'/' | b' ')).unwrap_or(cell.len());
    row.iter().enumerate().any(|(at, cell)| number(if at == 0 { &cell[bare(cell)..] } else { cell }, true).is_ok())
}
