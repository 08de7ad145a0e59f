//! Time and memory of this process, for examples that are compared with other programs.

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

/// Processor seconds of all threads so far, as the clock of the process has them at this moment: what the system books for its threads
/// elsewhere (`schedstat`) is up to 4 ms old. NaN where there is no such clock.
fn processor_seconds() -> f64 {
    #[cfg(unix)]
    {
        let now = rustix::time::clock_gettime(rustix::time::ClockId::ProcessCPUTime);
        now.tv_sec as f64 + 1e-9 * now.tv_nsec as f64
    }
    #[cfg(not(unix))]
    f64::NAN
}
