//! Rows as a Markdown table.
//!
//! Limits: no alignment; a vertical bar in a cell must be escaped by its author.

/// A header and rows.
pub(crate) struct Markdown {
    /// names of the columns
    pub header: Vec<String>,
    /// one list of cells a row
    pub rows: Vec<Vec<String>>,
}

impl Markdown {
    /// A table without rows.
    pub fn new(header: &[&str]) -> Self {
        Self { header: header.iter().map(|&name| name.to_owned()).collect(), rows: Vec::new() }
    }

    /// The text, each line ended.
    pub fn text(&self) -> String {
        let line = |cells: &[String]| format!("| {} |\n", cells.join(" | "));
        let rule = format!("|{}\n", "---|".repeat(self.header.len()));
        let rows: String = self.rows.iter().map(|row| line(row)).collect();
        line(&self.header) + &rule + &rows
    }
}
