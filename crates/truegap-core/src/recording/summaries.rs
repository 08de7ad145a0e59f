//! Rows that sum up others: a mean, a deviation, a sum, which spreadsheets and loggers write below a table.
//!
//! Limits: known by a word (`Mean`, `Summe`) in a column that holds numbers, dates or nothing elsewhere; in a column of words two such rows have to end the table, as a label may be `Max`.

use super::{error::RecordingError, note::Note, number::number, text::text};
use std::collections::VecDeque;

/// Words of such rows, without signs and capitals.
const WORDS: [&str; 44] = [
    "mean",
    "average",
    "avg",
    "median",
    "std",
    "stdev",
    "stddev",
    "sd",
    "standarddeviation",
    "variance",
    "var",
    "rms",
    "min",
    "minimum",
    "max",
    "maximum",
    "range",
    "sum",
    "total",
    "subtotal",
    "grandtotal",
    "count",
    "mittel",
    "mittelwert",
    "durchschnitt",
    "standardabweichung",
    "stabw",
    "summe",
    "gesamt",
    "anzahl",
    "spannweite",
    "moyenne",
    "écarttype",
    "ecarttype",
    "somme",
    "media",
    "promedio",
    "desviaciónestándar",
    "desviacionestandar",
    "suma",
    "deviazionestandard",
    "somma",
    "totale",
    "médiane",
];
/// Lines that are named.
const NAMED: usize = 6;

/// What such a row is called in a cell, where it is one.
fn word(cell: &[u8]) -> Option<String> {
    let plain = |cell: &[u8]| text(cell).0.to_lowercase().chars().filter(|c| c.is_alphabetic()).collect::<String>();
    let may_be = (2..40).contains(&cell.len()) && !cell.iter().any(u8::is_ascii_digit);
    may_be.then(|| plain(cell)).filter(|plain| WORDS.contains(&plain.as_str()))
}

/// What a column holds in its other rows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Holds {
    Numbers,
    Nothing,
    Words,
    /// words, one of which is that of a sum
    SuchWords,
}

/// The rows of a table that sum up others, as they come.
#[derive(Debug, Default)]
pub(super) struct Summaries {
    columns: Vec<Holds>,
    /// words and bytes of those left out
    seen: Vec<(String, u64)>,
    /// rows that were read ahead and are none
    pub waiting: VecDeque<csv::ByteRecord>,
}

impl Summaries {
    /// Looks at the first row; `dated` says of each column whether it holds dates.
    pub fn begin(&mut self, first: &csv::ByteRecord, dated: impl Iterator<Item = bool>) {
        let holds = |(at, dated): (usize, bool)| match first.get(at).unwrap_or_default() {
            cell if dated || number(cell, true).is_ok() => Holds::Numbers,
            [] => Holds::Nothing,
            _ => Holds::Words,
        };
        self.columns = dated.enumerate().map(holds).collect();
    }

    /// The column whose word says that a row sums up others, where there is one.
    pub fn column_of(&mut self, row: &csv::ByteRecord) -> Option<usize> {
        let mut found = None;
        for (at, (cell, holds)) in row.iter().zip(&mut self.columns).enumerate() {
            if *holds != Holds::SuchWords && word(cell).is_some() {
                found = found.or(Some(at));
            } else if *holds == Holds::Nothing && !cell.is_empty() {
                *holds = if number(cell, true).is_ok() { Holds::Numbers } else { Holds::Words };
            }
        }
        found
    }

    /// Whether a row with such a word in that column is left out. Where only the rows behind it can tell, these are asked of `next`.
    ///
    /// # Errors
    /// Those of `next`.
    pub fn leaves_out(
        &mut self,
        at: usize,
        row: &csv::ByteRecord,
        mut next: impl FnMut() -> Result<Option<csv::ByteRecord>, RecordingError>,
    ) -> Result<bool, RecordingError> {
        let cell = |row: &csv::ByteRecord| row.get(at).unwrap_or_default().to_vec();
        let place = |row: &csv::ByteRecord| (text(&cell(row)).0.into_owned(), row.position().map_or(0, csv::Position::byte));
        let (mut words, mut rows) = (vec![word(&cell(row))], vec![place(row)]);
        let ends = self.columns[at] == Holds::Numbers
            || loop {
                let Some(row) = next()? else { break self.columns[at] == Holds::Nothing || rows.len() > 1 };
                let found = word(&cell(&row));
                let goes_on = found.is_some() && !words.contains(&found);
                words.push(found);
                rows.push(place(&row));
                self.waiting.push_back(row);
                if !goes_on {
                    break false;
                }
            };
        if ends {
            self.waiting.clear();
            self.seen.extend(rows);
        } else {
            self.columns[at] = Holds::SuchWords;
        }
        Ok(ends)
    }

    /// What is told of them, where `line_of` finds the line of a byte.
    ///
    /// # Errors
    /// Those of `line_of`.
    pub fn note(
        &mut self,
        mut line_of: impl FnMut(u64) -> Result<usize, RecordingError>,
    ) -> Result<Option<Note>, RecordingError> {
        let seen = std::mem::take(&mut self.seen);
        let mut words: Vec<&str> = Vec::new();
        seen.iter().for_each(|(word, _)| {
            if !words.contains(&word.as_str()) {
                words.push(word)
            }
        });
        let lines = seen.iter().take(NAMED).map(|(_, byte)| line_of(*byte)).collect::<Result<Vec<_>, _>>()?;
        let words = words.iter().take(NAMED).map(|word| format!("`{word}`")).collect::<Vec<_>>().join(", ");
        Ok((!seen.is_empty()).then_some(Note::Summaries { rows: seen.len(), words, lines }))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_of_sums_are_known_however_they_are_written() {
        for cell in ["Mean", "Std. Dev.", "STDEV", "Max.", "Sum:", "Mittelwert", "Écart-type", "min ="] {
            assert!(word(cell.as_bytes()).is_some(), "{cell}");
        }
        for cell in ["", "maximal load", "Max 3", "hold", "nan", "mean force", "s"] {
            assert_eq!(word(cell.as_bytes()), None, "{cell}");
        }
    }
}
