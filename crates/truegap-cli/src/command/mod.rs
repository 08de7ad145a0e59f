//! The subcommands, one file each.
//!
//! A new one is a file with a struct of arguments that implements [`Run`] (or [`RunDefined`]), a `mod` line and a line in `commands!`, at its place by use.

#[cfg(feature = "fem")]
mod audit;
mod coefficients;
mod compensate;
mod completions;
mod confirm;
mod diagnose;
mod explain;
#[cfg(feature = "fem")]
mod export;
mod file_or_screen;
mod firmware;
mod init;
mod man;
mod merge;
#[cfg(feature = "fem")]
mod mesh;
mod optimise;
pub mod progress;
mod prove;
pub mod run;
mod schema;
mod sensitivity;
mod sensors;
mod simulate;
#[cfg(feature = "fem")]
mod solve;
pub mod stop;
mod study;
mod told;
mod tolerance;
mod typed;
#[cfg(feature = "fem")]
mod wait;

#[cfg(not(feature = "fem"))]
mod left_out;
#[cfg(not(feature = "fem"))]
use left_out::{audit, export, mesh, solve};

use crate::console::Console;
use run::{Outcome, Run, RunDefined};

/// The enum that clap reads, and who runs it.
macro_rules! commands {
    ($($Name:ident($arguments:ty),)*; of the definition: $($Of:ident($of:ty),)*) => {
        /// Subcommands.
        #[derive(Debug, clap::Subcommand)]
        pub enum Command {
            $($Name($arguments),)*
            $($Of($of),)*
        }

        impl Command {
            /// Runs the subcommand; `definition` is the whole command line as it was defined.
            pub fn run(&self, console: &Console, definition: fn() -> clap::Command) -> anyhow::Result<Outcome> {
                match self {
                    $(Self::$Name(arguments) => arguments.run(console),)*
                    $(Self::$Of(arguments) => arguments.run(console, definition()),)*
                }
            }
        }
    };
}

commands! {
    Diagnose(diagnose::Diagnose),
    Init(init::Init),
    Confirm(confirm::Confirm),
    Compensate(compensate::Compensate),
    Explain(explain::Explain),
    Firmware(firmware::Firmware),
    Simulate(simulate::Simulate),
    Coefficients(coefficients::Coefficients),
    Sensors(sensors::Sensors),
    Audit(audit::Audit),
    Sensitivity(sensitivity::Sensitivity),
    Optimise(optimise::Optimise),
    Tolerance(tolerance::Tolerance),
    Merge(merge::Merge),
    Export(export::Export),
    Mesh(mesh::Mesh),
    Solve(solve::Solve),
    Prove(prove::Prove),
    Schema(schema::SchemaOf),
    ; of the definition:
    Completions(completions::Completions),
    Man(man::Man),
}

#[cfg(test)]
mod tests {
    #[test]
    fn help_names_what_is_used_most_first() {
        use clap::Subcommand;
        let command = super::Command::augment_subcommands(clap::Command::new("truegap"));
        let names: Vec<&str> = command.get_subcommands().map(clap::Command::get_name).collect();
        assert_eq!(names[..5], ["diagnose", "init", "confirm", "compensate", "explain"]);
    }
}
