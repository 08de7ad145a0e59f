//! Points in a column whose decimal sign is a comma: decimal points as well, or signs between thousands?
//!
//! Limits: `12.500` alone may be both; `0.500` and `12.5` are decimals.

/// What the points of one column may be.
#[derive(Clone, Debug, Default)]
pub(super) struct Separators {
    /// a point that can be nothing but a decimal one
    decimal: bool,
    /// the first cell whose points may stand between thousands, and its place
    grouped: Option<(u64, String)>,
}

impl Separators {
    /// Looks at a cell that is a number.
    pub fn see(&mut self, cell: &[u8], byte: u64) {
        if self.decimal || !cell.contains(&b'.') {
            return;
        }
        if !may_be_grouped(cell, b'.') {
            self.decimal = true;
        } else if self.grouped.is_none() {
            self.grouped = Some((byte, String::from_utf8_lossy(cell).trim().to_owned()));
        }
    }

    /// The first cell that may be either, where no other cell tells.
    pub fn doubtful(&self) -> Option<(u64, &str)> {
        self.grouped.as_ref().filter(|_| !self.decimal).map(|(byte, text)| (*byte, text.as_str()))
    }
}

/// One to three digits, the first no zero, and groups of three behind `sign`.
pub(super) fn may_be_grouped(cell: &[u8], sign: u8) -> bool {
    let cell = cell.trim_ascii();
    let digits = cell.strip_prefix(b"-").or_else(|| cell.strip_prefix(b"+")).unwrap_or(cell);
    let mut groups = digits.split(|b| *b == sign);
    let is_digits = |group: &[u8]| group.iter().all(u8::is_ascii_digit);
    let first = groups.next().unwrap_or_default();
    (1..=3).contains(&first.len())
        && is_digits(first)
        && first[0] != b'0'
        && groups.all(|group| group.len() == 3 && is_digits(group))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn three_digits_behind_a_point_may_be_thousands() {
        for (cell, may) in
            [("1.234", true), ("-12.500", true), ("0.500", false), ("12.5", false), ("1.2345", false), ("1234.567", false)]
        {
            assert_eq!(may_be_grouped(cell.as_bytes(), b'.'), may, "{cell}");
        }
    }

    #[test]
    fn one_cell_that_tells_settles_the_column() {
        let mut column = Separators::default();
        column.see(b"12,5", 0);
        column.see(b"1.234", 7);
        assert_eq!(column.doubtful(), Some((7, "1.234")));
        column.see(b"1.5", 14);
        assert_eq!(column.doubtful(), None);
    }
}
