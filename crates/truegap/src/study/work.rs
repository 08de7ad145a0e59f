//! Where the cases of a study are computed, and what is kept.
//!
//! Limits: without a folder nothing survives the process.

use super::StudyError;
use crate::output::{OutputError, OutputFolder};
use serde::{Serialize, de::DeserializeOwned};
use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};
use truegap_limits::Need;
use truegap_sweep::{Control, Ran, Shard, Sweep};

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

/// Names of the files that studies write, figures left out.
const FILES: [&str; 10] = [
    "report.html",
    "sensitivity.json",
    "sensitivity.csv",
    "tolerance.json",
    "scatter.csv",
    "tighten.csv",
    "optimise.json",
    "fronts.csv",
    "audit-space.json",
    "audit-space.csv",
];

/// Whether a study may write into `folder`: asked before it begins.
///
/// # Errors
/// [`OutputError`] names what would be lost.
pub fn check_place(folder: &Path) -> Result<(), OutputError> {
    OutputFolder::check_beside(folder, &FILES)
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
                check_place(folder)?;
                let (was_there, was_claimed) = (folder.exists(), folder.join("sweep.json").exists());
                let ran = sweep.run(folder, self.shard, self.control, solve);
                let in_vain = ran.as_ref().map_or(true, |ran| !ran.failed.is_empty() && ran.found + ran.computed == 0);
                if in_vain && !was_claimed {
                    release(folder, was_there);
                }
                let ran = ran?;
                if let Some((_, reason)) = ran.failed.first() {
                    return Err(StudyError::Case { reason: reason.clone() });
                }
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

/// Refuses a study whose cases, or their answers, do not fit into the memory there is.
pub(super) fn check_memory(place: &str, cases: f64, things: &str, bytes: f64) -> Result<(), StudyError> {
    let need = Need { place, asked: &format!("{cases} {things}"), bytes: cases * bytes, remedy: "ask for fewer" };
    Ok(truegap_limits::check(need)?)
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

/// Writes files of results: all of them, or none. A name may come from a sensor's, so it is made one that stays in the folder.
///
/// The documents take their names last: where they stand, all else stands, whenever the process is killed.
pub(super) fn write(folder: &Path, files: &[(String, String)]) -> Result<(), StudyError> {
    let failed = |path: &Path, source| StudyError::Write { path: path.to_owned(), source };
    let is_new = !folder.exists();
    fs::create_dir_all(folder).map_err(|source| failed(folder, source))?;
    let mut parts: Vec<(PathBuf, PathBuf)> = Vec::new();
    let mut files: Vec<&(String, String)> = files.iter().collect();
    files.sort_by_key(|(name, _)| name.ends_with(".json"));
    let written = files.iter().try_for_each(|(name, text)| {
        let file = folder.join(name);
        let part = folder.join(format!("{name}.{}.part", std::process::id()));
        parts.push((part.clone(), file.clone()));
        // to the disk before anything takes its name: a full one may say so no earlier
        let put = fs::File::create(&part).and_then(|mut out| out.write_all(text.as_bytes()).and_then(|()| out.sync_all()));
        put.map_err(|source| failed(&file, source))
    });
    let mut new = Vec::new();
    let moved = written.and_then(|()| {
        parts.iter().try_for_each(|(part, file)| {
            let is_new = !file.exists();
            fs::rename(part, file).map_err(|source| failed(file, source))?;
            new.extend(is_new.then_some(file));
            Ok(())
        })
    });
    moved.inspect_err(|_| {
        // nothing more can be done where even removing fails
        parts.iter().map(|(part, _)| part).chain(new).for_each(|file| drop(fs::remove_file(file)));
        if is_new {
            drop(fs::remove_dir(folder));
        }
    })
}

/// A part of a file's name made from `name`: letters, digits, `.`, `-` and `_` as they are, anything else as `_`.
pub(super) fn file_stem(name: &str) -> String {
    let plain = |c: char| if c.is_alphanumeric() || matches!(c, '.' | '-' | '_') { c } else { '_' };
    let stem: String = name.trim_start_matches('.').chars().map(plain).take(80).collect();
    if stem.is_empty() { "sensor".into() } else { stem }
}

/// Takes back the claim of a folder in which no case has got an answer, so that a corrected request finds it free.
fn release(folder: &Path, was_there: bool) {
    // a folder that holds anything is not removed, so cases of another process keep theirs
    let empty = |path: &Path| !path.exists() || fs::remove_dir(path).is_ok();
    if !empty(&folder.join("cases")) {
        return;
    }
    drop(fs::remove_file(folder.join("sweep.json")));
    if !was_there {
        drop(fs::remove_dir(folder));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_name_of_a_sensor_stays_in_the_folder() {
        assert_eq!(file_stem("singletact-s15-4.5n"), "singletact-s15-4.5n");
        assert_eq!(file_stem("../../escaped"), "_.._escaped");
        assert_eq!(file_stem("/etc/passwd"), "_etc_passwd");
        assert_eq!(file_stem(".."), "sensor");
        assert_eq!(file_stem(&"x".repeat(500)).len(), 80);
    }

    #[test]
    fn an_answer_that_cannot_be_written_leaves_nothing() {
        let place = std::env::temp_dir().join(format!("truegap-work-{}", std::process::id()));
        let files = |last: &str| vec![("a.json".to_owned(), "1".to_owned()), (last.to_owned(), "2".to_owned())];
        assert!(matches!(write(&place, &files("no/such/folder")), Err(StudyError::Write { .. })));
        assert!(!place.exists());
        let names = || {
            let mut names: Vec<_> = fs::read_dir(&place).unwrap().map(|e| e.unwrap().file_name()).collect();
            names.sort();
            names
        };
        // the second file cannot take its name: the first, which has taken its own, goes again
        fs::create_dir_all(place.join("b.json/full")).unwrap();
        assert!(write(&place, &files("b.json")).is_err());
        assert_eq!(names(), ["b.json"]);
        fs::remove_dir_all(place.join("b.json")).unwrap();
        write(&place, &files("b.json")).unwrap();
        assert!(write(&place, &files("no/such/folder")).is_err());
        assert_eq!(names(), ["a.json", "b.json"]);
        fs::remove_dir_all(&place).unwrap();
    }
}
