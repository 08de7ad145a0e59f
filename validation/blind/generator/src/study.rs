//! A study: many blind cases from one seed, with shares that the seed draws and nobody is told.
//!
//! Limits: every case has its own streams, so any of them can be made alone; a study is as secret as its seed.

use crate::answer::Answer;
use crate::case::{BlindCase, CaseError};
use crate::commitment::{self, CommitmentError};
use crate::settings::{Options, Settings, Shares};
use std::path::{Path, PathBuf};

/// File beside a recording that names the effect which the diagnosis is to do without.
pub const WITHOUT: &str = "without.txt";

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
    #[error("{path}: {source}; check the folder and its permissions")]
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
    /// The key does not fit the commitments.
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

    /// Writes recordings, commitments and, in `key/`, the answers into `folder`; calls `made` after each case.
    ///
    /// Publish the folder without `key/`; the commitments are complete before this returns.
    pub fn write(&self, folder: &Path, mut made: impl FnMut(usize)) -> Result<(), StudyError> {
        let mut commitments = String::new();
        for index in 0..self.cases {
            let case = self.case(index)?;
            let name = &case.answer.case;
            let text = case.answer.text().map_err(|source| StudyError::Json { path: folder.join(name), source })?;
            put(&folder.join("key").join(format!("{name}.json")), &text)?;
            put(&folder.join(name).join("recording.csv"), &case.recording.csv())?;
            put(&folder.join(name).join("recording.toml"), &case.recording.toml())?;
            if let Some(effect) = &case.answer.without {
                put(&folder.join(name).join(WITHOUT), effect)?;
            }
            commitments += &commitment::line(name, &text);
            made(index);
        }
        put(&folder.join("commitments.txt"), &commitments)
    }
}

/// Reads the answers of the study in `folder`, checking each against its commitment.
pub fn open(folder: &Path) -> Result<Vec<Answer>, StudyError> {
    let commitments = get(&folder.join("commitments.txt"))?;
    let mut answers = Vec::new();
    for file in commitments.lines().filter_map(|line| line.split_once("  ")).map(|(_, file)| file) {
        let path = folder.join("key").join(file);
        let text = get(&path)?;
        commitment::verify(&commitments, file.trim_end_matches(".json"), &text)?;
        answers.push(serde_json::from_str(&text).map_err(|source| StudyError::Json { path, source })?);
    }
    Ok(answers)
}

fn put(path: &Path, text: &str) -> Result<(), StudyError> {
    let failed = |source| StudyError::File { path: path.to_owned(), source };
    if let Some(folder) = path.parent() {
        std::fs::create_dir_all(folder).map_err(failed)?;
    }
    std::fs::write(path, text).map_err(failed)
}

fn get(path: &Path) -> Result<String, StudyError> {
    std::fs::read_to_string(path).map_err(|source| StudyError::File { path: path.to_owned(), source })
}
