//! What is wrong with a recording, told beside the answer: what, where, the value with its unit, and how to fix it.
//!
//! Limits: plain data; found in [`crate::quality::rows`] and by whoever opens the recording.

use serde::Serialize;

/// Kinds of trouble, as they stand in files.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
#[non_exhaustive]
pub enum NoticeKind {
    /// single readings far from their neighbours, left out
    Outliers,
    /// rows that repeat the one before, left out
    RepeatedRows,
    /// readings that end at exactly one value, left out
    #[serde(rename = "clipped")]
    ClippedRows,
    /// the same, too many to be left out
    Clipped,
    /// a channel that stops following
    DeadChannel,
    /// an input column that stops following
    DeadInput,
    /// inputs beyond what the sensor is made for
    OutOfRange,
    /// a long pause inside a run
    Gap,
    /// the base model foresees something else altogether
    WrongSensor,
    /// the simulation moves a power of a thousand as far as the reading
    WrongUnit,
    /// nothing that drives the model changes
    ConstantInput,
}

/// One trouble.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Notice {
    /// what kind
    pub kind: NoticeKind,
    /// what, where, value with unit, how to fix it
    pub says: String,
    /// rows concerned, as first and last of each stretch, counted from 1 as in the recording given
    pub rows: Vec<[usize; 2]>,
    /// whether no physics is named because of it
    pub withholds: bool,
}
