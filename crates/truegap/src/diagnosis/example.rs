//! The recording that is built in, for a first look without data of one's own.
//!
//! Limits: made by the blind generator, with one concealed cause; what it is stands in `validation/recordings/example/README.md`.

use std::path::Path;
use truegap_core::recording::Told;
use truegap_core::{Recording, RecordingError};

/// The word that stands for the recording on the command line.
const EXAMPLE: &str = "example";

const TOML: &str = include_str!("../../../../validation/recordings/example/recording.toml");
const CSV: &str = include_str!("../../../../validation/recordings/example/recording.csv");

/// The built-in recording: 1160 rows of a thermal protocol on the paper's sensor.
///
/// # Errors
/// [`RecordingError`] where the texts in the program cannot be read, which a test excludes.
pub fn example_recording() -> Result<Recording, RecordingError> {
    example_told(&Told::default())
}

/// The recording at `path`, or the built-in one where that is its name and nothing on disk has it; either is read as `told`.
///
/// # Errors
/// As [`Recording::open_told`].
pub fn recorded(path: &Path, told: &Told) -> Result<Recording, RecordingError> {
    if path == Path::new(EXAMPLE) && !path.exists() { example_told(told) } else { Recording::open_told(path, told) }
}

/// The built-in recording, read as it is told: its columns have names like those of any file.
fn example_told(told: &Told) -> Result<Recording, RecordingError> {
    Recording::from_text_told(EXAMPLE, TOML, CSV, told)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_built_in_recording_is_the_one_in_the_repository() {
        let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../validation/recordings/example");
        let (built_in, on_disk) = (example_recording().unwrap(), Recording::open(folder).unwrap());
        assert_eq!((built_in.len(), built_in.inputs.runs().len()), (1160, 7));
        assert_eq!(built_in.sha256, on_disk.sha256);
        assert_eq!(built_in.inputs, on_disk.inputs);
    }
}
