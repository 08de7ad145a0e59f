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
mod recorded;
pub mod run;
mod sensitivity;
mod sensors;
mod simulate;
mod solve;
mod study;
mod tolerance;
mod typed;
mod wait;

use crate::console::Console;
use run::{Outcome, Run};

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
