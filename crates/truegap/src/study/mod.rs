//! Design studies as a user asks for them: a request, the answer as numbers, CSV, figures and a page, on one machine or in shards on many.
//!
//! Limits: the numbers are `truegap-design`'s, the cases `truegap-sweep`'s; here they meet files.

pub mod answer;
#[cfg(feature = "fem")]
pub mod audit;
mod error;
mod merge;
pub mod optimise;
mod page;
pub mod sensitivity;
mod subject;
pub mod tolerance;
pub mod vary;
#[cfg(feature = "fem")]
mod where_broken;
mod work;

pub use error::StudyError;
pub use merge::{Study, merge};
pub use subject::SensorText;
pub use work::{Finished, Work, check_place};
