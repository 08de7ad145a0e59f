//! What commas and points stand for in each column of a table whose cells they do not part: decimals, or groups of three digits.
//!
//! Limits: a sign is one of decimals, or of thousands, in the whole column; where nothing in it tells, the other columns are asked, and where they do not, the column is refused.

use super::{
    error::RecordingError,
    separators::{has_thousands, may_be_grouped},
    table::Table,
    text::text,
};
use std::io::{Read, Seek};

/// The sign between thousands of a column, where it has one.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) enum Thousands {
    #[default]
    None,
    Commas,
    Points,
}

impl Thousands {
    /// A cell in groups of three digits, without the sign between them.
    pub fn taken_out(self, cell: &[u8]) -> Option<Vec<u8>> {
        let sign = match self {
            Self::None => return None,
            Self::Commas => b',',
            Self::Points => b'.',
        };
        let grouped = cell.contains(&sign) && (may_be_grouped(cell, sign) || has_thousands(cell));
        grouped.then(|| cell.iter().copied().filter(|b| *b != sign).collect())
    }
}

/// What a column shows of one of the two signs.
#[derive(Clone, Debug, Default)]
struct Shown {
    /// it can only stand before decimals
    decimal: bool,
    /// it can only stand between thousands
    grouped: bool,
    /// it may be either; the first such cell, or one between thousands, and its place
    first: Option<(String, u64)>,
}

/// What a column shows.
#[derive(Clone, Debug, Default)]
struct Column {
    comma: Shown,
    point: Shown,
    /// whether a number below a thousand stands there without a comma, and without a point
    short: [bool; 2],
    /// whether a thousand or more does
    long: [bool; 2],
}

impl Column {
    fn see(&mut self, cell: &[u8], byte: u64) {
        let Some(mantissa) = mantissa(cell) else { return };
        let has = |sign: u8| mantissa.contains(&sign);
        let whole = mantissa.split(|b| matches!(b, b',' | b'.')).next().unwrap_or_default().len();
        for (at, _) in [b',', b'.'].into_iter().enumerate().filter(|(_, sign)| !has(*sign)) {
            self.short[at] |= (1..=3).contains(&whole);
            self.long[at] |= whole > 3;
        }
        let seen = |shown: &mut Shown| {
            shown.first.get_or_insert_with(|| (text(cell).0.into_owned(), byte));
        };
        let last = mantissa.iter().rposition(|b| matches!(b, b',' | b'.')).unwrap_or_default();
        match (has(b','), has(b'.')) {
            (true, true) => {
                let (decimal, group, sign) = match mantissa[last] {
                    b',' => (&mut self.comma, &mut self.point, b'.'),
                    _ => (&mut self.point, &mut self.comma, b','),
                };
                if may_be_grouped(&mantissa[..last], sign) {
                    (decimal.decimal, group.grouped) = (true, true);
                    seen(group);
                }
            }
            (false, false) => {}
            (comma, _) => {
                let (shown, sign) = if comma { (&mut self.comma, b',') } else { (&mut self.point, b'.') };
                match (may_be_grouped(mantissa, sign), mantissa.iter().filter(|b| **b == sign).count()) {
                    (true, 1) => seen(shown),
                    (true, _) => {
                        shown.grouped = true;
                        seen(shown);
                    }
                    (false, 1) => shown.decimal = true,
                    (false, _) => {}
                }
            }
        }
    }
}

/// Digits and signs of a number without its own sign and exponent; `None` where it is none, or has an exponent, behind which nobody writes thousands.
fn mantissa(cell: &[u8]) -> Option<&[u8]> {
    let cell = cell.trim_ascii();
    let bare = cell.strip_prefix(b"-").or_else(|| cell.strip_prefix(b"+")).unwrap_or(cell);
    let fits = bare.iter().all(|b| b.is_ascii_digit() || matches!(b, b',' | b'.')) && bare.iter().any(u8::is_ascii_digit);
    fits.then_some(bare)
}

/// Why the signs of a column are not known.
struct Doubt {
    cell: String,
    byte: u64,
}

/// The signs of all columns.
pub(super) struct Signs {
    columns: Vec<Column>,
    /// whether semicolons part the cells: who writes them keeps the comma for decimals
    semicolons: bool,
}

impl Signs {
    /// Reads a table to its end.
    ///
    /// # Errors
    /// Those of reading.
    pub fn of<R: Read + Seek>(table: &mut Table<R>) -> Result<Self, RecordingError> {
        let mut columns = vec![Column::default(); table.header.len()];
        while table.advance()? {
            let byte = table.byte();
            columns.iter_mut().zip(table.row()).for_each(|(column, cell)| column.see(cell, byte));
        }
        Ok(Self { columns, semicolons: table.semicolons })
    }

    /// The sign between thousands in each of the columns that are `used`, none in the others.
    ///
    /// # Errors
    /// [`RecordingError::PointOrThousands`] where it is not known.
    pub fn thousands<R: Read + Seek>(
        &self,
        table: &mut Table<R>,
        used: impl Iterator<Item = usize>,
    ) -> Result<Vec<Thousands>, RecordingError> {
        let mut found = vec![Thousands::None; self.columns.len()];
        for index in used {
            match self.of_column(index) {
                Ok(thousands) => found[index] = thousands,
                Err(Doubt { cell, byte }) => {
                    let (file, column) = (table.file(), table.header[index].name.clone());
                    return Err(RecordingError::PointOrThousands { file, line: table.line(byte)?, column, text: cell });
                }
            }
        }
        Ok(found)
    }

    fn of_column(&self, index: usize) -> Result<Thousands, Doubt> {
        let Some(column) = self.columns.get(index) else { return Ok(Thousands::None) };
        let Column { comma, point, .. } = column;
        let doubt = |shown: &Shown| {
            let (cell, byte) = shown.first.clone().unwrap_or_default();
            Err(Doubt { cell, byte })
        };
        let any = |decimal: fn(&Column) -> bool| self.columns.iter().any(decimal);
        let (commas, points) = (any(|c| c.comma.decimal), any(|c| c.point.decimal));
        // numbers below a thousand without the sign, and none above: what a decimal sign before three digits would not leave
        let in_groups = |at: usize| column.short[at] && !column.long[at];
        match (comma.grouped, point.grouped) {
            (true, true) => doubt(comma),
            (true, false) if comma.decimal || column.long[0] => doubt(comma),
            (true, false) => Ok(Thousands::Commas),
            (false, true) if point.decimal || column.long[1] => doubt(point),
            (false, true) => Ok(Thousands::Points),
            (false, false) if comma.first.is_some() && !comma.decimal => match (commas, points) {
                (true, false) => Ok(Thousands::None),
                (false, true) if point.decimal && !column.long[0] || in_groups(0) => Ok(Thousands::Commas),
                (false, false) if self.semicolons && !column.short[0] => Ok(Thousands::None),
                _ => doubt(comma),
            },
            (false, false) if point.first.is_some() && !point.decimal && (commas || comma.first.is_some()) => doubt(point),
            (false, false) => Ok(Thousands::None),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Columns of cells, parted by blanks.
    fn found(columns: &[&str], semicolons: bool) -> Option<Vec<Thousands>> {
        let seen = |cells: &&str| {
            let mut column = Column::default();
            cells.split(' ').for_each(|cell| column.see(cell.as_bytes(), 0));
            column
        };
        let signs = Signs { columns: columns.iter().map(seen).collect(), semicolons };
        (0..columns.len()).map(|index| signs.of_column(index).ok()).collect()
    }

    #[test]
    fn what_a_sign_stands_for_is_told_by_its_column_and_then_by_the_others() {
        use Thousands::{Commas, None as Neither, Points};
        let cases: [(&[&str], Option<&[Thousands]>); 16] = [
            (&["0.5 1.0", "800 1,112 1,252"], Some(&[Neither, Commas])),
            (&["0 1", "1,234.5 12.5"], Some(&[Neither, Commas])),
            (&["0 1", "1.234,5 12,5"], Some(&[Neither, Points])),
            (&["0 1", "1.234.567 12,5"], Some(&[Neither, Points])),
            (&["0 1", "999.5 1,250"], Some(&[Neither, Commas])),
            (&["0,5 1,0", "1,112 1,252"], Some(&[Neither, Neither])),
            (&["0,5 1,0", "0,512 1,252"], Some(&[Neither, Neither])),
            (&["0.5 1.0", "1.112 1.252"], Some(&[Neither, Neither])),
            (&["0 1", "1.112 1.252"], Some(&[Neither, Neither])),
            (&["0.5 1.0", "1,112 1,252"], None),
            (&["0 1", "1,112 1,252"], None),
            (&["0.5 1.0", "1500 1,112"], None),
            (&["0,5 1,0", "1.112 1.252"], None),
            (&["0 1", "1,234.5 12,5"], None),
            (&["0 1", "1,234.5 1.234,5"], None),
            (&["0,5 1.0", "800 1,112"], None),
        ];
        for (columns, wanted) in cases {
            assert_eq!(found(columns, false).as_deref(), wanted, "{columns:?}");
        }
    }

    /// Whole seconds and three decimals throughout, as a German logger writes them between semicolons.
    #[test]
    fn between_semicolons_a_comma_in_every_number_stands_before_decimals() {
        let columns = ["1 2 3", "2,111 74,115 115,250"];
        assert_eq!(found(&columns, true).as_deref(), Some(&[Thousands::None; 2][..]));
        assert_eq!(found(&columns, false), None);
        // a number below a thousand without one speaks against it
        assert_eq!(found(&["1 2 3", "800 1,112 1,252"], true), None);
    }
}
