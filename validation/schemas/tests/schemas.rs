//! The schemas in docs/schemas are those of the types, and the files of the repository keep to them.

#![allow(clippy::unwrap_used)]

use jsonschema::Validator;
use serde_json::Value;
use std::path::{Path, PathBuf};
use truegap_schemas::{Index, written};

fn workspace() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

fn validator(name: &str) -> Validator {
    let text = std::fs::read_to_string(workspace().join(format!("docs/schemas/{name}.json"))).unwrap();
    jsonschema::validator_for(&serde_json::from_str(&text).unwrap()).unwrap()
}

/// Every TOML below `folder`, but for those in folders of results.
fn tomls(folder: &Path, into: &mut Vec<PathBuf>) {
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            tomls(&path, into);
        } else if path.extension().is_some_and(|e| e == "toml") {
            into.push(path);
        }
    }
}

fn told(schema: &Validator, document: &Value) -> String {
    schema.iter_errors(document).map(|e| format!("{} at {}; ", e, e.instance_path())).collect()
}

#[test]
fn the_schemas_are_those_of_the_types() {
    let all = written(&Index::of(&workspace()).unwrap(), &workspace()).unwrap();
    for (name, text) in &all {
        let file = workspace().join(format!("docs/schemas/{name}.json"));
        let on_disk = std::fs::read_to_string(&file).unwrap_or_default();
        assert!(on_disk == *text, "docs/schemas/{name}.json is not what the types say; run `cargo run -p truegap-schemas`");
    }
    assert_eq!(std::fs::read_dir(workspace().join("docs/schemas")).unwrap().count(), all.len());
}

#[test]
fn every_toml_of_the_repository_keeps_to_its_schema() {
    let mut files = Vec::new();
    for folder in ["meshes", "validation/recordings", "validation/attack/corpus", "docs"] {
        tomls(&workspace().join(folder), &mut files);
    }
    let kinds = ["recording", "sensor", "case", "mechanism", "model"];
    let schemas = kinds.map(validator);
    let mut seen = [0; 5];
    for file in files {
        let text = std::fs::read_to_string(&file).unwrap();
        let Ok(document) = toml::from_str::<Value>(&text) else { continue };
        let kind = document["schema"].as_str().unwrap_or_default();
        let Some(place) = kinds.iter().position(|name| kind == format!("truegap.{name}/1")) else { continue };
        seen[place] += 1;
        assert!(schemas[place].is_valid(&document), "{}: {}", file.display(), told(&schemas[place], &document));
    }
    assert!(seen.iter().all(|count| *count > 0), "{kinds:?} {seen:?}");
}

#[test]
fn what_the_readers_refuse_for_its_shape_is_refused() {
    let refused = [
        ("recording", r#"{"schema": "truegap.recording/1"}"#),
        ("recording", r#"{"schema": "truegap.recording/1", "file": "a.csv", "columns": {"load": "F"}}"#),
        ("recording", r#"{"schema": "truegap.recording/1", "file": "a.csv", "base": {"model": "stak"}}"#),
        ("recording", r#"{"schema": "truegap.recording/2", "file": "a.csv"}"#),
        ("mechanism", r#"{"schema": "truegap.mechanism/1", "id": "a", "quantity": "gap", "action": "adds", "driver": "load", "kinetics": "static", "form": "linear"}"#),
        ("case", r#"{"schema": "truegap.case/1", "physics": "electrostatics"}"#),
    ];
    for (name, text) in refused {
        assert!(!validator(name).is_valid(&serde_json::from_str(text).unwrap()), "{name} takes {text}");
    }
    let taken = r#"{"schema": "truegap.recording/1", "file": "a.csv", "columns": {"force": "F"}, "drivers": {"pump": {"column": "p", "unit": "V"}}}"#;
    assert!(validator("recording").is_valid(&serde_json::from_str(taken).unwrap()));
}
