//! What a subcommand is: arguments that were read, and how running them ended.
//!
//! Limits: knows no subcommand.

use crate::console::Console;

/// How a command ended that could run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Outcome {
    /// nothing to look at: exit code 0
    Fine,
    /// the tool found something to look at: exit code 1
    LookAt,
}

/// A subcommand: its arguments have been read, now do it.
pub trait Run {
    /// Prints the answer; an error is one paragraph that names file, value and remedy.
    fn run(&self, console: &Console) -> anyhow::Result<Outcome>;
}

/// A subcommand that tells of the command line itself.
pub trait RunDefined {
    /// Prints the answer; `definition` is the whole command line as it was defined.
    fn run(&self, console: &Console, definition: clap::Command) -> anyhow::Result<Outcome>;
}
