//! Why a study has no answer.
//!
//! Limits: the first reason found.

use crate::output::OutputError;
use crate::predict::FindSensorError;
use std::path::PathBuf;
use truegap_core::sensor::SensorError;
use truegap_design::DesignError;
use truegap_scene::figure::FigureError;
use truegap_sweep::SweepError;

/// Why a study has no answer.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
#[allow(missing_docs)] // the fields are named by the messages
pub enum StudyError {
    /// No such sensor.
    #[error(transparent)]
    FindSensor(Box<FindSensorError>),
    /// Not a sensor.
    #[error(transparent)]
    Sensor(Box<SensorError>),
    /// The study means nothing.
    #[error(transparent)]
    Design(Box<DesignError>),
    /// More than can be held.
    #[error(transparent)]
    TooLarge(#[from] truegap_limits::TooLarge),
    /// The description of a space cannot be read.
    #[error("cannot be read: {source}; give the path of a space's TOML")]
    Unread { path: PathBuf, source: std::io::Error },
    /// The folder of results cannot be written.
    #[error(
        "{path}: cannot be written: {source}; nothing of this answer is left behind: make room, or name another folder with -o"
    )]
    Write { path: PathBuf, source: std::io::Error },
    /// The folder holds what is not ours.
    #[error(transparent)]
    Output(#[from] OutputError),
    /// Cases cannot be kept.
    #[error(transparent)]
    Sweep(Box<SweepError>),
    /// A case has no answer.
    #[error("{reason}")]
    Case { reason: String },
    /// Stopped at once.
    #[error("stopped before the first case was done; there is nothing to keep")]
    Nothing,
    /// A share without a place for it.
    #[error("shard {shard} needs a folder that all shards share; name it with -o DIR")]
    NoFolder { shard: String },
    /// Nothing that this program merges.
    #[error("the folder holds a sweep of `{study}`; this program merges {known}")]
    UnknownStudy { study: String, known: String },
    /// A request that another version wrote.
    #[error("the sweep's request cannot be read: {reason}; run the study once more with this version")]
    Request { reason: String },
    /// A figure without a finite number.
    #[error("a figure cannot be drawn: {0}")]
    Figure(Box<FigureError>),
    /// An answer that is no JSON.
    #[error("the answer cannot be written as JSON: {0}")]
    Json(#[from] serde_json::Error),
}

/// Large reasons are boxed, so that an answer is not the size of its failure.
macro_rules! boxed {
    ($($Reason:ident as $Kind:ident),*) => {
        $(impl From<$Reason> for StudyError {
            fn from(reason: $Reason) -> Self {
                Self::$Kind(Box::new(reason))
            }
        })*
    };
}

boxed!(FindSensorError as FindSensor, SensorError as Sensor, DesignError as Design, SweepError as Sweep, FigureError as Figure);
