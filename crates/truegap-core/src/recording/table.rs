//! Rows of a CSV, one at a time, with the SHA-256 of the bytes and the line of any row.
//!
//! Limits: the separator is a comma, a semicolon or a tab; the header is one line.

use super::{error::RecordingError, singletact};
use sha2::{Digest, Sha256};
use std::io::{self, BufRead, BufReader, Read, Seek, SeekFrom};
use std::path::{Path, PathBuf};

/// A CSV being read; rows are not kept.
pub(super) struct Table<R> {
    file: PathBuf,
    reader: csv::Reader<Hashing<BufReader<R>>>,
    record: csv::ByteRecord,
    /// names in the header
    pub header: Vec<String>,
    /// whether commas are decimal points
    pub decimal_comma: bool,
    /// whether the vendor's tool wrote it
    pub singletact: bool,
}

impl<R: Read + Seek> Table<R> {
    /// Finds separator and header; the source is read from its beginning.
    pub fn open(file: &Path, mut source: R) -> Result<Self, RecordingError> {
        let failed = |source| RecordingError::Read { file: file.to_owned(), source };
        source.seek(SeekFrom::Start(0)).map_err(failed)?;
        let mut buffered = BufReader::with_capacity(1 << 16, source);
        let start = buffered.fill_buf().map_err(failed)?;
        let comments = has_comments(start);
        let first = first_line(start, comments);
        if first.is_empty() {
            return Err(RecordingError::Empty { file: file.to_owned() });
        }
        let singletact = singletact::wrote(&first);
        let separator = separator(&first);
        let reader = csv::ReaderBuilder::new()
            .has_headers(false)
            .flexible(true)
            .trim(csv::Trim::All)
            .delimiter(separator)
            .comment(comments.then_some(b'#'))
            .from_reader(Hashing { inner: buffered, hash: Sha256::new(), line: 0 });
        let record = csv::ByteRecord::new();
        let decimal_comma = separator != b',';
        let mut table = Self { file: file.to_owned(), reader, record, header: Vec::new(), decimal_comma, singletact };
        if singletact {
            table.advance()?; // start time
        }
        table.read_header()?;
        Ok(table)
    }

    fn read_header(&mut self) -> Result<(), RecordingError> {
        if !self.advance()? {
            return Err(RecordingError::NoRows { file: self.file.clone() });
        }
        self.header = self.record.iter().map(|cell| String::from_utf8_lossy(cell).into_owned()).collect();
        // names of columns behind a hash, as numpy writes them
        if let Some(first) = self.header.first_mut() {
            *first = first.trim_start_matches('#').trim_start().to_owned();
        }
        if let Some(name) = self.header.iter().find(|name| name.contains(char::is_control)) {
            let (file, text) = (self.file.clone(), name.escape_debug().to_string().chars().take(40).collect());
            return Err(RecordingError::NotText { file, text });
        }
        let numbers = self.header.iter().all(|name| name.is_empty() || name.replace(',', ".").parse::<f64>().is_ok());
        match self.header.first() {
            Some(first) if numbers => Err(RecordingError::NoHeader { file: self.file.clone(), first: first.clone() }),
            _ => Ok(()),
        }
    }

    /// Steps to the next row; false at the end.
    pub fn advance(&mut self) -> Result<bool, RecordingError> {
        let read = self.reader.read_byte_record(&mut self.record);
        read.map_err(|error| RecordingError::Read { file: self.file.clone(), source: io::Error::other(error) })
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
        let file = self.file.clone();
        let inner = &mut self.reader.get_mut().inner;
        let counted = inner.stream_position().and_then(|here| {
            inner.seek(SeekFrom::Start(0))?;
            let line = count_lines(inner, byte)?;
            inner.seek(SeekFrom::Start(here))?;
            Ok(line)
        });
        counted.map_err(|source| RecordingError::Read { file, source })
    }

    /// SHA-256 of what was read, as hexadecimal text, and the source.
    pub fn finish(self) -> (String, R) {
        let Hashing { inner, hash, .. } = self.reader.into_inner();
        (hexadecimal(hash), inner.into_inner())
    }
}

/// SHA-256 as hexadecimal text.
pub(super) fn hexadecimal(hash: Sha256) -> String {
    hash.finalize().iter().map(|byte| format!("{byte:02x}")).collect()
}

/// Whether lines that begin with `#` are remarks: not where such a line is all there is above the numbers, since it then holds the names of the columns.
fn has_comments(start: &[u8]) -> bool {
    let is_number = |cell: &str| cell.trim().replace(',', ".").parse::<f64>().is_ok();
    let first = first_line(start, true);
    let separator = char::from(separator(&first));
    first_line(start, false).starts_with('#') && !first.is_empty() && !first.split(separator).all(is_number)
}

/// First line that is not blank, without a byte order mark; none that begins with `#` where those are `comments`.
fn first_line(start: &[u8], comments: bool) -> String {
    let text = String::from_utf8_lossy(start);
    let text = text.trim_start_matches('\u{feff}');
    let mut lines = text.lines().map(str::trim).filter(|line| !(line.is_empty() || comments && line.starts_with('#')));
    lines.next().unwrap_or_default().to_owned()
}

/// The separator that the first line holds most of; a comma where there is none.
fn separator(line: &str) -> u8 {
    let count = |separator: u8| line.bytes().filter(|b| *b == separator).count();
    [b',', b';', b'\t'].into_iter().rev().max_by_key(|s| count(*s)).unwrap_or(b',')
}

/// Line ends before `byte`, and line ends that follow it directly, plus one.
fn count_lines(source: &mut impl BufRead, byte: u64) -> io::Result<usize> {
    let (mut line, mut offset) = (1, 0);
    loop {
        let chunk = source.fill_buf()?;
        if chunk.is_empty() {
            return Ok(line);
        }
        for &b in chunk {
            if offset >= byte && !matches!(b, b'\r' | b'\n') {
                return Ok(line);
            }
            line += usize::from(b == b'\n');
            offset += 1;
        }
        let read = chunk.len();
        source.consume(read);
    }
}

/// Longest line of a table, bytes: a row of a hundred thousand cells.
const LONGEST_LINE: usize = 1 << 20;

/// A reader that hashes what passes, and stops where a line has no end.
struct Hashing<R> {
    inner: R,
    hash: Sha256,
    /// bytes since the last end of a line
    line: usize,
}

impl<R: Read> Read for Hashing<R> {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        let read = self.inner.read(buffer)?;
        let passed = &buffer[..read];
        self.hash.update(passed);
        self.line = passed.iter().rev().position(|b| matches!(b, b'\n' | b'\r')).unwrap_or(self.line + read);
        if self.line > LONGEST_LINE {
            return Err(io::Error::other("a line has more than 1 MB; is it a table? A row ends with a line end"));
        }
        Ok(read)
    }
}
