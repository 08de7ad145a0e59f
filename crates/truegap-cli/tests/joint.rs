//! Several recordings on one command line.

#![allow(clippy::unwrap_used)]

mod common;

use common::Bench;
use serde_json::Value;
use truegap::Recording;

/// The built-in example in two folders, the second one read 0.2 pF higher.
fn in_two_folders(bench: &Bench) {
    let whole = truegap::diagnosis::example_recording().unwrap();
    let write = |name: &str, runs: std::ops::RangeInclusive<u32>, higher: f64| {
        let rows: Vec<usize> = (0..whole.len()).filter(|row| runs.contains(&whole.inputs.run[*row])).collect();
        let mut part: Recording = whole.select(&rows);
        part.response.iter_mut().for_each(|r| *r += higher);
        std::fs::create_dir(bench.path(name)).unwrap();
        part.write(bench.path(name)).unwrap();
    };
    write("a", 1..=4, 0.0);
    write("b", 5..=7, 0.2);
}

#[test]
fn each_recording_is_listed_and_has_its_own_offset_where_asked() {
    let bench = Bench::new();
    in_two_folders(&bench);
    let said = bench.run(&["-q", "diagnose", "a/recording.toml", "b/recording.toml", "--free", "offset", "-o", "out", "--json"]);
    assert_eq!(said.code, 1, "{}{}", said.out, said.err);
    let diagnosis: Value = serde_json::from_str(&said.out).unwrap();
    let each = diagnosis["recording"]["recordings"].as_array().unwrap();
    assert_eq!((each.len(), &each[1]["number"], &each[1]["runs"], &each[1]["first_run"]), (2, &2.into(), &3.into(), &5.into()));
    assert_eq!(each[0]["rows"].as_u64().unwrap() + each[1]["rows"].as_u64().unwrap(), 1160);
    let hashes: Vec<&str> = each.iter().map(|e| e["sha256"].as_str().unwrap()).collect();
    assert!(hashes[0] != hashes[1] && hashes.iter().all(|h| h.len() == 64));
    assert_eq!(diagnosis["findings"][0]["effect"], "thermal_lag");
    let parameters = diagnosis["base"]["parameters_after"].as_array().unwrap();
    let offset = parameters.iter().find(|p| p["name"] == "offset_2").unwrap();
    let (value, sd) = (offset["value"].as_f64().unwrap(), offset["sd"].as_f64().unwrap());
    assert_eq!(offset["prior"][0], 0.0);
    assert!((value - 0.2).abs() < 3.0 * sd && sd < 0.05, "{value} +- {sd}");
    let prediction = std::fs::read_to_string(bench.path("out/prediction.csv")).unwrap();
    assert!(prediction.starts_with("run,recording,time_s,"));
    let last = prediction.lines().last().unwrap();
    assert!(last.starts_with("7,2,"), "{last}");
    // the model of the first recording's sensor is one that simulates
    let point = bench.run(&["simulate", "--model", "out/augmented.toml", "--load", "1 N"]);
    assert_eq!(point.code, 0, "{}", point.err);
}

#[test]
fn a_batch_takes_each_by_itself() {
    let bench = Bench::new();
    in_two_folders(&bench);
    let said = bench.run(&[
        "-q",
        "diagnose",
        "--batch",
        "a/recording.toml",
        "b/recording.toml",
        "--effects",
        "thermal_lag",
        "-o",
        "out",
    ]);
    assert_eq!(said.out.lines().count(), 2, "{}{}", said.out, said.err);
    let again =
        bench.run(&["--json", "-q", "diagnose", "--batch", "a/recording.toml", "--effects", "thermal_lag", "-o", "again"]);
    let printed: Value = serde_json::from_str(&again.out).unwrap();
    // the word of the table is that of the document
    let word = printed["verdict"].as_str().unwrap();
    assert_eq!(said.out.lines().next().unwrap().split_whitespace().nth(1), Some(word), "{}", said.out);
    for name in ["a", "b"] {
        let text = std::fs::read_to_string(bench.path("out").join(name).join("diagnosis.json")).unwrap();
        let diagnosis: Value = serde_json::from_str(&text).unwrap();
        assert!(diagnosis["recording"].get("recordings").is_none(), "{}", diagnosis["recording"]);
    }
}

/// Its rows counted twice, and each part left out stood in the other copy.
#[test]
fn a_recording_that_is_given_twice_is_refused() {
    let bench = Bench::new();
    in_two_folders(&bench);
    let typed = ["-q", "diagnose", "a/recording.toml", "b/recording.toml", "a/recording.toml", "-o", "out"];
    bench.refuses(&typed, &["a/recording.toml and", "hold the same rows", "leave one of them out"]);
}

#[test]
fn what_cannot_be_freed_is_refused() {
    let bench = Bench::new();
    in_two_folders(&bench);
    bench.refuses(&["-q", "diagnose", "a/recording.toml", "--free", "gain", "-o", "out"], &["--free", "at least two"]);
    bench.refuses(
        &["-q", "diagnose", "a/recording.toml", "b/recording.toml", "--free", "drift", "-o", "out"],
        &["drift", "gain,offset"],
    );
}
