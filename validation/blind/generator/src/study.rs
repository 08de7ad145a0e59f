//! A study: many blind cases from one seed, with shares that the seed draws and nobody is told.
//!
//! Limits: every case has its own streams, so any of them can be made alone; a study is as secret as its seed.

use crate::answer::Answer;
use crate::case::{BlindCase, CaseError};
use crate::causes::{LIBRARY, STRANGERS};
use crate::commitment::{self, CommitmentError};
use crate::draws::Draws;
use crate::protocol::Kind;
use std::path::{Path, PathBuf};

/// Settings of a study.
#[derive(Debug, Clone, PartialEq)]
pub struct Options {
    /// Least detectability asked of a cause.
    pub detectability_from: f64,
    /// Largest.
    pub detectability_to: f64,
    /// Protocols to draw from; empty: all.
    pub protocols: Vec<Kind>,
    /// What to conceal.
    pub only: Only,
}

/// Restriction of a study, to count one thing well; a tool that is told of it is no longer blind.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Only {
    /// Everything, in shares that the seed draws.
    #[default]
    Everything,
    /// Nothing is concealed.
    Nulls,
    /// One library cause each.
    Singles,
    /// Two library causes each.
    Pairs,
    /// A stranger each.
    Strangers,
    /// Nothing is concealed, and the measuring chain is at fault: the loggers of [`crate::logger`] in turn.
    Loggers,
}

impl Default for Options {
    fn default() -> Self {
        Self { detectability_from: 4.0, detectability_to: 120.0, protocols: Vec::new(), only: Only::Everything }
    }
}

/// Shares drawn from the seed.
#[derive(Debug, Clone, PartialEq)]
pub struct Shares {
    /// Weights of: nothing, one cause, two, three, a stranger.
    pub makeup: [f64; 5],
    /// Weights of the library's causes.
    pub library: Vec<f64>,
    /// Weights of the strangers.
    pub strangers: Vec<f64>,
    /// Weights of the protocols.
    pub protocols: Vec<(Kind, f64)>,
    /// Share of recordings with strongly autocorrelated noise.
    pub coloured: f64,
    /// Share with a humidity column for no reason.
    pub humidity: f64,
    /// Share whose base model rightly leaves the warp out.
    pub flat: f64,
}

impl Shares {
    fn drawn(seed: u64, options: &Options) -> Self {
        let draws = &mut Draws::of(seed, "shares");
        let nothing = draws.between(0.12, 0.35);
        let stranger = draws.between(0.06, 0.15);
        let two = draws.between(0.08, 0.2);
        let three = draws.between(0.0, 0.03);
        let weights =
            |count: usize, draws: &mut Draws| (0..count).map(|_| (0.4 * draws.truncated_normal(2.0)).exp()).collect::<Vec<f64>>();
        let kinds: &[Kind] = if options.protocols.is_empty() { &Kind::ALL } else { &options.protocols };
        let rich = |kind: &Kind| if matches!(kind, Kind::Full | Kind::Thermal | Kind::Mechanical) { 3.0 } else { 1.0 };
        Self {
            makeup: match options.only {
                Only::Everything => [nothing, 1.0 - nothing - stranger - two - three, two, three, stranger],
                Only::Nulls | Only::Loggers => [1.0, 0.0, 0.0, 0.0, 0.0],
                Only::Singles => [0.0, 1.0, 0.0, 0.0, 0.0],
                Only::Pairs => [0.0, 0.0, 1.0, 0.0, 0.0],
                Only::Strangers => [0.0, 0.0, 0.0, 0.0, 1.0],
            },
            library: weights(LIBRARY.len(), draws),
            strangers: weights(STRANGERS.len(), draws),
            protocols: kinds.iter().map(|kind| (*kind, rich(kind) * (0.3 * draws.normal()).exp())).collect(),
            coloured: draws.between(0.15, 0.4),
            humidity: draws.between(0.2, 0.5),
            flat: draws.between(0.05, 0.2),
        }
    }
}

/// Many blind cases from one seed.
#[derive(Debug, Clone)]
pub struct Study {
    seed: u64,
    cases: usize,
    options: Options,
    shares: Shares,
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
        let shares = Shares::drawn(seed, &options);
        Ok(Self { seed, cases, options, shares })
    }

    /// Number of cases.
    pub fn cases(&self) -> usize {
        self.cases
    }

    /// Seed.
    pub fn seed(&self) -> u64 {
        self.seed
    }

    /// The shares that the seed drew; sealed like the answers.
    pub fn shares(&self) -> &Shares {
        &self.shares
    }

    /// Settings.
    pub fn options(&self) -> &Options {
        &self.options
    }

    /// Case number `index` (from 0), named from 001.
    pub fn case(&self, index: usize) -> Result<BlindCase, CaseError> {
        BlindCase::draw(self, index)
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
