//! What can be wrong with a sensor file.
//!
//! Limits: the first problem found; a file with several is mended one at a time.

use crate::units::UnitError;
use std::fmt;

/// Schema that the reader knows.
pub(super) const SCHEMA: &str = "truegap.sensor/1";

/// A problem with its place.
#[derive(Clone, Debug, PartialEq)]
pub struct SensorError {
    /// file, or the name of the place where the sensor comes from
    pub file: String,
    /// line of the file, from 1
    pub line: Option<usize>,
    /// key in dotted form, e.g. `electrode.plating.thickness`; empty where the file as a whole is meant
    pub key: String,
    /// what is wrong and what would be right
    pub problem: SensorProblem,
}

impl fmt::Display for SensorError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.file)?;
        if let Some(line) = self.line {
            write!(f, ", line {line}")?;
        }
        if !self.key.is_empty() {
            write!(f, ", `{}`", self.key)?;
        }
        write!(f, ": {}", self.problem)
    }
}

impl std::error::Error for SensorError {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        Some(&self.problem)
    }
}

/// What is wrong and what would be right.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum SensorProblem {
    /// Not TOML.
    #[error("not TOML: {message}")]
    Syntax {
        /// what the parser says
        message: String,
    },
    /// Another schema.
    #[error("`{found}` is not a schema of sensor files; write schema = \"{}\"", SCHEMA)]
    Schema {
        /// what stands there
        found: String,
    },
    /// A key that is not there.
    #[error("missing; write for example {example}")]
    Missing {
        /// what would do
        example: String,
    },
    /// A key that means nothing here.
    #[error("no such key; known here are {known}")]
    UnknownKey {
        /// keys that would do
        known: String,
    },
    /// A value of another type.
    #[error("is {found}; write {expected}")]
    WrongType {
        /// what stands there
        found: String,
        /// what would do
        expected: &'static str,
    },
    /// A quantity that cannot be read.
    #[error(transparent)]
    Unit(#[from] UnitError),
    /// A word out of a list.
    #[error("`{found}` is none of {known}")]
    UnknownWord {
        /// what stands there
        found: String,
        /// what would do
        known: String,
    },
    /// No such material.
    #[error("there is no material `{name}`; use one of {known}, or describe it under [materials.{name}]")]
    UnknownMaterial {
        /// the name
        name: String,
        /// materials of the file and built-in ones
        known: String,
    },
    /// A number that no sensor can have.
    #[error("{value} is not possible: {rule}")]
    OutOfRange {
        /// value with its unit
        value: String,
        /// what would do
        rule: &'static str,
    },
    /// More beads than electrode.
    #[error(
        "{count} beads of {diameter_um:.1} um cover {covered_mm2:.2} mm2, more than the electrode of {electrode_mm2:.2} mm2; use fewer or smaller beads, or a larger electrode"
    )]
    BeadsCoverElectrode {
        /// number of beads
        count: u32,
        /// diameter of one, um
        diameter_um: f64,
        /// area of all, mm²
        covered_mm2: f64,
        /// area of the electrode, mm²
        electrode_mm2: f64,
    },
    /// Beads that meet before full load.
    #[error(
        "{full_scale_n} N spreads the beads over the whole electrode, which happens at {limit_n:.3} N; lower full_scale, or use fewer, smaller or stiffer beads"
    )]
    BeadsMeet {
        /// load at full scale, N
        full_scale_n: f64,
        /// load at which the beads cover the electrode, N
        limit_n: f64,
    },
    /// A gap that closes before full load.
    #[error(
        "{full_scale_n} N closes the gap, which happens at {limit_n:.3} N; lower full_scale, or use more, larger or stiffer beads"
    )]
    GapCloses {
        /// load at full scale, N
        full_scale_n: f64,
        /// load that closes the gap, N
        limit_n: f64,
    },
}
