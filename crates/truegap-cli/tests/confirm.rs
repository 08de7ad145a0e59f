//! `truegap confirm` on the command line: exit codes and what is printed.

#![allow(clippy::unwrap_used)]

mod common;

use common::Bench;
use serde_json::Value;

/// The built-in example in two folders: the first runs, and the last ones.
fn in_two_folders(bench: &Bench) {
    let whole = truegap::example_recording().unwrap();
    for (name, runs) in [("a", 1..=4), ("b", 5..=7)] {
        let rows: Vec<usize> = (0..whole.len()).filter(|row| runs.contains(&whole.inputs.run[*row])).collect();
        std::fs::create_dir(bench.path(name)).unwrap();
        whole.select(&rows).write(bench.path(name)).unwrap();
    }
}

#[test]
fn exit_codes_follow_the_verdict_and_refusals_leave_nothing_behind() {
    let bench = Bench::new();
    in_two_folders(&bench);
    bench.run(&["-q", "diagnose", "a", "-o", "out"]);
    let said = bench.run(&["-q", "confirm", "out/augmented.toml", "b", "--json", "-o", "judged"]);
    let document: Value = serde_json::from_str(&said.out).unwrap();
    assert_eq!(document["schema"], "truegap.confirmation/1");
    assert_eq!(document["model"]["effects"], serde_json::json!(["thermal_lag"]));
    assert_eq!(said.code, i32::from(document["verdict"] != "confirmed"), "{}", said.out);
    assert!(bench.path("judged/confirmation.json").is_file() && bench.path("judged/confirmation.csv").is_file());
    let table = bench.run(&["confirm", "out/augmented.toml", "b", "--free", "offset"]);
    for part in ["Verdict: ", "base model alone", "augmented model", "noise", "Noise: "] {
        assert!(table.out.contains(part), "`{part}` is missing in: {}", table.out);
    }
    bench.refuses(&["-q", "confirm", "out/augmented.toml", "a", "-o", "no"], &["took no part"]);
    bench.refuses(&["-q", "confirm", "a/recording.toml", "b"], &["a/recording.toml", "truegap.model/1"]);
    bench.refuses(&["-q", "confirm", "out/augmented.toml", "b", "--free", "slope"], &["slope", "gain"]);
}
