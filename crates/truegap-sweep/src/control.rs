//! Watching and stopping a sweep from outside.
//!
//! Limits: a case that has begun is finished.

use std::sync::atomic::{AtomicBool, Ordering};

/// How far a run has come.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Progress {
    /// cases of the share that have an answer, found ones included
    pub done: usize,
    /// of these, found from earlier runs
    pub found: usize,
    /// cases of the share
    pub of: usize,
}

/// Who is told, and who may stop.
#[derive(Clone, Copy, Default)]
pub struct Control<'a> {
    /// called once at the beginning and after every case, from any thread
    pub progress: Option<&'a (dyn Fn(Progress) + Sync)>,
    /// no further case is begun once it is set
    pub cancel: Option<&'a AtomicBool>,
}

impl Control<'_> {
    pub(crate) fn cancelled(&self) -> bool {
        self.cancel.is_some_and(|flag| flag.load(Ordering::Relaxed))
    }

    pub(crate) fn tell(&self, progress: Progress) {
        if let Some(tell) = self.progress {
            tell(progress);
        }
    }
}
