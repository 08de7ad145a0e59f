//! A sign of life while something is computed that cannot say how far it is.
//!
//! Limits: elapsed time only.

use crate::console::{Console, shown};
use indicatif::{ProgressBar, ProgressStyle};
use std::time::Duration;

/// Does `work` with a line that says what is done and for how long.
pub fn waiting<T>(console: &Console, what: &str, work: impl FnOnce() -> T) -> T {
    if console.quiet {
        return work();
    }
    let line = ProgressBar::new_spinner();
    if let Ok(style) = ProgressStyle::with_template("{spinner} {wide_msg}  {elapsed}") {
        line.set_style(style);
    }
    line.set_message(shown(what));
    line.enable_steady_tick(Duration::from_millis(500));
    let done = work();
    line.finish_and_clear();
    done
}
