//! What a file holds that is a frame, and its kind.
//!
//! Limits: numbers and times; of other columns the names alone.

use crate::recording::{error::RecordingError, frame::FrameColumn, manifest::Manifest};
use std::path::Path;

/// Kinds of files, each with its first bytes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    Parquet,
    Arrow,
}

impl Kind {
    /// In the words of a message.
    pub fn told(self) -> &'static str {
        match self {
            Self::Parquet => "a Parquet",
            Self::Arrow => "an Arrow",
        }
    }
}

/// The columns of a file.
pub(in crate::recording) struct Frame {
    pub columns: Vec<FrameColumn<'static>>,
    /// names of what is neither numbers nor times, and what it is
    pub left_out: Vec<(String, String)>,
    pub sha256: String,
}

impl Frame {
    /// Refuses a file whose columns of text are named for numbers.
    ///
    /// # Errors
    /// [`RecordingError::NoNumbersInColumn`].
    pub fn holds_numbers(&self, file: &Path, manifest: &Manifest) -> Result<(), RecordingError> {
        let roles = manifest.columns.values().map(|named| &named.text);
        let mut wanted = roles.chain(manifest.drivers.iter().map(|driver| &driver.column));
        match wanted.find_map(|name| self.left_out.iter().find(|(column, _)| column == name)) {
            None => Ok(()),
            Some((column, holds)) => {
                let (file, column, holds) = (file.to_owned(), column.clone(), holds.clone());
                Err(RecordingError::NoNumbersInColumn { file, column, holds })
            }
        }
    }
}
