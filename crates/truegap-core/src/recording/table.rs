//! Rows of a CSV, one at a time, with the SHA-256 of the bytes and the line of any row.
//!
//! Limits: the separator is a comma, a semicolon, a tab or blanks; the header is one line, and one of units may follow.

use super::{
    date_and_time::times_without_dates,
    error::RecordingError,
    heading::{Heading, units},
    layout::Layout,
    marked::Marked,
    note::Note,
    source::Source,
    stamp::{is_date, is_day, is_time_of_day, short, unordered},
    summaries::Summaries,
    swallowed::swallowing,
    text::text,
};
use sha2::{Digest, Sha256};
use std::io::{self, Read, Seek};
use std::path::{Path, PathBuf};

/// A CSV being read; rows are not kept.
pub(super) struct Table<R> {
    file: PathBuf,
    reader: csv::Reader<Source<R>>,
    record: csv::ByteRecord,
    /// whether `record` was read and not yet stepped to
    ahead: bool,
    /// whether cells are parted by any number of blanks
    blanks: bool,
    /// the columns
    pub header: Vec<Heading>,
    /// whether commas are decimal points
    pub decimal_comma: bool,
    /// whether cells are parted by semicolons
    pub semicolons: bool,
    /// whether the vendor's tool wrote it
    pub singletact: bool,
    /// rows behind a sign of remarks
    marked: Marked,
    /// rows that sum up others
    summaries: Summaries,
    /// what its reader had to make of it
    pub notes: Vec<Note>,
}

impl<R: Read + Seek> Table<R> {
    /// Finds separator and header; the source is read from its beginning.
    pub fn open(file: &Path, source: R) -> Result<Self, RecordingError> {
        let opened = Source::open(source).map_err(|source| RecordingError::Read { file: file.to_owned(), source })?;
        let source = opened.ok_or_else(|| RecordingError::Empty { file: file.to_owned() })?;
        let layout = source.layout().clone();
        let reader = csv::ReaderBuilder::new()
            .has_headers(false)
            .flexible(true)
            .trim(csv::Trim::All)
            .delimiter(layout.separator)
            .from_reader(source);
        let above = Note::AboveHeader { lines: layout.above, header_line: layout.header_line };
        let mut table = Self {
            file: file.to_owned(),
            reader,
            record: csv::ByteRecord::new(),
            ahead: false,
            blanks: layout.separator == b' ',
            header: Vec::new(),
            decimal_comma: layout.decimal_comma,
            semicolons: layout.separator == b';',
            singletact: layout.singletact,
            marked: Marked::default(),
            summaries: Summaries::default(),
            notes: (layout.above > 0).then_some(above).into_iter().collect(),
        };
        if table.singletact {
            table.advance()?; // start time
        }
        table.read_header()?;
        Ok(table)
    }

    fn read_header(&mut self) -> Result<(), RecordingError> {
        if !self.advance()? {
            return Err(RecordingError::NoRows { file: self.file.clone() });
        }
        let (names, foreign) = self.texts();
        let layout = self.reader.get_ref().layout();
        if layout.headless {
            let first = names.into_iter().next().unwrap_or_default();
            return Err(RecordingError::NoHeader { file: self.file.clone(), line: layout.header_line, first });
        }
        if let Some(name) = names.iter().find(|name| name.contains(char::is_control)) {
            let (file, text) = (self.file.clone(), name.escape_debug().to_string().chars().take(40).collect());
            return Err(RecordingError::NotText { file, text });
        }
        self.header = names.iter().map(|name| Heading::of(name)).collect();
        let mut strange = foreign.map(|at| names[at].clone());
        if !self.singletact && self.advance()? {
            let (cells, foreign) = self.texts();
            let units = units(&cells);
            self.ahead = units.is_none();
            if let Some(units) = units {
                strange = strange.or(foreign.map(|at| cells[at].clone()));
                self.header.iter_mut().zip(units).for_each(|(heading, unit)| heading.below = unit);
                self.ahead = self.advance()?;
            }
            let record = &self.record;
            let cell = |at: usize| record.get(at).filter(|_| self.ahead).unwrap_or_default();
            for (at, heading) in self.header.iter_mut().enumerate() {
                heading.dated = is_date(cell(at));
                heading.days = is_day(cell(at));
                heading.unordered = unordered(cell(at)).is_some() || short(cell(at)).is_some();
                heading.of_day = is_time_of_day(cell(at));
            }
            times_without_dates(&mut self.header);
            let dated = self.header.iter().map(|heading| heading.dated || heading.of_day);
            self.summaries.begin(record, dated);
        }
        self.notes.extend(strange.map(|text| Note::Windows1252 { text }));
        Ok(())
    }

    /// Cells of the row as text, and the first that is no UTF-8.
    fn texts(&self) -> (Vec<String>, Option<usize>) {
        let read: Vec<_> = self.record.iter().map(text).collect();
        let foreign = read.iter().position(|(_, foreign)| *foreign);
        (read.into_iter().map(|(text, _)| text.into_owned()).collect(), foreign)
    }

    /// Steps to the next row; false at the end.
    pub fn advance(&mut self) -> Result<bool, RecordingError> {
        if std::mem::take(&mut self.ahead) {
            return Ok(true);
        }
        if let Some(row) = self.summaries.waiting.pop_front() {
            self.record = row;
            return Ok(true);
        }
        while self.next_row()? {
            let Some(column) = self.summaries.column_of(&self.record) else { return Ok(true) };
            let (mut summaries, row) = (std::mem::take(&mut self.summaries), self.record.clone());
            let left_out = summaries.leaves_out(column, &row, || Ok(self.next_row()?.then(|| self.record.clone())))?;
            (self.summaries, self.record) = (summaries, row);
            if !left_out {
                return Ok(true);
            }
        }
        Ok(false)
    }

    /// The next row that is no remark.
    fn next_row(&mut self) -> Result<bool, RecordingError> {
        while self.read_row()? {
            let (width, words, byte) = (self.header.len(), self.reader.get_ref().layout().words, self.byte());
            if width == 0 || self.singletact || !self.marked.is_remark(&self.record, width, words, byte) {
                return Ok(true);
            }
        }
        Ok(false)
    }

    /// The next row as it stands, whatever it is.
    fn read_row(&mut self) -> Result<bool, RecordingError> {
        let read = self.reader.read_byte_record(&mut self.record);
        if self.blanks && self.record.iter().any(<[u8]>::is_empty) {
            let place = self.record.position().cloned();
            self.record = self.record.iter().filter(|cell| !cell.is_empty()).collect();
            self.record.set_position(place);
        }
        if let Some(at) = swallowing(&self.record, self.reader.get_ref().layout().separator) {
            let column = self.header.get(at).map_or_else(|| (at + 1).to_string(), |heading| format!("`{}`", heading.name));
            let line = self.line(self.byte())?;
            return Err(RecordingError::OpenQuote { file: self.file.clone(), line, column });
        }
        read.map_err(|error| RecordingError::Read { file: self.file.clone(), source: io::Error::other(error) })
    }

    /// Tells of rows that were left out, or read for want of a better word, once all are read.
    pub fn tell_left_out(&mut self) -> Result<(), RecordingError> {
        let (marked, mut summaries) = (std::mem::take(&mut self.marked), std::mem::take(&mut self.summaries));
        let Layout { words, plain, .. } = *self.reader.get_ref().layout();
        let marked = marked.note(words, |byte| self.line(byte))?.filter(|_| plain);
        let sums = summaries.note(|byte| self.line(byte))?;
        self.notes.extend(marked.into_iter().chain(sums));
        Ok(())
    }

    /// Cells of the row.
    pub fn row(&self) -> &csv::ByteRecord {
        &self.record
    }

    /// Name of the file, for messages.
    pub fn file(&self) -> PathBuf {
        self.file.clone()
    }

    /// Offset of the row in bytes, from which [`Table::line`] finds its line.
    pub fn byte(&self) -> u64 {
        self.record.position().map_or(0, csv::Position::byte)
    }

    /// Line, from 1, of the row that begins at or after the line ends at `byte`; reads the source again, so only for messages.
    pub fn line(&mut self, byte: u64) -> Result<usize, RecordingError> {
        let counted = self.reader.get_mut().line_of(byte);
        counted.map_err(|source| RecordingError::Read { file: self.file.clone(), source })
    }

    /// SHA-256 of what was read, as hexadecimal text, and the source.
    pub fn finish(self) -> (String, R) {
        let (hash, source) = self.reader.into_inner().finish();
        (hexadecimal(hash), source)
    }
}

/// SHA-256 as hexadecimal text.
pub(super) fn hexadecimal(hash: Sha256) -> String {
    hash.finalize().iter().map(|byte| format!("{byte:02x}")).collect()
}
