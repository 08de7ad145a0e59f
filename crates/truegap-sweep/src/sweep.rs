//! A list of cases, each named by what it is.
//!
//! Limits: all cases of a sweep share one context; a change of either is another sweep.

use crate::canonical::{canonical, sha256};
use crate::error::SweepError;
use crate::files;
use crate::files::Described;
use serde::Serialize;
use serde_json::{Value, json};
use std::collections::HashMap;
use std::path::Path;

/// Cases, what they have in common, and their names.
#[derive(Clone, Debug)]
pub struct Sweep<C> {
    pub(crate) study: String,
    pub(crate) context: Value,
    pub(crate) cases: Vec<C>,
    pub(crate) hashes: Vec<String>,
}

impl<C: Serialize> Sweep<C> {
    /// A sweep of `cases`.
    ///
    /// | argument  | meaning |
    /// |-----------|---------|
    /// | `study`   | what computes a case, with a version that changes when the same case would have another result: `truegap.tolerance/1` |
    /// | `context` | what all cases share: a sensor, a specification; enough to list the cases again |
    /// | `cases`   | what each case is, seeds included; no two alike |
    ///
    /// # Errors
    /// [`SweepError::Empty`], [`SweepError::Twice`], [`SweepError::Unwritable`].
    pub fn new(study: &str, context: &impl Serialize, cases: Vec<C>) -> Result<Self, SweepError> {
        if cases.is_empty() {
            return Err(SweepError::Empty { study: study.to_owned() });
        }
        let shared = canonical(context)?;
        let base = sha256(&format!("{study}\n{shared}"));
        let hashes: Vec<String> =
            cases.iter().map(|case| Ok(sha256(&format!("{base}\n{}", canonical(case)?)))).collect::<Result<_, SweepError>>()?;
        let mut seen = HashMap::new();
        for (second, hash) in hashes.iter().enumerate() {
            if let Some(first) = seen.insert(hash, second) {
                return Err(SweepError::Twice { first, second, hash: hash.clone() });
            }
        }
        let context = serde_json::from_str(&shared).map_err(|source| SweepError::Unwritable { reason: source.to_string() })?;
        Ok(Self { study: study.to_owned(), context, cases, hashes })
    }

    /// The cases.
    pub fn cases(&self) -> &[C] {
        &self.cases
    }

    /// Name of every case: SHA-256 of study, context and case.
    pub fn hashes(&self) -> &[String] {
        &self.hashes
    }

    /// Name of the whole.
    pub fn name(&self) -> String {
        sha256(&self.hashes.join("\n"))
    }

    /// Writes `sweep.json`, by which [`describe`](crate::describe) and every other shard know the folder.
    ///
    /// # Errors
    /// [`SweepError::OtherSweep`] where the folder has one that differs, [`SweepError::Disk`].
    pub fn claim(&self, folder: &Path) -> Result<(), SweepError> {
        match files::describe(folder) {
            Ok(there) if there.name == self.name() => Ok(()),
            Ok(there) => Err(self.other(folder, &there)),
            Err(_) if !folder.join(files::SWEEP).exists() => {
                let text = json!({"schema": files::SCHEMA, "study": self.study, "name": self.name(), "cases": self.cases.len(), "context": self.context});
                files::write_atomically(&folder.join(files::SWEEP), format!("{text:#}\n").as_bytes())
            }
            Err(error) => Err(error),
        }
    }

    fn other(&self, folder: &Path, there: &Described) -> SweepError {
        let told = |study: &str, name: &str| format!("{study} {}", name.chars().take(12).collect::<String>());
        SweepError::OtherSweep {
            folder: folder.to_owned(),
            has: told(&there.study, &there.name),
            wants: told(&self.study, &self.name()),
        }
    }
}
