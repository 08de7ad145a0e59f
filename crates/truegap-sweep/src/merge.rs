//! The answers of all cases, in the order of the list.
//!
//! Limits: reads what is there; computes nothing.

use crate::error::SweepError;
use crate::files::{describe, read_case};
use crate::sweep::Sweep;
use serde::{Serialize, de::DeserializeOwned};
use std::path::{Path, PathBuf};

/// Answers in the order of the cases, and which are not there.
#[derive(Clone, Debug, PartialEq)]
pub struct Merged<R> {
    folder: PathBuf,
    cases: usize,
    /// place in the list, and answer
    pub answers: Vec<(usize, R)>,
    /// places without an answer, with the names of their cases
    pub missing: Vec<(usize, String)>,
}

/// Missing cases that an error names.
const LISTED: usize = 8;

impl<R> Merged<R> {
    /// All answers.
    ///
    /// # Errors
    /// [`SweepError::Missing`] names the first of those that are not there.
    pub fn complete(self) -> Result<Vec<R>, SweepError> {
        if self.missing.is_empty() {
            return Ok(self.answers.into_iter().map(|(_, answer)| answer).collect());
        }
        let named = self.missing.iter().take(LISTED).map(|(place, hash)| format!("{} ({})", place + 1, &hash[..12]));
        let mut listed = named.collect::<Vec<_>>().join(", ");
        if self.missing.len() > LISTED {
            listed += ", ...";
        }
        Err(SweepError::Missing { folder: self.folder, missing: self.missing.len(), cases: self.cases, listed })
    }
}

impl<C: Serialize + Sync> Sweep<C> {
    /// Reads the answers in `folder`, whoever computed them.
    ///
    /// # Errors
    /// [`SweepError::NoSweep`], [`SweepError::OtherSweep`], [`SweepError::Damaged`], [`SweepError::Disk`].
    pub fn merge<R: DeserializeOwned>(&self, folder: &Path) -> Result<Merged<R>, SweepError> {
        describe(folder)?;
        self.claim(folder)?;
        let mut merged = Merged { folder: folder.to_owned(), cases: self.cases.len(), answers: Vec::new(), missing: Vec::new() };
        for (place, hash) in self.hashes.iter().enumerate() {
            match read_case(folder, hash)? {
                Some(answer) => merged.answers.push((place, answer)),
                None => merged.missing.push((place, hash.clone())),
            }
        }
        Ok(merged)
    }
}
