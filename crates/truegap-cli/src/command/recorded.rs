//! The recording that an argument names.

use std::path::Path;
use truegap::{EXAMPLE, Recording, RecordingError, example_recording};

/// The built-in recording where its name is given and nothing on disk has that name.
pub fn recorded(path: &Path) -> Result<Recording, RecordingError> {
    if path == Path::new(EXAMPLE) && !path.exists() { example_recording() } else { Recording::open(path) }
}
