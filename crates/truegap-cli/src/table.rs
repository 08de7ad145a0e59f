//! Tables that a person likes to read.
//!
//! Limits: every column but the first is aligned to the right.

use comfy_table::{CellAlignment, LineStyle, Table, TableStyle};

/// One line below the header, none between the rows.
const STYLE: TableStyle = TableStyle::new().header_separator(LineStyle::none().fill('─').junction('─'));

/// A table with a header; a `name\nunit` in the header puts the unit below the name.
pub fn table<H: AsRef<str>>(header: &[H], rows: impl IntoIterator<Item = Vec<String>>) -> Table {
    let mut table = Table::new();
    table.load_style(STYLE).set_header(header.iter().map(AsRef::as_ref));
    table.add_rows(rows);
    table.column_iter_mut().skip(1).for_each(|column| {
        column.set_cell_alignment(CellAlignment::Right);
    });
    table
}

/// A number with a given count of significant digits, in plain notation where that is readable.
pub fn digits(value: f64, significant: usize) -> String {
    if value == 0.0 || !value.is_finite() {
        return value.to_string();
    }
    let exponent = value.abs().log10().floor() as i32;
    if !(-4..9).contains(&exponent) {
        return format!("{value:.*e}", significant - 1);
    }
    let decimals = (significant as i32 - 1 - exponent).max(0) as usize;
    format!("{value:.decimals$}")
}

#[cfg(test)]
mod tests {
    use super::digits;

    #[test]
    fn numbers_keep_their_significant_digits() {
        assert_eq!(digits(234.56789, 6), "234.568");
        assert_eq!(digits(-0.0123456, 3), "-0.0123");
        assert_eq!(digits(1.5e-7, 3), "1.50e-7");
        assert_eq!(digits(123_456.0, 3), "123456");
        assert_eq!(digits(0.0, 3), "0");
    }
}
