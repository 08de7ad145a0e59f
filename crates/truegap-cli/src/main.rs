//! The command `truegap`: text in, text out, exit code 0 (fine), 1 (something to look at) or 2 (could not run).
//!
//! Limits: no physics and no files of its own; every subcommand is one file of [`command`].

mod command;
mod console;
mod table;

use clap::Parser;
use command::{Command, run::Outcome};
use console::Console;
use std::process::ExitCode;

/// Predict, verify and explain a capacitive tactile sensor.
#[derive(Debug, Parser)]
#[command(name = "truegap", version, propagate_version = true, arg_required_else_help = true)]
#[command(after_help = "Exit codes: 0 fine, 1 the tool found something to look at, 2 it could not run.")]
struct Arguments {
    /// Print JSON instead of tables
    #[arg(long, global = true)]
    json: bool,
    /// Print results and errors only: no notes, no progress
    #[arg(long, short, global = true)]
    quiet: bool,
    #[command(subcommand)]
    command: Command,
}

fn main() -> ExitCode {
    let Arguments { json, quiet, command } = Arguments::parse();
    let console = Console { json, quiet };
    match command.run(&console) {
        Ok(Outcome::Fine) => ExitCode::SUCCESS,
        Ok(Outcome::LookAt) => ExitCode::from(1),
        Err(error) if console::is_closed_pipe(&error) => ExitCode::SUCCESS,
        Err(error) => {
            console.fail(&error);
            ExitCode::from(2)
        }
    }
}
