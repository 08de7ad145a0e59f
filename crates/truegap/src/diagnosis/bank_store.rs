//! Recovery banks kept between runs: one file a protocol, named by the hash of everything that its answers depend on.
//!
//! Limits: kept in the user's cache folder ([`crate::cache_folder`]); where none can be written, nothing is kept.

use crate::cache_folder::cache_folder;
use std::{
    collections::BTreeMap,
    path::{Path, PathBuf},
    sync::Arc,
};
use truegap_diagnose::recovery::{BankCase, BankOptions, BankStore};

/// A bank of so many recordings, kept in the cache folder.
pub(super) fn options(recordings: usize) -> Arc<BankOptions> {
    Arc::new(BankOptions { recordings, store: Box::new(Cache(cache_folder("bank"))) })
}

struct Cache(Option<PathBuf>);

impl Cache {
    fn file(&self, key: &str) -> Option<PathBuf> {
        self.0.as_ref().map(|folder| folder.join(format!("{key}.json")))
    }
}

impl BankStore for Cache {
    fn load(&self, key: &str) -> BTreeMap<usize, BankCase> {
        let text = self.file(key).and_then(|file| std::fs::read_to_string(file).ok());
        text.and_then(|text| serde_json::from_str(&text).ok()).unwrap_or_default()
    }

    fn save(&self, key: &str, cases: &BTreeMap<usize, BankCase>) {
        // a cache that cannot be written costs time, not answers
        let _ = self.file(key).map(|file| put(&file, cases));
    }
}

/// Writes beside the file and renames, so that a reader never sees half of it.
fn put(file: &Path, cases: &BTreeMap<usize, BankCase>) -> std::io::Result<()> {
    if let Some(folder) = file.parent() {
        std::fs::create_dir_all(folder)?;
    }
    let beside = file.with_extension(format!("{}.part", std::process::id()));
    let bytes = serde_json::to_vec(cases)?;
    std::fs::write(&beside, bytes).and_then(|()| std::fs::rename(&beside, file)).inspect_err(|_| {
        let _ = std::fs::remove_file(&beside); // nothing more can be done where even removing fails
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_stored_comes_back_and_what_is_broken_is_computed_again() {
        let folder = tempfile::tempdir().unwrap();
        let cache = Cache(Some(folder.path().join("bank")));
        let case: BankCase = serde_json::from_value(serde_json::json!({
            "truth": {"effects": ["ageing"], "sibling": true, "stranger": null, "detectability": 12.0},
            "verdict": "explained", "named": ["ageing"], "sets": [], "models": [[["ageing"], -0.1]]
        }))
        .unwrap();
        let cases = BTreeMap::from([(3, case)]);
        cache.save("key", &cases);
        assert_eq!(cache.load("key"), cases);
        std::fs::write(folder.path().join("bank/key.json"), "{").unwrap();
        assert!(cache.load("key").is_empty() && Cache(None).load("key").is_empty());
    }
}
