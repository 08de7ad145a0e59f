//! Dates that a frame holds as text, read as those of a CSV are.
//!
//! Limits: one column; which of day and month stands first has to be seen in it.

use super::{
    date_order::order_of,
    error::RecordingError,
    frame::{Cells, FrameColumn},
    number::{Fault, number},
    stamp::{is_date, stamp},
    zones::Zones,
};
use std::borrow::Cow;
use std::path::Path;

/// The column `name` of the frame `file`, whose cells are dates as text, as seconds since the whole second of the first; `None` where its first cell is no date.
///
/// `dayfirst` says which of day and month stands first, where the cells do not show it. A cell that is absent, empty or `nan` is a hole. Lines in messages are rows, counted from 1.
///
/// # Errors
/// [`RecordingError::NotADate`] where a later cell is something else, [`RecordingError::MixedZones`] where some have a zone and some have none, [`RecordingError::DayOrMonth`],
/// [`RecordingError::DayOrYear`] and [`RecordingError::BothOrders`] where the order of day and month, or of day and year, is not known.
pub fn dates_of_text(
    file: &Path,
    name: &str,
    cells: &[Option<&str>],
    dayfirst: Option<bool>,
) -> Result<Option<FrameColumn<'static>>, RecordingError> {
    let Some(first) = first_text(cells.iter().flatten().copied()).filter(|cell| is_date(cell.as_bytes())) else {
        return Ok(None);
    };
    let order = order_of(file, name, cells, dayfirst)?;
    let (mut epoch, mut zones) = (None, Zones::default());
    let mut values = Vec::with_capacity(cells.len());
    for (row, cell) in cells.iter().enumerate() {
        let Some(cell) = cell.filter(is_there) else {
            values.push(f64::NAN);
            continue;
        };
        let Some(stamp) = stamp(cell.as_bytes(), order) else {
            let (file, column) = (file.to_owned(), name.to_owned());
            return Err(RecordingError::NotADate { file, line: row + 1, column, text: cell.to_owned() });
        };
        if let Some(first) = zones.see(stamp, cell.as_bytes()) {
            let (file, column, says) = (file.to_owned(), name.to_owned(), if stamp.zoned { "has a zone" } else { "has no zone" });
            return Err(RecordingError::MixedZones { file, line: row + 1, column, text: cell.to_owned(), says, first });
        }
        values.push((stamp.seconds - *epoch.get_or_insert(stamp.seconds)) as f64 + stamp.fraction);
    }
    let cells = Cells::Dates { first: first.trim().to_owned() };
    Ok(Some(FrameColumn { name: name.to_owned(), values: Cow::Owned(values), cells }))
}

/// The first of the cells that is no hole.
pub(super) fn first_text<'a>(mut cells: impl Iterator<Item = &'a str>) -> Option<&'a str> {
    cells.find(is_there)
}

fn is_there(cell: &&str) -> bool {
    number(cell.as_bytes(), false) != Err(Fault::NoValue)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(cells: &[&str]) -> Result<Option<FrameColumn<'static>>, RecordingError> {
        let cells: Vec<Option<&str>> = cells.iter().copied().map(Some).collect();
        dates_of_text(Path::new("frame"), "when", &cells, None)
    }

    #[test]
    fn dates_as_text_are_seconds_since_the_first() {
        let column = read(&["2026-03-01 12:00:00.5", "", "2026-03-01 12:00:02", "2026-03-01 13:00:00"]).unwrap().unwrap();
        assert!(column.values[1].is_nan());
        assert_eq!([column.values[0], column.values[2], column.values[3]], [0.5, 2.0, 3600.0]);
        assert_eq!(column.cells, Cells::Dates { first: "2026-03-01 12:00:00.5".into() });
        let months = read(&["02/28/2026 12:00", "03/01/2026 12:00"]).unwrap().unwrap();
        assert_eq!(months.values[1], 86_400.0);
    }

    #[test]
    fn what_is_no_clock_or_a_doubtful_one_is_said_to_be_so() {
        assert_eq!(read(&["left", "right"]).unwrap(), None);
        assert_eq!(read(&["", "nan"]).unwrap(), None);
        let told = |cells: &[&str]| read(cells).unwrap_err().to_string();
        let text = told(&["2026-03-01 12:00", "later"]);
        assert!(text.contains("line 2") && text.contains("`later`"), "{text}");
        let text = told(&["01/03/2026 12:00", "02/03/2026 12:00"]);
        assert!(text.contains("line 1") && text.contains("day or with the month"), "{text}");
        let text = told(&["2026-03-01 12:00:00+01:00", "2026-03-01 12:00:01"]);
        assert!(text.contains("line 2") && text.contains("has no zone"), "{text}");
    }
}
