//! The recording that is built in, for a first look without data of one's own.
//!
//! Limits: made by the blind generator, with one concealed cause; what it is stands in `validation/recordings/example/README.md`.

use truegap_core::recording::Told;
use truegap_core::{Recording, RecordingError};

/// The word that stands for the recording on the command line.
pub const EXAMPLE: &str = "example";

const TOML: &str = include_str!("../../../../validation/recordings/example/recording.toml");
const CSV: &str = include_str!("../../../../validation/recordings/example/recording.csv");

/// The built-in recording: 1160 rows of a thermal protocol on the paper's sensor.
///
/// # Errors
/// [`RecordingError`] where the texts in the program cannot be read, which a test excludes.
pub fn example_recording() -> Result<Recording, RecordingError> {
    example_told(&Told::default())
}

/// The same, read as it is told: its columns have names like those of any file.
///
/// # Errors
/// [`RecordingError`] where what is told does not fit its columns.
pub fn example_told(told: &Told) -> Result<Recording, RecordingError> {
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
