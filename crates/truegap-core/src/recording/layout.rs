//! How a table is laid out, from its first lines: in which letters, with which separator, where its header stands, and which lines are remarks.
//!
//! Limits: the first 64 kB; a table begins there.

use super::{
    number::number,
    separators::{has_thousands, may_be_grouped},
    singletact,
    stamp::{is_date, is_time_of_day},
};

/// Signs that begin a remark.
pub(super) const MARKERS: [&str; 3] = ["#", "%", "//"];
/// Separators, the one to be taken last where nothing tells them apart first. Blanks are looked at where none of them stands.
const SEPARATORS: [u8; 3] = [b'\t', b';', b','];
/// Lines that are looked at.
const LOOKED_AT: usize = 200;

/// Letters of a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Letters {
    /// one byte for what ASCII has: UTF-8, Windows-1252
    Bytes,
    Utf16Le,
    Utf16Be,
}

impl Letters {
    /// By the byte order mark.
    pub fn of(start: &[u8]) -> Self {
        match start {
            [0xff, 0xfe, ..] => Self::Utf16Le,
            [0xfe, 0xff, ..] => Self::Utf16Be,
            _ => Self::Bytes,
        }
    }
}

/// Where things stand in a table.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Layout {
    /// first byte of the header, behind its marker where it has one
    pub header_at: u64,
    /// line of the header, from 1
    pub header_line: usize,
    pub separator: u8,
    /// whether commas are decimal points: where they part no cells, or where cells in quotes show it
    pub decimal_comma: bool,
    /// whether the first column holds words, one of which may begin as a remark does
    pub words: bool,
    /// whether rows stand among them that begin with no sign of remarks
    pub plain: bool,
    /// lines above the header that are neither remarks nor blank
    pub above: usize,
    /// whether there are numbers where the header should be
    pub headless: bool,
    /// whether the vendor's tool wrote it
    pub singletact: bool,
}

/// A line that is not blank.
struct Line<'a> {
    at: usize,
    number: usize,
    text: &'a [u8],
}

impl Line<'_> {
    /// The marker that it begins with.
    fn marker(&self) -> Option<usize> {
        MARKERS.iter().position(|marker| self.text.starts_with(marker.as_bytes()))
    }

    /// Bytes of the markers and blanks that it begins with.
    fn behind_marker(&self) -> usize {
        let marker = self.marker().map_or(0, |marker| usize::from(MARKERS[marker].as_bytes()[0]));
        self.text.iter().take_while(|b| usize::from(**b) == marker || b.is_ascii_whitespace()).count()
    }
}

impl Layout {
    /// The layout of a table that starts so; `None` where there is no line. `whole` where nothing follows.
    pub fn of<'a>(start: &'a [u8], whole: bool) -> Option<Self> {
        let lines = lines(start, whole);
        let first = lines.first()?;
        let cut = |line: &Line<'a>| cells(line.text, most(first.text));
        let singletact = lines.get(1).is_some_and(|header| singletact::wrote(&cut(first), &cut(header)));
        let plain = without_footer(lines.iter().filter(|line| singletact || line.marker().is_none()).collect());
        if singletact {
            let separator = most(first.text);
            let (header_at, header_line, decimal_comma) = (first.at as u64, first.number, separator != b',');
            let (words, plain, above, headless) = (true, true, 0, false);
            return Some(Self { header_at, header_line, separator, decimal_comma, words, plain, above, headless, singletact });
        }
        let separator = separator(&plain).unwrap_or_else(|| most(plain.first().unwrap_or(&first).text));
        let (header, marked) = header(&lines, &plain, separator);
        let rows = plain.iter().filter(|line| line.at > header.at && has_number(line, separator));
        let firsts: Vec<&[u8]> = rows.filter_map(|line| cells(line.text, separator).first().copied()).collect();
        let skip = if marked { header.behind_marker() } else { 0 };
        Some(Self {
            header_at: (header.at + skip) as u64,
            header_line: header.number,
            separator,
            decimal_comma: separator != b',' || quoted_decimals(&plain),
            words: firsts.iter().all(|cell| is_word(cell)),
            plain: !firsts.is_empty(),
            above: plain.iter().filter(|line| line.at < header.at).count(),
            headless: !marked && all_numbers(header, separator),
            singletact,
        })
    }
}

/// Lines that are not blank, without a byte order mark; the last one only where it is whole.
fn lines(start: &[u8], whole: bool) -> Vec<Line<'_>> {
    let mark = if start.starts_with(b"\xef\xbb\xbf") { 3 } else { 0 };
    let (mut found, mut at, mut number) = (Vec::new(), mark, 1);
    let end_of = |from: usize| start[from..].iter().position(|b| matches!(b, b'\n' | b'\r')).map(|length| from + length);
    while at < start.len() && found.len() < LOOKED_AT {
        let end = end_of(at);
        if end.is_none() && !whole && !found.is_empty() {
            break;
        }
        let end = end.unwrap_or(start.len());
        let text = &start[at..end];
        if text.iter().any(|b| !b.is_ascii_whitespace()) {
            found.push(Line { at, number, text });
        }
        number +=
            usize::from(start.get(end) == Some(&b'\n') || (start.get(end) == Some(&b'\r') && start.get(end + 1) != Some(&b'\n')));
        at = end + 1;
    }
    found
}

/// The lines up to the last that holds a number: what somebody wrote below a table is as wide as it likes.
fn without_footer<'a>(mut plain: Vec<&'a Line<'a>>) -> Vec<&'a Line<'a>> {
    let parted = plain.iter().any(|line| line.text.iter().any(|b| SEPARATORS.contains(b)));
    let separators: &[u8] = if parted { &SEPARATORS } else { b" " };
    let last = plain.iter().rposition(|line| separators.iter().any(|separator| has_number(line, *separator)));
    plain.truncate(last.map_or(plain.len(), |last| last + 1));
    plain
}

/// The header, and whether it stands behind a marker.
fn header<'a>(lines: &'a [Line<'a>], plain: &[&'a Line<'a>], separator: u8) -> (&'a Line<'a>, bool) {
    let Some(first) = plain.first() else {
        return (&lines[lines.len() - 1], true); // remarks alone: the last may hold the names of columns without a row
    };
    let width = plain.last().map_or(1, |last| cells(last.text, separator).len());
    let names = |line: &Line<'_>, from: usize| {
        let text = &line.text[from..];
        cells(text, separator).len() == width && !cells(text, separator).iter().any(|cell| is_number(cell))
    };
    if has_number(first, separator) {
        // the names of the columns behind a marker, as numpy and Matlab write them
        let above = lines.iter().rev().find(|line| line.at < first.at && line.marker().is_some());
        if let Some(header) = above.filter(|line| names(line, line.behind_marker())) {
            return (header, true);
        }
    }
    if cells(first.text, separator).len() == width {
        return (first, false);
    }
    // what an instrument says of itself above its table
    (plain.iter().find(|line| names(line, 0)).unwrap_or(first), false)
}

/// The separator by which most lines up to the last fall into the same number of cells, and most cells are numbers; `None` where none does.
fn separator(plain: &[&Line<'_>]) -> Option<u8> {
    let score = |separator: u8| {
        let last = cells(plain.last()?.text, separator).len();
        let same: Vec<_> =
            plain.iter().rev().map(|line| cells(line.text, separator)).take_while(|cells| cells.len() == last).collect();
        let numbers = same.iter().flatten().filter(|cell| is_number(cell)).count();
        let share = numbers as f64 / (last * same.len()) as f64;
        (last > 1 && same.len() > 1 && share > 0.0).then_some((same.len(), share, last))
    };
    let scores = SEPARATORS.into_iter().filter_map(|separator| Some((score(separator)?, separator)));
    let best = scores.max_by(|((a_lines, a, a_cells), _), ((b_lines, b, b_cells), _)| {
        a_lines.cmp(b_lines).then(a.total_cmp(b)).then(a_cells.cmp(b_cells))
    });
    match best {
        Some((_, separator)) => Some(separator),
        // columns of numbers and nothing else, as numpy writes them
        None => score(b' ').filter(|(_, share, _)| *share > 0.5).map(|_| b' '),
    }
}

/// The separator that a line holds most of; a comma where there is none.
fn most(line: &[u8]) -> u8 {
    let count = |separator: u8| line.iter().filter(|b| **b == separator).count();
    SEPARATORS.into_iter().max_by_key(|s| count(*s)).unwrap_or(b',')
}

/// Whether a cell is neither a number nor a time.
fn is_word(cell: &[u8]) -> bool {
    !is_number(cell) && !is_date(cell) && !is_time_of_day(cell)
}

/// Cells of a line, trimmed; what stands in quotes is not cut.
pub(super) fn cells(line: &[u8], separator: u8) -> Vec<&[u8]> {
    let mut quoted = false;
    let cut = |b: &u8| {
        quoted ^= *b == b'"';
        *b == separator && !quoted
    };
    let cells = line.split(cut).map(<[u8]>::trim_ascii);
    let cells = cells.map(|cell| cell.strip_prefix(b"\"").and_then(|cell| cell.strip_suffix(b"\"")).unwrap_or(cell));
    if separator == b' ' { cells.filter(|cell| !cell.is_empty()).collect() } else { cells.collect() }
}

/// Whether a cell is a number: with a comma it is one with decimals or one in thousands, as commas that part cells are cut away.
fn is_number(cell: &[u8]) -> bool {
    number(cell, true).is_ok() || has_thousands(cell)
}

/// Whether commas in quotes are decimal points in a table whose cells commas part: one can be nothing else, and no number has a point.
fn quoted_decimals(plain: &[&Line<'_>]) -> bool {
    let numbers: Vec<&[u8]> = plain.iter().flat_map(|line| cells(line.text, b',')).filter(|cell| is_number(cell)).collect();
    numbers.iter().any(|cell| cell.contains(&b',') && !may_be_grouped(cell, b','))
        && !numbers.iter().any(|cell| cell.contains(&b'.'))
}

fn has_number(line: &Line<'_>, separator: u8) -> bool {
    cells(line.text, separator).iter().any(|cell| is_number(cell))
}

fn all_numbers(line: &Line<'_>, separator: u8) -> bool {
    let blank_or_number = |cell: &&[u8]| is_number(cell) || cell.is_empty();
    has_number(line, separator) && cells(line.text, separator).iter().all(blank_or_number)
}
