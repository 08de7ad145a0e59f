//! How much one command may take: memory, counted before it is allocated, and files, looked at before they are read.
//!
//! Limits: memory is estimated from what is asked for, by numbers that were measured, not watched while it grows; time is not limited.

mod input;
mod size;

pub use input::{open, read_text};
pub use size::{Need, TooLarge, VARIABLE, check, count, memory_limit};
