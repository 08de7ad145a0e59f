//! Tables of numbers in the pages of this repository, written from result files.
//!
//! A page marks the place of a table by `<!-- table: NAME -->` and `<!-- end -->`; [`pages`] writes what belongs between them, [`collect`] makes the result file of
//! the real recordings from folders that `truegap diagnose` wrote.
//!
//! Limits: README.md and the pages of `docs/`; text around the tables is not looked at.

mod collect;
mod csv;
mod error;
mod front;
mod markdown;
mod number;
mod page;
mod real;
mod review;
mod sources;
mod speed;
mod study;
mod table;
mod worded;

pub use collect::collect;
pub use error::TablesError;
pub use page::{Page, pages, rewritten};
pub use real::{Finding, REAL, Real, Recording};
