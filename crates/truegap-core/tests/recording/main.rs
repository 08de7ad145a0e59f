//! Recordings: what is read, what is refused, and that writing and reading are inverse.

#![allow(clippy::unwrap_used)]

mod columns;
mod driver_roles;
mod read;
mod told;

use sha2::{Digest, Sha256};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicU32, Ordering};
use truegap_core::recording::{BaseSpec, Cells, FrameColumn, Told};
use truegap_core::{Driver, Inputs, Note, Recording, RecordingError, Role};

/// A folder of its own that goes away with the test.
struct Folder(PathBuf);

impl Folder {
    fn new() -> Self {
        static COUNT: AtomicU32 = AtomicU32::new(0);
        let count = COUNT.fetch_add(1, Ordering::Relaxed);
        let path = std::env::temp_dir().join(format!("truegap-recording-{}-{count}", std::process::id()));
        std::fs::create_dir_all(&path).unwrap();
        Self(path)
    }

    fn file(&self, name: &str, text: impl AsRef<[u8]>) -> PathBuf {
        let path = self.0.join(name);
        std::fs::write(&path, text).unwrap();
        path
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = std::fs::remove_dir_all(&self.0);
    }
}

fn csv(text: impl AsRef<[u8]>) -> Result<Recording, RecordingError> {
    let folder = Folder::new();
    Recording::open(folder.file("bare.csv", text))
}

fn with_toml(toml: &str, text: &str) -> Result<Recording, RecordingError> {
    let folder = Folder::new();
    folder.file("r.csv", text);
    Recording::open(folder.file("r.toml", format!("schema = \"truegap.recording/1\"\nfile = \"r.csv\"\n{toml}")))
}

fn message(found: Result<Recording, RecordingError>) -> String {
    found.expect_err("must be refused").to_string()
}
