//! A slow input that was not recorded: whether the recording asks for one, and how well its course is recovered.
//!
//! Limits: one course, through the zero or the gain of the reading.

use serde::Serialize;

/// A column that was hidden on purpose, opened after its course had been recovered without it.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ConcealedColumn {
    /// role of the column
    pub column: String,
    /// its unit
    pub unit: String,
    /// the answer as a sentence
    pub says: String,
}
