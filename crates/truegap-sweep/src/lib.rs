//! Many independent cases, on one machine or on many, with the same bytes at the end.
//!
//! A [`Sweep`] is a list of cases; each is named by the SHA-256 of what it is, so a case that has been computed is never computed again and never counted twice.
//! [`Sweep::run`] computes a [`Shard`] of them into a folder, one file a case; [`Sweep::merge`] reads them back in the order of the list, whoever computed them.
//!
//! Limits: cases must not depend on each other, and must be functions of what they are (seeds included); shards share a file system; numbers in cases and results
//! must be finite, because JSON knows no others (a case with `None` leaves the field out).

mod canonical;
mod control;
mod error;
mod files;
mod merge;
mod run;
mod shard;
mod sweep;

pub use canonical::{canonical, sha256};
pub use control::{Control, Progress};
pub use error::SweepError;
pub use files::{Described, describe, write_atomically};
pub use merge::Merged;
pub use run::Ran;
pub use shard::Shard;
pub use sweep::Sweep;
