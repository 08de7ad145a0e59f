//! Self-contained HTML pages: text, tables, figures, foldable details; light, dark and on paper.
//!
//! No script, no link, no font: the file can be mailed. Everything that is not markup made here is escaped.

mod build;
mod table;

pub use build::{Page, Tone};
pub use table::Table;

/// `text` with the characters that mean something to HTML and XML replaced; control characters that XML forbids become `�`.
pub fn escape(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '"' => out.push_str("&quot;"),
            '\'' => out.push_str("&#39;"),
            '\t' | '\n' | '\r' => out.push(c),
            c if c.is_control() => out.push('\u{FFFD}'),
            c => out.push(c),
        }
    }
    out
}
