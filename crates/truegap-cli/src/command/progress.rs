//! How far a diagnosis is: one line that is drawn again and again on a terminal, and a line now and then elsewhere.
//!
//! Limits: shows what it is told; where standard error is no terminal nothing is said in the first half minute, so that what is short leaves no trace in a log.

use crate::console::{Console, shown};
use indicatif::{ProgressBar, ProgressStyle};
use std::io::{IsTerminal, Write, stderr};
use std::sync::{Mutex, PoisonError};
use std::time::{Duration, Instant};
use truegap::diagnose::Progress;

/// Time between two lines where there is no terminal.
const NOW_AND_THEN: Duration = Duration::from_secs(30);
/// Time between two drawings of the line, whether there is news or not.
const TICK: Duration = Duration::from_millis(100);

/// The line that is drawn now, for whoever writes above it.
static DRAWN: Mutex<Option<ProgressBar>> = Mutex::new(None);

/// The line of one command; gone when it is dropped.
pub struct Line {
    bar: ProgressBar,
    /// when the next line is due where nothing can be drawn; never where the user wants none
    due: Option<Mutex<Instant>>,
    began: Instant,
}

impl Line {
    /// Begins with what is done first.
    pub fn begin(console: &Console, what: &str) -> Self {
        let began = Instant::now();
        if console.quiet {
            return Self { bar: ProgressBar::hidden(), due: None, began };
        }
        let bar = ProgressBar::new(1000);
        if let Ok(style) = ProgressStyle::with_template("{spinner} {bar:14} {percent:>3} %  {wide_msg}  {elapsed}") {
            bar.set_style(style);
        }
        bar.set_message(shown(what));
        bar.enable_steady_tick(TICK);
        *DRAWN.lock().unwrap_or_else(PoisonError::into_inner) = Some(bar.clone());
        let due = (!stderr().is_terminal()).then(|| Mutex::new(began + NOW_AND_THEN));
        Self { bar, due, began }
    }

    /// Shows how far it is.
    pub fn tell(&self, progress: &Progress) {
        let says = shown(&format!("{}: {}", progress.step, progress.what));
        if let Some(due) = &self.due {
            self.line_when_due(due, progress.done, &says);
        }
        self.bar.set_position((1000.0 * progress.done) as u64);
        self.bar.set_message(says);
    }

    fn line_when_due(&self, due: &Mutex<Instant>, done: f64, says: &str) {
        let (now, mut due) = (Instant::now(), due.lock().unwrap_or_else(PoisonError::into_inner));
        if now >= *due {
            *due = now + NOW_AND_THEN;
            let seconds = self.began.elapsed().as_secs();
            let _ = writeln!(stderr().lock(), "{:.0} % after {seconds} s: {says}", 100.0 * done); // nowhere left to say that this failed
        }
    }
}

impl Drop for Line {
    fn drop(&mut self) {
        self.bar.finish_and_clear();
        *DRAWN.lock().unwrap_or_else(PoisonError::into_inner) = None;
    }
}

/// Writes above the line, which is drawn anew below.
pub fn above<T>(write: impl FnOnce() -> T) -> T {
    let drawn = DRAWN.lock().unwrap_or_else(PoisonError::into_inner).clone();
    match drawn {
        Some(bar) => bar.suspend(write),
        None => write(),
    }
}
