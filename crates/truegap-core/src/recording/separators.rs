//! Whether a comma or a point may stand between thousands.
//!
//! Limits: one cell; `12.500` alone may be both, `0.500` and `12.5` are decimals.

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

/// Whether a cell is a number with both signs, one of them between thousands.
pub(super) fn has_thousands(cell: &[u8]) -> bool {
    let last = cell.iter().rposition(|b| matches!(b, b',' | b'.')).unwrap_or_default();
    let (whole, decimals) = cell.split_at(last);
    let other = if decimals.first() == Some(&b',') { b'.' } else { b',' };
    whole.contains(&other) && may_be_grouped(whole, other) && decimals.iter().skip(1).all(u8::is_ascii_digit)
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
    fn both_signs_are_those_of_decimals_and_of_thousands() {
        for (cell, has) in
            [("1,234.5", true), ("-1.234.567,5", true), ("1.23,5", false), ("1,234", false), ("1.5", false), ("", false)]
        {
            assert_eq!(has_thousands(cell.as_bytes()), has, "{cell}");
        }
    }
}
