//! Findings on disk under the hash of everything they depend on.
//!
//! Limits: the hash covers sensor, options, assumption and [`REVISION`], not the code itself: raise the revision when a method changes.

use crate::{AuditError, Finding, Options};
use sha2::{Digest, Sha256};
use std::{
    path::{Path, PathBuf},
    sync::atomic::{AtomicU64, Ordering},
};
use truegap_core::Sensor;

/// Raised with every change of a method, so that old findings are not taken for new ones.
pub const REVISION: u32 = 4;

/// What a finding depends on.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Key {
    /// sha256, hexadecimal
    pub sha256: String,
}

impl Key {
    /// The key of an assumption for a sensor; name and description of the sensor do not count.
    pub fn of(sensor: &Sensor, options: Options, id: &str) -> Self {
        let physics = Sensor { name: String::new(), description: String::new(), ..sensor.clone() };
        // Debug prints floating-point numbers with all their digits.
        let text = format!("truegap.audit {} {REVISION}\n{id}\n{options:?}\n{physics:?}", env!("CARGO_PKG_VERSION"));
        let digest = Sha256::digest(text.as_bytes());
        Self { sha256: digest.iter().map(|byte| format!("{byte:02x}")).collect() }
    }
}

/// A folder of findings, or none.
#[derive(Clone, Debug, Default)]
pub struct Cache {
    folder: Option<PathBuf>,
}

impl Cache {
    /// Remembers nothing.
    pub fn none() -> Self {
        Self::default()
    }

    /// Findings in a folder, which is made when the first one is stored.
    pub fn in_folder(folder: &Path) -> Self {
        Self { folder: Some(folder.to_owned()) }
    }

    fn path(&self, key: &Key) -> Option<PathBuf> {
        Some(self.folder.as_ref()?.join(format!("{}.json", key.sha256)))
    }

    /// A finding, if it is known. A file that cannot be read as one counts as unknown and is overwritten later.
    ///
    /// # Errors
    /// [`AuditError::Cache`] where the file is there and the system refuses to read it.
    pub fn finding(&self, key: &Key) -> Result<Option<Finding>, AuditError> {
        let Some(path) = self.path(key) else { return Ok(None) };
        match std::fs::read_to_string(&path) {
            Ok(text) => Ok(serde_json::from_str(&text).ok()),
            Err(error) if error.kind() == std::io::ErrorKind::NotFound => Ok(None),
            Err(error) => Err(AuditError::Cache { path, problem: error.to_string() }),
        }
    }

    /// Stores a finding: written beside its place and moved there, so that no reader ever sees half a file.
    ///
    /// # Errors
    /// [`AuditError::Cache`] where the folder is not writable.
    pub fn store(&self, key: &Key, finding: &Finding) -> Result<(), AuditError> {
        static NEXT: AtomicU64 = AtomicU64::new(0);
        let (Some(folder), Some(path)) = (&self.folder, self.path(key)) else { return Ok(()) };
        let number = NEXT.fetch_add(1, Ordering::Relaxed);
        let beside = folder.join(format!(".{}.{}.{number}", key.sha256, std::process::id()));
        let refused = |error: String| AuditError::Cache { path: path.clone(), problem: error };
        let text = serde_json::to_string_pretty(finding).map_err(|e| refused(e.to_string()))?;
        std::fs::create_dir_all(folder).map_err(|e| refused(e.to_string()))?;
        std::fs::write(&beside, text).map_err(|e| refused(e.to_string()))?;
        std::fs::rename(&beside, &path).map_err(|e| refused(e.to_string()))
    }
}
