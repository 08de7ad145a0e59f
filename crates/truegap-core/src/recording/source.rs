//! The bytes of a table as its reader gets them: UTF-8 in place of UTF-16, nothing above the header, no quotes in remarks; and their SHA-256.
//!
//! Limits: what is left out becomes carriage returns, so that places and lines stay what they were; the hash is that of the file.

use super::layout::{Layout, Letters};
use encoding_rs::{Decoder, UTF_16BE, UTF_16LE};
use sha2::{Digest, Sha256};
use std::io::{self, BufRead, BufReader, Read, Seek, SeekFrom};

/// Longest line of a table, bytes: a row of a hundred thousand cells.
const LONGEST_LINE: usize = 1 << 20;
/// Bytes that are read at a time.
const CHUNK: usize = 1 << 16;

/// A table's bytes.
pub(super) struct Source<R> {
    decoded: Decoded<R>,
    filter: Filter,
    /// bytes since the last end of a line
    line: usize,
}

impl<R: Read + Seek> Source<R> {
    /// Looks at the beginning of a table; `None` where nothing stands in it.
    pub fn open(mut inner: R) -> io::Result<Option<Self>> {
        inner.seek(SeekFrom::Start(0))?;
        let mut inner = BufReader::with_capacity(CHUNK, inner);
        let start = inner.fill_buf()?;
        let (letters, whole) = (Letters::of(start), start.len() < CHUNK);
        let layout = match decoder(letters) {
            None => Layout::of(start, whole),
            Some(mut decoder) => {
                let mut text = String::with_capacity(2 * start.len());
                let (.., no_letters) = decoder.decode_to_string(start, &mut text, whole);
                refuse(no_letters)?;
                Layout::of(text.as_bytes(), whole)
            }
        };
        Ok(layout.map(|layout| Self { decoded: Decoded::new(inner, letters), filter: Filter::new(layout), line: 0 }))
    }

    /// Where things stand in it.
    pub fn layout(&self) -> &Layout {
        &self.filter.layout
    }

    /// Line, from 1, of the row that begins at or after the line ends at `byte` of what was handed on; reads the table again.
    pub fn line_of(&mut self, byte: u64) -> io::Result<usize> {
        let here = self.decoded.inner.stream_position()?;
        self.decoded.inner.seek(SeekFrom::Start(0))?;
        let again = Decoded::new(BufReader::with_capacity(CHUNK, self.decoded.inner.by_ref()), self.decoded.letters);
        let line = count_lines(again, Filter::new(self.filter.layout.clone()), byte)?;
        self.decoded.inner.seek(SeekFrom::Start(here))?;
        Ok(line)
    }

    /// Hash of what was read, and the file.
    pub fn finish(self) -> (Sha256, R) {
        (self.decoded.hash, self.decoded.inner.into_inner())
    }
}

impl<R: Read> Read for Source<R> {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        let read = self.decoded.read(buffer)?;
        let passed = &mut buffer[..read];
        self.line = passed.iter().rev().position(|b| is_end(*b)).unwrap_or(self.line + read);
        if self.line > LONGEST_LINE {
            return Err(io::Error::other("a line has more than 1 MB; is it a table? A row ends with a line end"));
        }
        self.filter.blank(passed);
        Ok(read)
    }
}

/// A file as UTF-8 where it is UTF-16, else as it is.
struct Decoded<R> {
    inner: BufReader<R>,
    hash: Sha256,
    letters: Letters,
    decoder: Option<Decoder>,
    ready: String,
    taken: usize,
    over: bool,
}

fn decoder(letters: Letters) -> Option<Decoder> {
    match letters {
        Letters::Bytes => None,
        Letters::Utf16Le => Some(UTF_16LE.new_decoder_with_bom_removal()),
        Letters::Utf16Be => Some(UTF_16BE.new_decoder_with_bom_removal()),
    }
}

/// Refuses text that begins as UTF-16 and is none.
fn refuse(no_letters: bool) -> io::Result<()> {
    let why = "it begins as UTF-16 and holds what is no letter there; save it again with the encoding UTF-8";
    if no_letters { Err(io::Error::new(io::ErrorKind::InvalidData, why)) } else { Ok(()) }
}

impl<R: Read> Decoded<R> {
    fn new(inner: BufReader<R>, letters: Letters) -> Self {
        let (decoder, ready) = (decoder(letters), String::new());
        Self { inner, hash: Sha256::new(), letters, decoder, ready, taken: 0, over: false }
    }

    /// Decodes more text, none at the end.
    fn refill(&mut self, decoder: &mut Decoder) -> io::Result<()> {
        self.ready.clear();
        self.taken = 0;
        while self.ready.is_empty() && !self.over {
            let raw = self.inner.fill_buf()?;
            let read = raw.len();
            self.over = read == 0;
            self.hash.update(raw);
            self.ready.reserve(decoder.max_utf8_buffer_length(read).unwrap_or(4 * CHUNK));
            let (.., no_letters) = decoder.decode_to_string(raw, &mut self.ready, self.over); // there is room for all of it
            self.inner.consume(read);
            refuse(no_letters)?;
        }
        Ok(())
    }
}

impl<R: Read> Read for Decoded<R> {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        let Some(mut decoder) = self.decoder.take() else {
            let read = self.inner.read(buffer)?;
            self.hash.update(&buffer[..read]);
            return Ok(read);
        };
        let filled = if self.taken == self.ready.len() { self.refill(&mut decoder) } else { Ok(()) };
        self.decoder = Some(decoder);
        filled?;
        let left = &self.ready.as_bytes()[self.taken..];
        let handed = left.len().min(buffer.len());
        buffer[..handed].copy_from_slice(&left[..handed]);
        self.taken += handed;
        Ok(handed)
    }
}

/// Takes away what stands above the header, and the quotes of remarks.
struct Filter {
    layout: Layout,
    /// bytes that have passed
    at: u64,
    /// whether the next byte begins a line
    begins: bool,
    /// whether it belongs to a remark
    remark: bool,
}

impl Filter {
    fn new(layout: Layout) -> Self {
        Self { layout, at: 0, begins: false, remark: false }
    }

    fn blank(&mut self, passed: &mut [u8]) {
        let above = self.layout.header_at.saturating_sub(self.at).min(passed.len() as u64) as usize;
        self.at += passed.len() as u64;
        passed[..above].iter_mut().filter(|b| **b != b'\n').for_each(|b| *b = b'\r');
        let mut rest = &mut passed[above..];
        while let Some(first) = rest.first() {
            if self.begins {
                self.remark = !self.layout.words && matches!(first, b'#' | b'%' | b'/');
            }
            let end = rest.iter().position(|b| is_end(*b));
            let length = end.unwrap_or(rest.len());
            if self.remark {
                // a quote that a remark opens would hold the rows behind it
                rest[..length].iter_mut().filter(|b| **b == b'"').for_each(|b| *b = b'\'');
            }
            self.begins = end.is_some();
            rest = &mut rest[length + usize::from(self.begins)..];
        }
    }
}

fn is_end(b: u8) -> bool {
    matches!(b, b'\n' | b'\r')
}

/// Line ends before `byte`, and line ends that follow it directly, plus one; what was taken away is no line end.
fn count_lines<R: Read>(mut source: Decoded<R>, mut filter: Filter, byte: u64) -> io::Result<usize> {
    let (mut line, mut offset, mut buffer) = (1, 0, vec![0; CHUNK]);
    loop {
        let read = source.read(&mut buffer)?;
        if read == 0 {
            return Ok(line);
        }
        filter.blank(&mut buffer[..read]);
        for &b in &buffer[..read] {
            if offset >= byte && !is_end(b) {
                return Ok(line);
            }
            line += usize::from(b == b'\n');
            offset += 1;
        }
    }
}
