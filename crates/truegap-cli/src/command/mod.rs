//! The subcommands, one file each.
//!
//! A new one is a file with a struct of arguments that implements [`Run`], a `mod` line and a line in [`commands`].

mod audit;
mod coefficients;
mod confirm;
mod diagnose;
mod export;
mod init;
mod merge;
mod mesh;
mod optimise;
mod prove;
mod sensitivity;
mod sensors;
mod simulate;
mod solve;
mod study;
mod tolerance;

use crate::console::Console;
use std::path::Path;
use truegap::{EXAMPLE, Recording, RecordingError, example_recording};

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

/// The built-in recording where its name is given and nothing on disk has that name.
fn recorded(path: &Path) -> Result<Recording, RecordingError> {
    if path == Path::new(EXAMPLE) && !path.exists() { example_recording() } else { Recording::open(path) }
}

/// The enum that clap reads, and who runs it.
macro_rules! commands {
    ($($(#[$about:meta])* $Name:ident($arguments:ty),)*) => {
        /// Subcommands.
        #[derive(Debug, clap::Subcommand)]
        pub enum Command {
            $($(#[$about])* $Name($arguments),)*
        }

        impl Command {
            /// Runs the subcommand.
            pub fn run(&self, console: &Console) -> anyhow::Result<Outcome> {
                match self {
                    $(Self::$Name(arguments) => arguments.run(console),)*
                }
            }
        }
    };
}

commands! {
    Sensors(sensors::Sensors),
    Coefficients(coefficients::Coefficients),
    Simulate(simulate::Simulate),
    Sensitivity(sensitivity::Sensitivity),
    Optimise(optimise::Optimise),
    Tolerance(tolerance::Tolerance),
    Audit(audit::Audit),
    Export(export::Export),
    Init(init::Init),
    Merge(merge::Merge),
    Diagnose(diagnose::Diagnose),
    Confirm(confirm::Confirm),
    Mesh(mesh::Mesh),
    Solve(solve::Solve),
    Prove(prove::Prove),
}
