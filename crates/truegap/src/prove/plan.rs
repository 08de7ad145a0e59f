//! What a study consists of, kept in its key so that it can be gone on with.
//!
//! Limits: the plan holds the seed, and with it every answer; it is as secret as the key.

use super::error::{ProveError, json};
use super::seal::commitments;
use crate::output::OutputFolder;
use serde::{Deserialize, Serialize};
use std::collections::BTreeSet;
use std::hash::{BuildHasher, Hasher, RandomState};
use std::path::Path;
use truegap_generator::causes::{FURTHER, LIBRARY};
use truegap_generator::protocol::Kind;
use truegap_generator::settings::Only;
use truegap_generator::study::{PLAN, place};
use truegap_generator::{Options, Study};

/// Restriction of a study, to count one thing well; the diagnosis is not told of it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
#[allow(missing_docs)] // their names say it
pub enum Sort {
    #[default]
    Everything,
    Nulls,
    Singles,
    Pairs,
    Strangers,
    Loggers,
    WithoutEach,
    Wild,
}

/// Detectability of effects that are left out: far above the noise, so that what is said of them is a matter of words.
const LEFT_OUT: (f64, f64) = (25.0, 36.0);
/// Detectability of wild causes.
const WILD: (f64, f64) = (16.0, 120.0);

/// A study before it is made.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Plan {
    /// seed of everything that is drawn
    pub seed: u64,
    /// how many recordings
    pub cases: usize,
    /// what is concealed
    pub only: Sort,
    /// protocols to draw from; all where empty
    pub protocols: Vec<Kind>,
}

impl Plan {
    /// The study; the same from the same plan.
    ///
    /// # Errors
    /// [`ProveError::NoCases`].
    pub fn study(&self) -> Result<Study, ProveError> {
        if self.cases == 0 {
            return Err(ProveError::NoCases);
        }
        let only = match self.only {
            Sort::Everything => Only::Everything,
            Sort::Nulls => Only::Nulls,
            Sort::Singles => Only::Singles,
            Sort::Pairs => Only::Pairs,
            Sort::Strangers => Only::Strangers,
            Sort::Loggers => Only::Loggers,
            Sort::WithoutEach => Only::WithoutEach,
            Sort::Wild => Only::Wild,
        };
        let mut options = Options { only, protocols: self.protocols.clone(), ..Options::default() };
        let range = match self.only {
            Sort::WithoutEach => LEFT_OUT,
            Sort::Wild => WILD,
            _ => (options.detectability_from, options.detectability_to),
        };
        (options.detectability_from, options.detectability_to) = range;
        Ok(Study::new(self.seed, self.cases, options)?)
    }

    /// Every effect that can be left out, `each` times.
    pub fn without_each(seed: u64, each: usize) -> Self {
        Self { seed, cases: each * (LIBRARY.len() + FURTHER.len()), only: Sort::WithoutEach, protocols: Vec::new() }
    }

    /// Names of the cases, in order.
    pub(super) fn names(&self) -> BTreeSet<String> {
        (1..=self.cases).map(|number| format!("case-{number:03}")).collect()
    }

    pub(super) fn read(folder: &Path) -> Result<Self, ProveError> {
        let (path, folder) = (place(folder, PLAN), folder.to_owned());
        match entry(&folder)? {
            _ if path.exists() => json(&path),
            Some(entry) => Err(ProveError::NoPlan { folder, entry }),
            None => Err(ProveError::NoStudy { folder }),
        }
    }
}

/// A seed that nobody knows: the random keys that the system gives to the standard library's hash maps.
pub fn entropy() -> u64 {
    RandomState::new().build_hasher().finish()
}

/// Writes a new study, which is in `folder` whole or not at all; `made` is called after each case with its number from 0.
///
/// # Errors
/// [`ProveError`] where the folder holds anything, the disk refuses, or a case cannot be made.
pub fn begin(plan: &Plan, folder: &Path, made: impl FnMut(usize)) -> Result<(), ProveError> {
    let study = plan.study()?;
    if place(folder, PLAN).exists() {
        return Err(ProveError::Begun { folder: folder.to_owned() });
    }
    if let Some(entry) = entry(folder)? {
        return Err(ProveError::Taken { folder: folder.to_owned(), entry });
    }
    let out = OutputFolder::begin(folder)?;
    let text = serde_json::to_string_pretty(plan).map_err(|source| ProveError::Json { path: place(folder, PLAN), source })?;
    study.write(out.path(), &(text + "\n"), made)?;
    out.publish()?;
    Ok(())
}

/// Finds the study in `folder` again, every file of it as it was written; `asked` is compared where it is given.
///
/// # Errors
/// [`ProveError`] where there is none, a file of it has changed, or it is another one than asked for.
pub fn resume(folder: &Path, seed: Option<u64>, cases: Option<usize>) -> Result<Plan, ProveError> {
    let plan = Plan::read(folder)?;
    let other = |what, there: String, asked: String| ProveError::OtherPlan { folder: folder.to_owned(), what, there, asked };
    if let Some(asked) = seed.filter(|asked| *asked != plan.seed) {
        return Err(other("seed", plan.seed.to_string(), asked.to_string()));
    }
    if let Some(asked) = cases.filter(|asked| *asked != plan.cases) {
        return Err(other("cases", plan.cases.to_string(), asked.to_string()));
    }
    commitments(folder, &plan.names())?;
    Ok(plan)
}

/// Something that lies in a folder; nothing where there is no folder.
fn entry(folder: &Path) -> Result<Option<String>, ProveError> {
    let failed = |source| ProveError::File { path: folder.to_owned(), source };
    if !folder.exists() {
        return Ok(None);
    }
    let first = std::fs::read_dir(folder).map_err(failed)?.next().transpose().map_err(failed)?;
    Ok(first.map(|entry| entry.file_name().to_string_lossy().into_owned()))
}
