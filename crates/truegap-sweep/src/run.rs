//! Computing the cases of a shard, all cores at once.
//!
//! Limits: cases are begun in any order; the order of the list matters only to [`Sweep::merge`].

use crate::control::{Control, Progress};
use crate::error::SweepError;
use crate::files::{Record, case_file, read_case, write_atomically};
use crate::shard::Shard;
use crate::sweep::Sweep;
use rayon::prelude::*;
use serde::{Serialize, de::DeserializeOwned};
use std::path::Path;
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};

/// What a run did.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Ran {
    /// cases of the share
    pub of: usize,
    /// answers found from earlier runs
    pub found: usize,
    /// answers computed now
    pub computed: usize,
    /// cases without an answer, with the reason, in the order of the list; they are tried again by the next run
    pub failed: Vec<(usize, String)>,
    /// whether it was stopped before its end
    pub cancelled: bool,
}

/// How one case went.
enum Went<R> {
    Found(R),
    Computed(R),
    Failed(String),
    NotBegun,
}

impl<C: Serialize + Sync> Sweep<C> {
    /// Computes the cases of `shard` that have no answer yet, into `folder`.
    ///
    /// # Errors
    /// [`SweepError::OtherSweep`] where the folder is another sweep's, [`SweepError::Disk`], [`SweepError::Unwritable`] for a result with numbers that are not finite.
    pub fn run<R, E>(
        &self,
        folder: &Path,
        shard: Shard,
        control: Control<'_>,
        solve: impl Fn(&C) -> Result<R, E> + Sync,
    ) -> Result<Ran, SweepError>
    where
        R: Serialize + DeserializeOwned + Send,
        E: std::fmt::Display,
    {
        self.claim(folder)?;
        let one = |place: usize| {
            let hash = &self.hashes[place];
            // a damaged file is a case without an answer
            if matches!(read_case::<R>(folder, hash), Ok(Some(_))) {
                return Ok(Went::Found(()));
            }
            if control.cancelled() {
                return Ok(Went::NotBegun);
            }
            match solve(&self.cases[place]) {
                Err(reason) => Ok(Went::Failed(reason.to_string())),
                Ok(result) => {
                    let record = Record { hash: hash.clone(), case: &self.cases[place], result };
                    let text = readable::<R>(&record)?;
                    write_atomically(&case_file(folder, hash), format!("{text}\n").as_bytes())?;
                    Ok(Went::Computed(()))
                }
            }
        };
        Ok(self.each(shard, control, one)?.0)
    }

    /// Computes all cases in memory; `None` where one was not begun or has no answer.
    ///
    /// # Errors
    /// None of its own: cases without an answer are listed.
    pub fn in_memory<R: Send, E: std::fmt::Display>(
        &self,
        control: Control<'_>,
        solve: impl Fn(&C) -> Result<R, E> + Sync,
    ) -> Result<(Ran, Vec<Option<R>>), SweepError> {
        self.each(Shard::WHOLE, control, |place| {
            if control.cancelled() {
                return Ok(Went::NotBegun);
            }
            Ok(solve(&self.cases[place]).map_or_else(|reason| Went::Failed(reason.to_string()), Went::Computed))
        })
    }

    fn each<R: Send>(
        &self,
        shard: Shard,
        control: Control<'_>,
        one: impl Fn(usize) -> Result<Went<R>, SweepError> + Sync,
    ) -> Result<(Ran, Vec<Option<R>>), SweepError> {
        let mine: Vec<usize> = (0..self.cases.len()).filter(|&place| shard.holds(place)).collect();
        let (done, found) = (AtomicUsize::new(0), AtomicUsize::new(0));
        let failed = Mutex::new(Vec::new());
        let tell = |done| control.tell(Progress { done, found: found.load(Ordering::Relaxed), of: mine.len() });
        tell(0);
        let went = mine.par_iter().map(|&place| {
            let went = one(place)?;
            if let Went::Found(_) = went {
                found.fetch_add(1, Ordering::Relaxed);
            }
            Ok(match went {
                Went::Found(answer) | Went::Computed(answer) => {
                    tell(done.fetch_add(1, Ordering::Relaxed) + 1);
                    Some(answer)
                }
                Went::NotBegun => None,
                Went::Failed(reason) => {
                    failed
                        .lock()
                        .map_or_else(|e| e.into_inner().push((place, reason.clone())), |mut f| f.push((place, reason.clone())));
                    None
                }
            })
        });
        let answers: Vec<Option<R>> = went.collect::<Result<_, SweepError>>()?;
        let mut failed = failed.into_inner().unwrap_or_else(|poisoned| poisoned.into_inner());
        failed.sort();
        let (done, found) = (done.into_inner(), found.into_inner());
        let cancelled = done + failed.len() < mine.len();
        Ok((Ran { of: mine.len(), found, computed: done - found, failed, cancelled }, answers))
    }
}

/// The record as one line, of which it is certain that it reads back.
fn readable<R: DeserializeOwned>(record: &Record<impl Serialize, impl Serialize>) -> Result<String, SweepError> {
    let refused = |source: serde_json::Error| SweepError::Unwritable { reason: source.to_string() };
    let mut value = serde_json::to_value(record).map_err(refused)?;
    value.sort_all_objects();
    let text = value.to_string();
    let back: Record<serde::de::IgnoredAny, R> = serde_json::from_str(&text).map_err(refused)?;
    drop(back);
    Ok(text)
}
