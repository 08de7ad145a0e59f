//! Tables with numbers on the right and words on the left.

use super::escape::escape;

/// A table; a column whose cells all look like numbers is set right-aligned.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Table {
    header: Vec<String>,
    rows: Vec<Vec<String>>,
    caption: String,
    dense: bool,
}

impl Table {
    /// A table with these column headings.
    pub fn new(header: &[&str]) -> Self {
        Self { header: header.iter().map(|&h| h.into()).collect(), ..Self::default() }
    }

    /// Adds a row; missing cells stay empty, surplus cells get a heading without text.
    pub fn row<S: AsRef<str>>(mut self, cells: &[S]) -> Self {
        self.rows.push(cells.iter().map(|c| c.as_ref().to_owned()).collect());
        self
    }

    /// A sentence above the table.
    pub fn caption(mut self, text: &str) -> Self {
        self.caption = text.into();
        self
    }

    /// Smaller letters and less space, for many columns.
    pub fn dense(mut self) -> Self {
        self.dense = true;
        self
    }

    /// The `<table>` element in a wrapper that scrolls on narrow screens.
    pub(super) fn to_html(&self) -> String {
        let columns = self.rows.iter().map(Vec::len).chain([self.header.len()]).max().unwrap_or(0);
        let numeric: Vec<bool> = (0..columns).map(|c| self.is_numeric(c)).collect();
        let line = |cells: &[String], tag: &str| {
            let cells: String = (0..columns)
                .map(|c| {
                    let class = if numeric[c] { " class=\"number\"" } else { "" };
                    format!("<{tag}{class}>{}</{tag}>", escape(cells.get(c).map_or("", String::as_str)))
                })
                .collect();
            format!("<tr>{cells}</tr>\n")
        };
        let caption =
            if self.caption.is_empty() { String::new() } else { format!("<caption>{}</caption>\n", escape(&self.caption)) };
        let rows: String = self.rows.iter().map(|row| line(row, "td")).collect();
        let head = line(&self.header, "th");
        let class = if self.dense { " class=\"dense\"" } else { "" };
        format!("<div class=\"wide\"><table{class}>\n{caption}<thead>\n{head}</thead>\n<tbody>\n{rows}</tbody>\n</table></div>\n")
    }

    fn is_numeric(&self, column: usize) -> bool {
        let mut cells = self.rows.iter().filter_map(|row| row.get(column)).filter(|c| !c.is_empty()).peekable();
        cells.peek().is_some() && cells.all(|cell| looks_numeric(cell))
    }
}

/// A number with sign, error or unit-like sign behind it; a dash stands for no value.
fn looks_numeric(cell: &str) -> bool {
    let bare = cell.trim().trim_start_matches(['<', '>', '≤', '≥', '≈', '~', '+', '-', '\u{2212}', ' ']);
    matches!(cell.trim(), "-" | "–" | "—" | "nan" | "NaN" | "n/a")
        || bare.starts_with(|c: char| c.is_ascii_digit())
            && bare.chars().filter(|c| c.is_alphabetic() && *c != 'e' && *c != 'E').count() <= 3
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn number_columns_are_right_aligned_and_words_are_not() {
        let html = Table::new(&["what", "value"]).row(&["C0", "64.1 ± 0.2 pF"]).row(&["x < y", "-3e-5"]).to_html();
        assert!(html.contains("<td>x &lt; y</td>") && html.contains("<td class=\"number\">-3e-5</td>"));
        assert!(html.contains("<table>"));
        assert!(Table::new(&["a"]).row(&["1"]).dense().to_html().contains("<table class=\"dense\">"));
        assert!(!Table::new(&["a"]).row(&["12 beads and more"]).to_html().contains("class=\"number\""));
    }
}
