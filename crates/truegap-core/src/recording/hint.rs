//! What a cell is that is no number, and how to write it.
//!
//! Limits: one cell, whatever stands in the others.

use super::{number::number, separators::may_be_grouped, stamp::is_date};

/// What to do about a cell that is no number: the end of a message.
pub(super) fn hint(cell: &str, decimal_comma: bool) -> &'static str {
    let reads = |text: &str| number(text.as_bytes(), decimal_comma).is_ok();
    let without = |signs: &[char]| cell.replace(signs, "");
    let has_digit = cell.contains(|c: char| c.is_ascii_digit());
    if is_date(cell.as_bytes()) {
        "it is a date; name the column as the time, or write a number"
    } else if cell.contains(['\u{2212}', '–']) && reads(&cell.replace(['\u{2212}', '–'], "-")) {
        "the minus sign inside of it is a dash; write a hyphen, -"
    } else if decimal_comma && cell.contains(',') && cell.contains('.') {
        "it has both points and commas; write no sign between thousands, and one before decimals, as in 1234,5"
    } else if !decimal_comma && may_be_grouped(cell.as_bytes(), b',') {
        "its comma stands between thousands or before decimals; write 1234 or 1.234"
    } else if !decimal_comma && reads(&cell.replacen(',', ".", 1)) {
        "commas part the cells of this table; write decimal points, or separate the cells by semicolons"
    } else if !decimal_comma && reads(&without(&[','])) {
        "write no comma between thousands, as in 1234.5"
    } else if reads(&without(&[' ', '\u{a0}', '\u{202f}', '\u{2009}', '\'', '’', '_'])) {
        "write no sign between thousands, as in 1234.5"
    } else if has_digit
        && cell.starts_with(|c: char| c.is_ascii_digit() || matches!(c, '-' | '+' | '.'))
        && cell.ends_with(|c: char| !c.is_ascii_digit())
    {
        "a cell holds a number alone; write the unit into the header, as in `Force [N]`"
    } else {
        "correct it or leave the row out"
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_slip_of_the_pen_gets_its_own_remedy() {
        let told = |cell: &str, decimal_comma: bool, part: &str| {
            let hint = hint(cell, decimal_comma);
            assert!(hint.contains(part), "{cell}: {hint}");
        };
        told("1.234,5", true, "1234,5");
        told("0,5", false, "semicolons");
        told("1,234.5", false, "no comma between thousands");
        told("1 234,5", true, "between thousands");
        told("1'234.5", false, "between thousands");
        told("1,234", false, "thousands or before decimals");
        told("3.5e\u{2212}2", false, "hyphen");
        told("1.5 N", false, "`Force [N]`");
        told("2026-03-01T12:00:00Z", false, "date");
        told("warm", false, "leave the row out");
        told("12:30", false, "leave the row out");
    }
}
