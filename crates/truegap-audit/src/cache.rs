//! Findings on disk under the hash of everything they depend on.
//!
//! Limits: the hash covers sensor, options, assumption and [`REVISION`], not the code itself: raise the revision when a method changes.

use crate::{error::AuditError, finding::Finding, study::Options};
use sha2::{Digest, Sha256};
use std::{
    path::{Path, PathBuf},
    sync::atomic::{AtomicU64, Ordering},
};
use truegap_core::Sensor;

/// Raised with every change of a method, so that old findings are not taken for new ones.
pub(crate) const REVISION: u32 = 4;

/// What a finding depends on.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Key {
    /// sha256, hexadecimal
    pub(crate) sha256: String,
    /// assumption
    pub(crate) id: String,
}

impl Key {
    /// The key of an assumption for a sensor; name and description of the sensor do not count.
    pub(crate) fn of(sensor: &Sensor, options: Options, id: &str) -> Self {
        let physics = Sensor { name: String::new(), description: String::new(), ..sensor.clone() };
        // Debug prints floating-point numbers with all their digits.
        let text = format!("truegap.audit {} {REVISION}\n{id}\n{options:?}\n{physics:?}", env!("CARGO_PKG_VERSION"));
        let digest = Sha256::digest(text.as_bytes());
        Self { sha256: digest.iter().map(|byte| format!("{byte:02x}")).collect(), id: id.to_owned() }
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
    pub(crate) fn finding(&self, key: &Key) -> Result<Option<Finding>, AuditError> {
        let Some(path) = self.path(key) else { return Ok(None) };
        match std::fs::read_to_string(&path) {
            // a file that was renamed or edited is not the finding that is asked for
            Ok(text) => Ok(serde_json::from_str(&text).ok().filter(|finding: &Finding| finding.id == key.id)),
            Err(error) if error.kind() == std::io::ErrorKind::NotFound => Ok(None),
            Err(error) => Err(AuditError::Cache { path, problem: error.to_string() }),
        }
    }

    /// Stores a finding: written beside its place and moved there, so that no reader ever sees half a file.
    ///
    /// # Errors
    /// [`AuditError::Cache`] where the folder is not writable.
    pub(crate) fn store(&self, key: &Key, finding: &Finding) -> Result<(), AuditError> {
        static NEXT: AtomicU64 = AtomicU64::new(0);
        let (Some(folder), Some(path)) = (&self.folder, self.path(key)) else { return Ok(()) };
        let number = NEXT.fetch_add(1, Ordering::Relaxed);
        let beside = folder.join(format!(".{}.{}.{number}", key.sha256, std::process::id()));
        let refused = |error: String| AuditError::Cache { path: path.clone(), problem: error };
        let text = serde_json::to_string_pretty(finding).map_err(|e| refused(e.to_string()))?;
        std::fs::create_dir_all(folder).map_err(|e| refused(e.to_string()))?;
        std::fs::write(&beside, text).and_then(|()| std::fs::rename(&beside, &path)).map_err(|e| {
            let _ = std::fs::remove_file(&beside); // nothing more can be done where even removing fails
            refused(e.to_string())
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        effect::EffectOn,
        finding::{FemValue, Measure, Value, Verdict},
    };
    use truegap_core::sensor::builtin_sensors;

    #[test]
    fn the_cache_knows_a_finding_by_what_it_depends_on() {
        let folder = std::env::temp_dir().join(format!("truegap-audit-cache-{}", std::process::id()));
        let (cache, sensor) = (Cache::in_folder(&folder), builtin_sensors()[0].sensor().unwrap());
        let finding = Finding {
            id: "A".into(),
            says: "a".into(),
            analytic: Value { value: 0.1 + 0.2, unit: "pF".into() },
            fem: FemValue { value: 1.0 / 3.0, unit: "pF".into(), error_estimate: 1e-9 },
            relative_error: -0.1,
            verdict: Verdict::Broken,
            reason: "r".into(),
            effect_on: EffectOn { baseline_pct: Some(1.0), ..EffectOn::default() },
            measure: Measure { name: "m".into(), value: 1.0, limit: 2.0 },
            source: "s".into(),
            figure: None,
        };
        let key = Key::of(&sensor, Options::default(), "A");
        assert_eq!(cache.finding(&key).unwrap(), None);
        cache.store(&key, &finding).unwrap();
        assert_eq!(cache.finding(&key).unwrap(), Some(finding));
        let renamed = Sensor { name: "another".into(), ..sensor.clone() };
        assert_eq!(Key::of(&renamed, Options::default(), "A"), key);
        let mut changed = sensor.clone();
        changed.tail.0 += 1e-9;
        for other in [
            Key::of(&changed, Options::default(), "A"),
            Key::of(&sensor, Options::default(), "B"),
            Key::of(&sensor, Options { hot_c: 51.0, ..Options::default() }, "A"),
        ] {
            assert_ne!(other, key);
        }
        let other = Key::of(&sensor, Options::default(), "B");
        std::fs::copy(cache.path(&key).unwrap(), cache.path(&other).unwrap()).unwrap();
        assert_eq!(cache.finding(&other).unwrap(), None, "a finding under the name of another");
        std::fs::remove_dir_all(folder).unwrap();
    }
}
