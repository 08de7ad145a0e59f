//! What is known of a recording before it is diagnosed.
//!
//! Limits: plain data; whoever read the recording fills it in, and no stage decides by it.

use crate::{answer::diagnosis::RecordingFacts, quality::notice::Notice};

/// What is known of a recording before it is diagnosed, for the record.
#[derive(Clone, Debug, Default)]
pub struct Known {
    /// what was read
    pub recording: RecordingFacts,
    /// name of the sensor that the base model stands for
    pub sensor: Option<String>,
    /// what is wrong with the recording
    pub notices: Vec<Notice>,
    /// doubts and remarks of whoever read it; they stand behind those that are found here
    pub remarks: Vec<String>,
}

impl From<RecordingFacts> for Known {
    fn from(recording: RecordingFacts) -> Self {
        Self { recording, ..Self::default() }
    }
}
