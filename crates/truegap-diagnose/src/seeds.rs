//! Seeds of everything that a diagnosis draws by chance, in one place, because an answer tells them.
//!
//! Limits: they are part of a version and no option; the same files, options and version give the same answer.

use serde::Serialize;

/// What is drawn by chance, and from which seed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct Seeds {
    /// importance sampling of the evidence; the effects of a model are mixed in
    pub evidence: u64,
    /// permuted histories of the control beside a finding
    pub permutation_control: u64,
    /// what is left, turned about against the histories that mechanisms of words are screened with
    pub turned_residual: u64,
    /// what is left, with signs reversed, for mechanisms of words that follow the clock
    pub reversed_residual: u64,
    /// the whole search on permuted histories, where that was asked for
    pub permuted_searches: u64,
    /// recordings of the recovery bank, where it was run; the number of the recording is added
    pub bank: u64,
    /// signs of the blocks of a recording that took no part, where one was given
    pub confirmation: u64,
}

/// Those of this version.
pub const SEEDS: Seeds = Seeds {
    evidence: 0x7a11,
    permutation_control: 19,
    turned_residual: 17,
    reversed_residual: 18,
    permuted_searches: 1907,
    bank: 0xba27,
    confirmation: 19,
};

impl Seeds {
    /// Name and seed of each, as the fields are called.
    pub fn named(&self) -> [(&'static str, u64); 7] {
        [
            ("evidence", self.evidence),
            ("permutation control", self.permutation_control),
            ("turned residual", self.turned_residual),
            ("reversed residual", self.reversed_residual),
            ("permuted searches", self.permuted_searches),
            ("bank", self.bank),
            ("confirmation", self.confirmation),
        ]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::path::Path;

    /// Lines of the crate, tests left out, that start a generator from a number of their own.
    fn seeded_elsewhere(folder: &Path, found: &mut Vec<String>) {
        for entry in std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()) {
            if entry.is_dir() && entry.file_name().is_some_and(|name| name != "tests") {
                seeded_elsewhere(&entry, found);
            } else if entry.extension().is_some_and(|extension| extension == "rs") {
                let source = std::fs::read_to_string(&entry).unwrap();
                let product = source.split("\nmod tests {").next().unwrap_or_default();
                let own = |line: &&str| line.contains("seed_from_u64(") && !line.contains("SEEDS.") && !line.contains("(seed)");
                found.extend(product.lines().filter(own).map(|line| format!("{}: {line}", entry.display())));
            }
        }
    }

    #[test]
    fn every_seed_of_a_diagnosis_is_told() {
        let mut found = Vec::new();
        seeded_elsewhere(&Path::new(env!("CARGO_MANIFEST_DIR")).join("src"), &mut found);
        assert!(found.is_empty(), "{found:#?}");
        let told = serde_json::to_value(SEEDS).unwrap();
        let named: serde_json::Map<_, _> =
            SEEDS.named().map(|(name, seed)| (name.replace(' ', "_"), seed.into())).into_iter().collect();
        assert_eq!(told, serde_json::Value::Object(named));
    }
}
