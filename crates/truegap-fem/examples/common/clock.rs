//! Time and memory of this process, for examples that are compared with other programs.

use std::fs;
use std::time::Instant;

/// Wall-clock time, and what all threads of this process have used of the processors.
pub struct Clock {
    begin: Instant,
    used: f64,
}

impl Clock {
    /// Begins now.
    pub fn start() -> Clock {
        Clock { begin: Instant::now(), used: processor_seconds() }
    }

    /// Processor seconds since the start; wall-clock seconds where the system does not tell.
    pub fn seconds(&self) -> f64 {
        let used = processor_seconds() - self.used;
        if used.is_finite() { used } else { self.wall() }
    }

    /// Wall-clock seconds since the start.
    pub fn wall(&self) -> f64 {
        self.begin.elapsed().as_secs_f64()
    }
}

/// Processor seconds of all threads so far; needs Linux (NaN elsewhere).
fn processor_seconds() -> f64 {
    let Ok(threads) = fs::read_dir("/proc/self/task") else { return f64::NAN };
    let nanoseconds = |text: String| text.split_whitespace().next().and_then(|n| n.parse::<f64>().ok()).unwrap_or(f64::NAN);
    let used = threads.filter_map(|t| fs::read_to_string(t.ok()?.path().join("schedstat")).ok()).map(nanoseconds);
    1e-9 * used.sum::<f64>()
}
