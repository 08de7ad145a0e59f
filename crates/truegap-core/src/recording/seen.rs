//! What stands in a table, as far as a sketch of its TOML asks.
//!
//! Limits: the header and the first rows; all rows only where the order of dates shows in none of these.

use super::{
    columnar, date_order::order, error::RecordingError, frame::FrameColumn, heading::Heading, manifest::Manifest, number::number,
    packed::open_csv, table::Table, told::Told,
};
use std::path::Path;

/// Rows that are looked at for numbers.
const LOOKED_AT: usize = 20;

/// What stands in a table.
pub(super) struct Seen {
    pub header: Vec<Heading>,
    /// whether there are numbers under a heading
    pub numeric: Vec<bool>,
    /// a date of which nobody knows whether it begins with the day or the month
    pub days: Option<String>,
    pub notes: Vec<String>,
}

impl Seen {
    pub fn of_frame(file: &Path, mut frame: columnar::Frame, told: &Told) -> Result<Self, RecordingError> {
        let mut manifest = Manifest::default().told(told, &frame.header());
        let days = unordered(frame.read_dates(file, &manifest))?;
        if days.is_some() {
            // any order will do where values are not looked at
            manifest.dayfirst = Some(true);
            frame.read_dates(file, &manifest)?;
        }
        let header: Vec<Heading> = frame.columns.iter().map(FrameColumn::heading).collect();
        Ok(Self { numeric: vec![true; header.len()], header, days, notes: Vec::new() })
    }

    pub fn of_csv(csv: &Path, told: &Told) -> Result<Self, RecordingError> {
        let mut table = Table::open(csv, open_csv(csv)?)?;
        let header = table.header.clone();
        let mut numeric = vec![false; header.len()];
        for row in 0..LOOKED_AT {
            match (table.advance()?, row) {
                (true, _) => {}
                (false, 0) => return Err(RecordingError::NoRows { file: csv.to_owned() }),
                (false, _) => break,
            }
            let comma = table.decimal_comma;
            let is_number = |index: usize| table.row().get(index).is_some_and(|cell| number(cell, comma).is_ok());
            numeric.iter_mut().enumerate().for_each(|(index, numeric)| *numeric |= is_number(index));
        }
        let notes = table.notes.iter().map(ToString::to_string).collect();
        let days = match header.iter().position(|heading| heading.unordered) {
            Some(index) => {
                let mut again = Table::open(csv, table.finish().1)?;
                unordered(order(&mut again, index, told.dayfirst).map(|_| ()))?
            }
            None => None,
        };
        Ok(Self { header, numeric, days, notes })
    }
}

/// The date that may begin with the day or the month, where that is what is wrong.
fn unordered(read: Result<(), RecordingError>) -> Result<Option<String>, RecordingError> {
    match read {
        Ok(()) => Ok(None),
        Err(RecordingError::DayOrMonth { text, .. } | RecordingError::DayOrYear { text, .. }) => Ok(Some(text)),
        Err(other) => Err(other),
    }
}
