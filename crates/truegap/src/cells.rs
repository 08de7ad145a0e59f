//! Text in the cells of CSV files.
//!
//! Limits: RFC 4180; a cell that a spreadsheet would take for a formula gets a blank in front.

/// `text` as one cell: in quotes where it holds what ends a cell.
pub(crate) fn cell(text: &str) -> String {
    let is_formula = text.starts_with(['=', '+', '-', '@']);
    let text = if is_formula { format!(" {text}") } else { text.to_owned() };
    if text.contains([',', '"', '\n', '\r', ';', '\t']) { format!("\"{}\"", text.replace('"', "\"\"")) } else { text }
}

#[cfg(test)]
mod tests {
    use super::cell;

    #[test]
    fn a_cell_is_one_cell() {
        assert_eq!(cell("singletact-s15-4.5n"), "singletact-s15-4.5n");
        assert_eq!(cell("a,b"), "\"a,b\"");
        assert_eq!(cell("the \"best\""), "\"the \"\"best\"\"\"");
        assert_eq!(cell("=HYPERLINK(1)"), " =HYPERLINK(1)");
    }
}
