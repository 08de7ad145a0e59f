//! `cargo install` builds without dependencies of tests, and refuses a feature that names one: every feature names what the program itself depends on.

use std::{fs, path::Path};
use toml::{Table, Value};

/// Names that the features of a manifest ask something of, and that it does not depend on outside of tests.
fn only_of_tests(manifest: &Table) -> Vec<String> {
    let table = |name: &str| manifest.get(name).and_then(Value::as_table).cloned().unwrap_or_default();
    let (features, own) = (table("features"), table("dependencies"));
    let asked = features.values().filter_map(Value::as_array).flatten().filter_map(Value::as_str);
    let of = |feature: &str| {
        let name = feature.strip_prefix("dep:").or_else(|| feature.split_once('/').map(|(name, _)| name))?;
        Some(name.trim_end_matches('?').to_string())
    };
    asked.filter_map(of).filter(|name| !own.contains_key(name)).collect()
}

#[test]
fn features_name_no_dependency_of_tests() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let folders = ["crates", "validation"].iter().flat_map(|folder| fs::read_dir(root.join(folder)).unwrap());
    let manifests: Vec<_> = folders.map(|entry| entry.unwrap().path().join("Cargo.toml")).filter(|m| m.is_file()).collect();
    assert!(manifests.len() > 10, "{}", manifests.len());
    for path in manifests {
        let manifest = fs::read_to_string(&path).unwrap().parse().unwrap();
        let names = only_of_tests(&manifest);
        assert!(names.is_empty(), "{}: features ask for {names:?}, on which it depends in tests alone", path.display());
    }
}

/// As it once was: the program could be built, and not be installed.
#[test]
fn a_feature_that_asks_for_a_dependency_of_tests_is_found() {
    let manifest = "[features]\nfem = ['truegap/fem', 'attack/fem', 'dep:mesher']\ndefault = ['fem']\n[dependencies]\ntruegap = '1'\n[dev-dependencies]\nattack = '1'\n";
    assert_eq!(only_of_tests(&manifest.parse().unwrap()), ["attack", "mesher"]);
}
