//! Tables as people and instruments write them: letters, separators, headers, remarks, numbers and dates.

#![allow(clippy::unwrap_used)]

mod bench;
mod inputs_alone;
mod names;
mod no_rows;
mod written;
