//! What a diagnosis gives back: the answer, columns for a report, the model.
//!
//! Limits: plain data.

use crate::answer::{augmented::Augmented, diagnosis::Diagnosis, traces::Traces};
/// What comes out.
pub struct Outcome {
    /// the answer
    pub diagnosis: Diagnosis,
    /// columns for a report
    pub traces: Traces,
    /// the model that it ends with
    pub augmented: Augmented,
    /// whether the search was stopped before its end
    pub interrupted: bool,
}
