//! Where text goes: results to standard output, notes and errors to standard error.
//!
//! Limits: no colour.

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
        Ok(writeln!(io::stdout().lock(), "{text}")?)
    }

    /// A result as one line of JSON.
    pub fn print_json(&self, value: &impl Serialize) -> anyhow::Result<()> {
        let mut out = io::stdout().lock();
        serde_json::to_writer(&mut out, value).map_err(io::Error::from)?;
        Ok(writeln!(out)?)
    }

    /// Results as JSON, one object a line.
    pub fn print_json_lines<T: Serialize>(&self, values: &[T]) -> anyhow::Result<()> {
        let mut out = io::BufWriter::new(io::stdout().lock());
        for value in values {
            serde_json::to_writer(&mut out, value).map_err(io::Error::from)?;
            writeln!(out)?;
        }
        Ok(out.flush()?)
    }

    /// Something that the user should know beside the result.
    pub fn note(&self, text: impl std::fmt::Display) {
        if !self.quiet {
            let _ = writeln!(io::stderr().lock(), "note: {text}"); // nowhere left to say that this failed
        }
    }

    /// Why there is no result, as one paragraph.
    pub fn fail(&self, error: &anyhow::Error) {
        let text = error.to_string();
        let paragraph = text.split_whitespace().collect::<Vec<_>>().join(" ");
        let _ = writeln!(io::stderr().lock(), "error: {paragraph}"); // nowhere left to say that this failed
    }
}

/// Whether the reader of our output has gone, as `head` does.
pub fn is_closed_pipe(error: &anyhow::Error) -> bool {
    error.downcast_ref::<io::Error>().is_some_and(|e| e.kind() == io::ErrorKind::BrokenPipe)
}
