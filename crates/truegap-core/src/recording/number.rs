//! One cell of a CSV as a number.
//!
//! Limits: no thousands separators.

/// Why a cell is not a number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Fault {
    /// empty, NaN, infinite, or one of [`MARKERS`]: what a logger or a spreadsheet writes for want of a value
    NoValue,
    /// anything else
    Text,
}

/// What stands for a value that was not made, in letters of any size. A number that stands for one, as -9999, is none of these: nobody can tell.
const MARKERS: [&str; 13] =
    ["NA", "N/A", "#N/A", "#N/A N/A", "<NA>", "null", "none", "NaT", "-", "--", "---", "#DIV/0!", "#VALUE!"];

/// The minus sign of typesetters, and the dash that word processors make of a hyphen.
const MINUS: [char; 2] = ['\u{2212}', '\u{2013}'];

/// Finite number in a cell; `decimal_comma` reads one comma as the decimal point.
pub(super) fn number(cell: &[u8], decimal_comma: bool) -> Result<f64, Fault> {
    let text = std::str::from_utf8(cell).map_err(|_| Fault::Text)?.trim();
    match text.strip_prefix(MINUS) {
        // `nan` behind a dash is no number, and no mark for want of one
        Some(rest) if rest.starts_with(|c: char| c.is_ascii_digit() || matches!(c, '.' | ',')) => {
            parsed(rest, decimal_comma).map(|value| -value)
        }
        _ => parsed(text, decimal_comma),
    }
}

/// The same without blanks about it, and without signs that ASCII does not have.
fn parsed(text: &str, decimal_comma: bool) -> Result<f64, Fault> {
    let parsed = if decimal_comma && text.contains(',') {
        if text.contains('.') {
            return Err(Fault::Text);
        }
        text.replacen(',', ".", 1).parse::<f64>()
    } else {
        text.parse::<f64>()
    };
    let Ok(value) = parsed else {
        let stands_for_none = text.is_empty() || MARKERS.iter().any(|marker| text.eq_ignore_ascii_case(marker));
        return Err(if stands_for_none { Fault::NoValue } else { Fault::Text });
    };
    match value.is_finite() {
        true => Ok(value),
        // `1e999` is a slip of the pen or of the wire, and nothing that a logger writes for want of a value
        false if text.contains(|c: char| c.is_ascii_digit()) => Err(Fault::Text),
        false => Err(Fault::NoValue),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_comma_is_a_point_only_where_it_may_be() {
        assert_eq!(number(b"-0,001953125", true), Ok(-0.001_953_125));
        assert_eq!(number(b" 1.5e-3 ", true), Ok(1.5e-3));
        assert_eq!(number(b"1,5", false), Err(Fault::Text));
        assert_eq!(number(b"1.234,5", true), Err(Fault::Text));
        assert_eq!(number(b"1,234,5", true), Err(Fault::Text));
    }

    /// Refused, with the remedy to write a hyphen: some programs write nothing else.
    #[test]
    fn a_minus_sign_may_be_one_of_typesetters() {
        let numbers = ["\u{2212}0.5", "\u{2013}0,5", " \u{2212}.5e0"].map(|cell| number(cell.as_bytes(), true));
        assert_eq!(numbers, [Ok(-0.5); 3]);
        for cell in ["\u{2212}", "\u{2212}-1", "\u{2013}nan", "1\u{2212}2", "\u{2212}\u{2212}1"] {
            assert_eq!(number(cell.as_bytes(), false), Err(Fault::Text), "{cell}");
        }
    }

    #[test]
    fn what_is_not_finite_is_no_value() {
        for cell in ["", "  ", "nan", "NaN", "inf", "-Infinity"] {
            assert_eq!(number(cell.as_bytes(), false), Err(Fault::NoValue), "{cell}");
        }
        for marker in MARKERS {
            assert_eq!(number(format!(" {} ", marker.to_lowercase()).as_bytes(), true), Err(Fault::NoValue), "{marker}");
        }
        assert_eq!(number(b"nil", false), Err(Fault::Text));
        assert_eq!(number(b"----", false), Err(Fault::Text));
        assert_eq!(number(b"1e999", false), Err(Fault::Text));
        assert_eq!(number(b"\xb5", false), Err(Fault::Text));
    }
}
