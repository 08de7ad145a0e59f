//! Where text goes: results to standard output, notes and errors to standard error.
//!
//! Limits: no colour. What names and files contribute is shown as text: a control character is written as its escape, so that nothing that is read can steer
//! a terminal. A reader that has gone, as `head` does, ends the output and nothing else: the exit code is that of the answer.

use serde::Serialize;
use std::io::{self, Write};

/// How the user wants to be spoken to.
#[derive(Clone, Copy, Debug)]
pub struct Console {
    /// JSON instead of tables
    pub json: bool,
    /// no notes
    pub quiet: bool,
}

impl Console {
    /// A result as text.
    pub fn print(&self, text: impl std::fmt::Display) -> anyhow::Result<()> {
        unless_gone(writeln!(io::stdout().lock(), "{}", shown(&text.to_string())))
    }

    /// A result as one line of JSON.
    pub fn print_json(&self, value: &impl Serialize) -> anyhow::Result<()> {
        self.print_json_lines(&[value])
    }

    /// Results as JSON, one object a line.
    pub fn print_json_lines<T: Serialize>(&self, values: &[T]) -> anyhow::Result<()> {
        let mut out = io::BufWriter::new(io::stdout().lock());
        let mut line = |value: &T| {
            serde_json::to_writer(&mut out, value).map_err(io::Error::from)?;
            writeln!(out)
        };
        let written = values.iter().try_for_each(&mut line);
        unless_gone(written.and_then(|()| out.flush()))
    }

    /// Something that the user should know beside the result.
    pub fn note(&self, text: impl std::fmt::Display) {
        if !self.quiet {
            let _ = writeln!(io::stderr().lock(), "note: {}", shown(&text.to_string())); // nowhere left to say that this failed
        }
    }

    /// Why there is no result, as one paragraph.
    pub fn fail(&self, error: &anyhow::Error) {
        fail(&error.to_string());
    }
}

/// Why there is no result, as one paragraph.
pub fn fail(reason: &str) {
    let paragraph = reason.split_whitespace().collect::<Vec<_>>().join(" ");
    let _ = writeln!(io::stderr().lock(), "error: {}", shown(&paragraph)); // nowhere left to say that this failed
}

/// `text` with every control character as its escape, line ends and tabs but for them.
pub fn shown(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '\n' | '\t' => out.push(c),
            // and the marks that turn the direction of what follows
            c if c.is_control() || matches!(c, '\u{200e}' | '\u{200f}' | '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}') => {
                out.extend(c.escape_unicode())
            }
            c => out.push(c),
        }
    }
    out
}

/// A reader that has gone has all that it wanted.
pub fn unless_gone(written: io::Result<()>) -> anyhow::Result<()> {
    match written {
        Err(error) if error.kind() == io::ErrorKind::BrokenPipe => Ok(()),
        other => Ok(other?),
    }
}

#[cfg(test)]
mod tests {
    use super::shown;

    #[test]
    fn nothing_that_is_shown_steers_a_terminal() {
        assert_eq!(shown("a\u{1b}[31mred\u{1b}[0m\r\u{7}"), "a\\u{1b}[31mred\\u{1b}[0m\\u{d}\\u{7}");
        assert_eq!(shown("\u{202e}gnp.exe\u{9b}1m"), "\\u{202e}gnp.exe\\u{9b}1m");
        assert_eq!(shown("one\ttwo\nthree äöü µ ─"), "one\ttwo\nthree äöü µ ─");
    }
}
