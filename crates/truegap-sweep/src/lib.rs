//! Many independent cases, on one machine or on many, with the same bytes at the end.
//!
//! A [`Sweep`] is a list of cases; each is named by the SHA-256 of what it is, so a case that has been computed is never computed again and never counted twice.
//! [`Sweep::run`] computes a [`Shard`] of them into a folder, one file a case; [`Sweep::merge`] reads them back in the order of the list, whoever computed them.
//!
//! Limits: cases must not depend on each other, and must be functions of what they are (seeds included); shards share a file system; numbers in cases and results
//! must be finite, because JSON knows no others (a case with `None` leaves the field out).
//!
//! # Example: four cases by two processes
//!
//! ```
//! use truegap_sweep::{Control, Shard, Sweep, SweepError};
//!
//! let folder = std::env::temp_dir().join(format!("truegap-sweep-{}", std::process::id()));
//! // The name of the study changes when the same case would have another result.
//! let sweep = Sweep::new("square/1", &"the first four numbers", vec![0, 1, 2, 3])?;
//! for shard in ["1/2", "2/2"] {
//!     let ran = sweep.run(&folder, shard.parse::<Shard>()?, Control::default(), |n: &i32| Ok::<i32, String>(n * n))?;
//!     assert_eq!((ran.of, ran.computed, ran.failed.len()), (2, 2, 0));
//! }
//! // What is there is not computed again.
//! let again = sweep.run(&folder, Shard::WHOLE, Control::default(), |n: &i32| Ok::<i32, String>(n * n))?;
//! assert_eq!((again.found, again.computed), (4, 0));
//! assert_eq!(sweep.merge::<i32>(&folder)?.complete()?, [0, 1, 4, 9]);
//! # std::fs::remove_dir_all(&folder).ok();
//! # Ok::<(), SweepError>(())
//! ```

mod canonical;
mod control;
mod error;
mod files;
mod merge;
mod run;
mod shard;
mod sweep;

pub use control::{Control, Progress};
pub use error::SweepError;
pub use files::{Described, describe, write_atomically, write_once};
pub use merge::Merged;
pub use run::Ran;
pub use shard::Shard;
pub use sweep::Sweep;
