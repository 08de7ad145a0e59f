//! Where the cases of a study are computed, and what is kept.
//!
//! Limits: without a folder nothing survives the process.

use super::StudyError;
use serde::{Serialize, de::DeserializeOwned};
use std::path::Path;
use truegap_sweep::{Control, Ran, Shard, Sweep, write_atomically};

/// How a study is carried out.
#[derive(Clone, Copy)]
pub struct Work<'a> {
    /// where cases and results are kept; `None` keeps them in memory
    pub folder: Option<&'a Path>,
    /// which cases are computed here
    pub shard: Shard,
    /// who watches
    pub control: Control<'a>,
}

/// What was done, and the answer where it is this process that gives it.
#[derive(Clone, Debug)]
pub struct Finished<A> {
    /// cases
    pub ran: Ran,
    /// `None` for one shard of several: `truegap merge` gives it
    pub answer: Option<A>,
}

/// Answers in the order of the cases, `None` for those not begun.
pub(super) type Answers<R> = Vec<Option<R>>;

impl Work<'_> {
    /// Computes this shard; answers in the order of the cases where the shard is the whole, `None` in it for those not begun.
    pub(super) fn answers<C, R, E>(
        &self,
        sweep: &Sweep<C>,
        solve: impl Fn(&C) -> Result<R, E> + Sync,
    ) -> Result<(Ran, Option<Answers<R>>), StudyError>
    where
        C: Serialize + Sync,
        R: Serialize + DeserializeOwned + Send,
        E: std::fmt::Display,
    {
        let whole = self.shard == Shard::WHOLE;
        let (ran, answers) = match self.folder {
            None if whole => {
                let (ran, answers) = sweep.in_memory(self.control, solve)?;
                (ran, Some(answers))
            }
            None => return Err(StudyError::NoFolder { shard: self.shard.to_string() }),
            Some(folder) => {
                let ran = sweep.run(folder, self.shard, self.control, solve)?;
                let answers = if whole { Some(there(sweep, folder)?) } else { None };
                (ran, answers)
            }
        };
        if let Some((_, reason)) = ran.failed.first() {
            return Err(StudyError::Case { reason: reason.clone() });
        }
        if answers.as_ref().is_some_and(|a| a.iter().all(Option::is_none)) {
            return Err(StudyError::Nothing);
        }
        Ok((ran, answers))
    }
}

/// Answers that a folder holds, `None` for those that it does not.
pub(super) fn there<C: Serialize + Sync, R: DeserializeOwned>(sweep: &Sweep<C>, folder: &Path) -> Result<Answers<R>, StudyError> {
    let mut answers: Answers<R> = sweep.cases().iter().map(|_| None).collect();
    for (place, answer) in sweep.merge(folder)?.answers {
        answers[place] = Some(answer);
    }
    Ok(answers)
}

/// Answers of all cases, or which are missing; with `partial` those that are there.
pub(super) fn merged<C: Serialize + Sync, R: DeserializeOwned>(
    sweep: &Sweep<C>,
    folder: &Path,
    partial: bool,
) -> Result<Answers<R>, StudyError> {
    if partial {
        let answers = there(sweep, folder)?;
        return if answers.iter().all(Option::is_none) { Err(StudyError::Nothing) } else { Ok(answers) };
    }
    Ok(sweep.merge(folder)?.complete()?.into_iter().map(Some).collect())
}

/// Writes files of results, the page last.
pub(super) fn write(folder: &Path, files: &[(String, String)]) -> Result<(), StudyError> {
    for (name, text) in files {
        write_atomically(&folder.join(name), text.as_bytes())?;
    }
    Ok(())
}
