//! A study: many blind cases from one seed, with shares that the seed draws and nobody is told.
//!
//! Limits: every case has its own streams, so any of them can be made alone; a study is as secret as its seed.

use crate::answer::Answer;
use crate::case::{BlindCase, CaseError};
use crate::commitment::{self, COMMITMENTS, CommitmentError, Sums};
use crate::settings::{Options, Settings, Shares};
use std::path::{Path, PathBuf};

/// File beside a recording that names the effect which the diagnosis is to do without.
pub const WITHOUT: &str = "without.txt";
/// File of the key that makes the study again: its seed, and what else was asked for.
pub const PLAN: &str = "plan.json";

/// Many blind cases from one seed.
#[derive(Debug, Clone)]
pub struct Study {
    settings: Settings,
    cases: usize,
}

/// What can go wrong with a study on disk.
#[derive(Debug, thiserror::Error)]
pub enum StudyError {
    /// The settings contradict themselves.
    #[error("detectability from {from} to {to}: both must be positive and the first the smaller")]
    Range {
        /// Least.
        from: f64,
        /// Largest.
        to: f64,
    },
    /// A case could not be made.
    #[error(transparent)]
    Case(#[from] CaseError),
    /// A file could not be read or written.
    #[error("{path}: {source}; put it back where it is gone, or check the permissions")]
    File {
        /// File.
        path: PathBuf,
        /// Cause.
        source: std::io::Error,
    },
    /// An answer is not valid JSON.
    #[error("{path}: {source}; take the key as the generator wrote it")]
    Json {
        /// File.
        path: PathBuf,
        /// Cause.
        source: serde_json::Error,
    },
    /// A file does not fit the commitments.
    #[error(transparent)]
    Commitment(#[from] CommitmentError),
}

impl Study {
    /// A study of `cases` cases from `seed`.
    pub fn new(seed: u64, cases: usize, options: Options) -> Result<Self, StudyError> {
        let (from, to) = (options.detectability_from, options.detectability_to);
        if !(from > 0.0 && to > from) {
            return Err(StudyError::Range { from, to });
        }
        Ok(Self { settings: Settings::new(seed, options), cases })
    }

    /// Number of cases.
    pub fn cases(&self) -> usize {
        self.cases
    }

    /// Seed.
    pub fn seed(&self) -> u64 {
        self.settings.seed
    }

    /// The shares that the seed drew; sealed like the answers.
    pub fn shares(&self) -> &Shares {
        &self.settings.shares
    }

    /// Settings.
    pub fn options(&self) -> &Options {
        &self.settings.options
    }

    /// Case number `index` (from 0), named from 001.
    pub fn case(&self, index: usize) -> Result<BlindCase, CaseError> {
        BlindCase::draw(&self.settings, index)
    }

    /// All cases in order.
    pub fn iter(&self) -> impl Iterator<Item = Result<BlindCase, CaseError>> + '_ {
        (0..self.cases).map(|index| self.case(index))
    }

    /// Writes recordings, commitments and, in `key/`, the answers and `plan` (what makes the study again) into `folder`; calls `made` after each case.
    ///
    /// Publish the folder without `key/`. The commitments, a line for every file, are written last: without them there is no study.
    pub fn write(&self, folder: &Path, plan: &str, mut made: impl FnMut(usize)) -> Result<(), StudyError> {
        let mut commitments = String::new();
        for index in 0..self.cases {
            let case = self.case(index)?;
            for (file, text) in files(&case)? {
                put(&place(folder, &file), &text)?;
                commitments += &commitment::line(&file, &text);
            }
            made(index);
        }
        put(&place(folder, PLAN), plan)?;
        put(&folder.join(COMMITMENTS), &(commitments + &commitment::line(PLAN, plan)))
    }
}

/// What is committed to of a case: the names of its files in `commitments.txt`, and their texts.
fn files(case: &BlindCase) -> Result<Vec<(String, String)>, StudyError> {
    let name = &case.answer.case;
    let text = case.answer.text().map_err(|source| StudyError::Json { path: name.into(), source })?;
    let recorded = |file: &str, text: String| (format!("{name}/{file}"), text);
    let mut files = vec![
        (format!("{name}.json"), text),
        recorded("recording.csv", case.recording.csv()),
        recorded("recording.toml", case.recording.toml()),
    ];
    files.extend(case.answer.without.as_ref().map(|effect| recorded(WITHOUT, effect.clone())));
    Ok(files)
}

/// Where a file of `commitments.txt` lies: a name without a folder is one of the key.
pub fn place(folder: &Path, file: &str) -> PathBuf {
    if file.contains('/') { folder.join(file) } else { folder.join("key").join(file) }
}

/// The commitments of the study in `folder`, each file checked against its line.
///
/// # Errors
/// [`StudyError`] where a file is missing or not what it was.
pub fn checked(folder: &Path) -> Result<Sums, StudyError> {
    let sums = Sums::parse(COMMITMENTS, &get(&folder.join(COMMITMENTS))?)?;
    for file in sums.files() {
        sums.check(file, get(&place(folder, file))?)?;
    }
    Ok(sums)
}

/// Reads the answers of the study in `folder`, checking each file against its commitment.
pub fn open(folder: &Path) -> Result<Vec<Answer>, StudyError> {
    let sums = checked(folder)?;
    let answers = sums.files().filter(|file| !file.contains('/') && *file != PLAN);
    let read = |file| {
        let path = place(folder, file);
        serde_json::from_str(&get(&path)?).map_err(|source| StudyError::Json { path, source })
    };
    let mut answers = answers.map(read).collect::<Result<Vec<Answer>, StudyError>>()?;
    answers.sort_by(|a, b| (a.case.len(), &a.case).cmp(&(b.case.len(), &b.case)));
    Ok(answers)
}

/// Writes a file whole or not at all.
fn put(path: &Path, text: &str) -> Result<(), StudyError> {
    let failed = |source| StudyError::File { path: path.to_owned(), source };
    let part = path.with_extension(format!("{}.part", std::process::id()));
    let folder = path.parent().unwrap_or(Path::new("."));
    std::fs::create_dir_all(folder)
        .and_then(|()| std::fs::write(&part, text))
        .and_then(|()| std::fs::rename(&part, path))
        .map_err(failed)
}

fn get(path: &Path) -> Result<String, StudyError> {
    std::fs::read_to_string(path).map_err(|source| StudyError::File { path: path.to_owned(), source })
}
