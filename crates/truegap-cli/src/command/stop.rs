//! Ctrl-C: the first one ends the work with what is known by then and says so at once, a second one ends the program.
//!
//! Limits: one command a program; what "known by then" is belongs to the command.

use super::progress;
use crate::console::Console;
use anyhow::Context;
use std::io::Write;
use std::process::ExitCode;
use std::sync::atomic::{AtomicBool, Ordering};

/// Set by the first Ctrl-C.
pub static STOP: AtomicBool = AtomicBool::new(false);

/// Exit code of a program that was stopped by a user: 128 and the number of SIGINT, as shells have it.
const STOPPED: u8 = 130;

/// Whether the work is to end.
pub fn is_stopped() -> bool {
    STOP.load(Ordering::Relaxed)
}

/// The exit code, which is that of a stopped program where somebody stopped it.
pub fn exit_code(answer: u8) -> ExitCode {
    ExitCode::from(if is_stopped() { STOPPED } else { answer })
}

/// Watches for Ctrl-C from here on.
pub fn stop_on_interrupt(console: &Console) -> anyhow::Result<()> {
    let quiet = console.quiet;
    let handler = move || {
        if STOP.swap(true, Ordering::Relaxed) {
            std::process::exit(STOPPED.into());
        }
        if !quiet {
            progress::above(|| {
                let says = "stopping: what is known by now is written as soon as what is being computed is done, and a slow program is asked no further; Ctrl-C again ends at once";
                let _ = writeln!(std::io::stderr().lock(), "{says}"); // nowhere left to say that this failed
            });
        }
    };
    ctrlc::set_handler(handler).context("Ctrl-C cannot be watched for on this system")
}
