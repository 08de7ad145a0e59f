//! A blind study end to end, and what a study must refuse.

#![allow(clippy::unwrap_used)]

mod common;

use common::Bench;
use serde_json::Value;
use std::fs;

const STUDY: [&str; 9] = ["prove", "--cases", "3", "--seed", "7", "--protocols", "short", "-o", "s"];

fn json(path: std::path::PathBuf) -> Value {
    serde_json::from_str(&fs::read_to_string(path).unwrap()).unwrap()
}

#[test]
fn three_cases_are_sealed_diagnosed_and_scored_and_an_altered_key_is_refused() {
    let bench = Bench::new();
    let said = bench.run(&STUDY);
    assert!(said.code == 0 || said.code == 1, "{}", said.err);
    let commitments = fs::read_to_string(bench.path("s/commitments.txt")).unwrap();
    assert_eq!(commitments.lines().count(), 3);
    assert!(said.out.starts_with(&commitments) && said.out.contains("false alarms, all nulls"), "{}", said.out);

    // the counts are those of the answers in the key and of the diagnoses, read here a second time
    let score = json(bench.path("s/score.json"));
    let (mut nulls, mut agreeing) = (0, 0);
    for case in ["case-001", "case-002", "case-003"] {
        let answer = json(bench.path(&format!("s/key/{case}.json")));
        let diagnosis = json(bench.path(&format!("s/diagnoses/{case}/diagnosis.json")));
        let null = answer["effects"].as_array().unwrap().is_empty() && answer["stranger"].is_null();
        nulls += usize::from(null);
        agreeing += usize::from(diagnosis["verdict"] == "agrees");
    }
    let row = |says: &str| score["targets"].as_array().unwrap().iter().find(|r| r["says"] == says).unwrap().clone();
    assert_eq!(row("false alarms, all nulls")["of"], nulls);
    assert_eq!(score["cases"].as_array().unwrap().iter().filter(|c| c["verdict"] == "agrees").count(), agreeing);
    assert_eq!(row("seconds for a diagnosis (median)")["of"], 3);
    assert_eq!(score["controls"].as_array().unwrap().len(), 4);
    assert!(fs::read_to_string(bench.path("s/score.md")).unwrap().contains("--cases 3 --seed 7"));

    // gone on with: only what is missing is diagnosed again
    fs::remove_dir_all(bench.path("s/diagnoses/case-002")).unwrap();
    let kept = fs::metadata(bench.path("s/diagnoses/case-001/diagnosis.json")).unwrap().modified().unwrap();
    let again = bench.run(&["prove", "--resume", "--json", "-o", "s"]);
    assert_eq!(again.code, said.code, "{}", again.err);
    let told: Value = serde_json::from_str(&again.out).unwrap();
    assert_eq!(told["commitments_sha256"], score["commitments_sha256"]);
    let now = fs::metadata(bench.path("s/diagnoses/case-001/diagnosis.json")).unwrap().modified().unwrap();
    assert_eq!(now, kept);

    let key = bench.path("s/key/case-002.json");
    let text = fs::read_to_string(&key).unwrap();
    fs::write(&key, text.replacen("\"detectability\": ", "\"detectability\": 1", 1)).unwrap();
    let refused = ["prove", "--resume", "-q", "--json", "-o", "s"];
    bench.refuses(&refused, &["case-002", "SHA-256", "altered after the study was published"]);
}

#[test]
fn a_study_is_not_begun_where_something_lies_nor_gone_on_with_where_there_is_none() {
    let bench = Bench::new();
    fs::create_dir(bench.path("s")).unwrap();
    bench.refuses(&["prove", "--resume", "-o", "s"], &["no study", "leave --resume out"]);
    fs::write(bench.path("s/thesis.tex"), "mine").unwrap();
    bench.refuses(&STUDY, &["thesis.tex", "--resume"]);
    let none = bench.run(&["prove", "--cases", "0", "-o", "new"]);
    assert!(none.code == 2 && none.err.contains("'--cases <N>': 0 is not in 1..=100000"), "{}", none.err);
    assert!(!bench.path("new").exists());
}
