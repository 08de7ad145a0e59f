//! Recovery banks kept between runs: one file a protocol, named by the hash of everything that its answers depend on.
//!
//! Limits: kept in the user's cache folder ([`crate::cache_folder`]); where none can be written, nothing is kept.

use crate::cache_folder::cache_folder;
use std::{collections::BTreeMap, path::PathBuf, sync::Arc};
use truegap_diagnose::recovery::{BankCase, BankOptions, BankStore};
use truegap_sweep::write_atomically;

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
        if let Some((file, bytes)) = self.file(key).zip(serde_json::to_vec(cases).ok()) {
            let _ = write_atomically(&file, &bytes);
        }
    }
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
            "verdict": "explained", "named": ["ageing"], "sets": [], "models": [[["ageing"], -0.1]], "unmodelled": []
        }))
        .unwrap();
        let cases = BTreeMap::from([(3, case)]);
        cache.save("key", &cases);
        assert_eq!(cache.load("key"), cases);
        std::fs::write(folder.path().join("bank/key.json"), "{").unwrap();
        assert!(cache.load("key").is_empty() && Cache(None).load("key").is_empty());
    }
}
