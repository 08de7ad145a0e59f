//! The command `truegap`: text in, text out, exit code 0 (fine), 1 (something to look at), 2 (could not run) or 130 (stopped).
//!
//! Limits: no physics and no files of its own; every subcommand is one file of [`command`].

mod command;
mod console;
mod table;

use clap::{CommandFactory, Parser};
use command::{Command, run::Outcome, stop::exit_code};
use console::Console;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::process::ExitCode;

/// Predict, verify and explain what a sensor reads, capacitive tactile ones first.
#[derive(Debug, Parser)]
#[command(name = "truegap", version, propagate_version = true, arg_required_else_help = true)]
#[command(
    after_help = "Exit codes: 0 fine, 1 the tool found something to look at, 2 it could not run, 130 it was stopped by Ctrl-C."
)]
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
    let arguments = match Arguments::try_parse() {
        Ok(arguments) => arguments,
        Err(told) => return answered(&told),
    };
    start_threads();
    // a defect of the program ends like any other reason, and what was begun is taken back on the way
    catch_unwind(AssertUnwindSafe(|| run(&arguments))).unwrap_or_else(|_| {
        console::fail(
            "this is a defect of truegap, and its place is named above; please report it with the command and its files",
        );
        ExitCode::from(2)
    })
}

fn run(Arguments { json, quiet, command }: &Arguments) -> ExitCode {
    let console = Console { json: *json, quiet: *quiet };
    match command.run(&console, Arguments::command) {
        Ok(Outcome::Fine) => exit_code(0),
        Ok(Outcome::LookAt) => exit_code(1),
        Err(error) => {
            console.fail(&error);
            exit_code(2)
        }
    }
}

/// Help, version, or what is wrong with the arguments, which are shown as text whatever they hold.
fn answered(told: &clap::Error) -> ExitCode {
    let text = console::shown(&told.render().to_string());
    if told.use_stderr() {
        eprint!("{text}");
    } else {
        print!("{text}");
    }
    ExitCode::from(u8::try_from(told.exit_code()).unwrap_or(2))
}

/// One thread a core, or this one alone where the system gives no more.
fn start_threads() {
    if rayon::ThreadPoolBuilder::new().build_global().is_err() {
        // where even this fails the first parallel loop says so
        let _ = rayon::ThreadPoolBuilder::new().num_threads(1).use_current_thread().build_global();
    }
}
