//! What stops a sweep.
//!
//! Limits: the first problem found; a case that has no answer is not one of them, it is listed by the run.

use std::io;
use std::path::PathBuf;

/// Why a sweep cannot be described, run or merged.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
#[allow(missing_docs)] // the fields are named by the messages
pub enum SweepError {
    /// Not a share.
    #[error("there is no shard `{text}`; write INDEX/COUNT with INDEX from 1 to COUNT, for example 3/16")]
    NoSuchShard { text: String },
    /// JSON has no place for it.
    #[error("a case or result cannot be written as JSON: {reason}; leave such a field out")]
    Unwritable { reason: String },
    /// Twice the same.
    #[error("cases {first} and {second} are the same ({hash}); give each its own seed or number")]
    Twice { first: usize, second: usize, hash: String },
    /// Nothing to do.
    #[error("the sweep `{study}` has no case")]
    Empty { study: String },
    /// The folder belongs to another sweep.
    #[error(
        "{folder}: holds another sweep ({has}, here {wants}), with other settings or of another version; give this one a folder of its own"
    )]
    OtherSweep { folder: PathBuf, has: String, wants: String },
    /// The folder belongs to none.
    #[error("{file}: holds no sweep: {reason}; name the folder that the shards were given with -o")]
    NoSweep { file: PathBuf, reason: String },
    /// Cases are not there yet.
    #[error(
        "{folder}: {missing} of {cases} cases are missing: {listed}; run the shards that hold them once more, what is done is not repeated"
    )]
    Missing { folder: PathBuf, missing: usize, cases: usize, listed: String },
    /// A case's file does not hold that case's result.
    #[error("{file}: is not the result of its case: {reason}; delete it and run its shard once more")]
    Damaged { file: PathBuf, reason: String },
    /// The disk says no.
    #[error("{path}: {what}: {source}")]
    Disk { path: PathBuf, what: &'static str, source: io::Error },
}
