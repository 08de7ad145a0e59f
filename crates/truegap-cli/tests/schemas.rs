//! What the command writes keeps to the schemas that it prints.

#![allow(clippy::unwrap_used)]

mod common;

use common::Bench;
use jsonschema::Validator;
use serde_json::Value;

fn validator(bench: &Bench, name: &str) -> Validator {
    let said = bench.run(&["schema", name]);
    assert_eq!(said.code, 0, "{}", said.err);
    jsonschema::validator_for(&serde_json::from_str(&said.out).unwrap()).unwrap()
}

/// Holds each line of JSON in `text` against a schema.
fn keeps(bench: &Bench, name: &str, text: &str) {
    let schema = validator(bench, name);
    let documents = serde_json::Deserializer::from_str(text).into_iter::<Value>().collect::<Result<Vec<_>, _>>().unwrap();
    assert!(!documents.is_empty(), "{name}: nothing was written");
    for document in documents {
        let wrong: Vec<String> = schema.iter_errors(&document).map(|e| format!("{e} at {}", e.instance_path())).collect();
        assert!(wrong.is_empty(), "{name}: {}", wrong.join("; "));
        assert!(!schema.is_valid(&Value::Array(vec![document])), "{name} takes anything");
    }
}

/// Runs a command and holds its JSON against a schema.
fn prints(bench: &Bench, name: &str, arguments: &[&str]) {
    let said = bench.run(&[&["--json", "-q"], arguments].concat());
    assert!(said.code < 2, "{arguments:?}: {}", said.err);
    keeps(bench, name, &said.out);
}

fn read(bench: &Bench, file: &str) -> String {
    std::fs::read_to_string(bench.path(file)).unwrap()
}

#[test]
fn a_diagnosis_its_model_and_what_the_model_answers() {
    let bench = Bench::new();
    prints(&bench, "diagnosis", &["diagnose", "example", "-o", "out"]);
    keeps(&bench, "diagnosis", &read(&bench, "out/diagnosis.json"));
    let model: Value = toml::from_str(&read(&bench, "out/augmented.toml")).unwrap();
    keeps(&bench, "model", &model.to_string());
    prints(&bench, "simulate-model", &["simulate", "--model", "out/augmented.toml", "--load", "0, 4.5 N"]);
    // another recording of the same sensor: its time is half a second later, so that it is another file
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../validation/recordings/example");
    let csv = std::fs::read_to_string(format!("{folder}/recording.csv")).unwrap();
    bench.file("recording.csv", csv.trim_end().rsplit_once('\n').unwrap().0);
    bench.file("other.toml", &std::fs::read_to_string(format!("{folder}/recording.toml")).unwrap());
    prints(&bench, "confirmation", &["confirm", "out/augmented.toml", "other.toml"]);
}

#[test]
fn what_the_analytic_model_answers() {
    let bench = Bench::new();
    prints(&bench, "simulate", &["simulate", "--load", "0:4.5 N:3", "--temperature", "20, 50 degC"]);
    prints(&bench, "simulate-drive", &["simulate", "--drive", "example"]);
    prints(&bench, "coefficients", &["coefficients"]);
    prints(&bench, "explain", &["explain", "viscoelastic_creep"]);
    let said = bench.run(&["--json", "sensors"]);
    let (schema, listed) = (validator(&bench, "sensors"), serde_json::from_str(&said.out).unwrap());
    assert!(schema.is_valid(&listed), "{}", said.out);
}

#[test]
fn a_case_its_mesh_and_its_solution() {
    let bench = Bench::new();
    let case = concat!(env!("CARGO_MANIFEST_DIR"), "/../../meshes/cases/coaxial_cable.toml");
    prints(&bench, "solve", &["solve", case]);
    prints(&bench, "mesh", &["mesh", case, "-o", "cable.vtu"]);
    prints(&bench, "export", &["export", "--sensor", "foam-s15", "-o", "stack.glb"]);
}

#[test]
fn the_studies_and_one_assumption_of_the_audit() {
    let bench = Bench::new();
    prints(&bench, "sensitivity", &["sensitivity", "-o", "s"]);
    prints(&bench, "tolerance", &["tolerance", "--samples", "2000", "--limit", "span=2.3:2.6", "--seed", "5", "-o", "t"]);
    prints(&bench, "optimise", &["optimise", "--searches", "1", "--seed", "3", "-o", "o"]);
    prints(&bench, "audit", &["audit", "--sensor", "foam-s15", "--only", "SERIES-OF-INTEGRALS", "-o", "a"]);
}

#[test]
fn a_misspelt_schema_is_answered_with_the_nearest() {
    let bench = Bench::new();
    bench.refuses(&["schema", "diagnosys"], &["no schema `diagnosys`", "`diagnosis`"]);
    assert!(bench.run(&["schema"]).out.lines().count() > 20);
}
