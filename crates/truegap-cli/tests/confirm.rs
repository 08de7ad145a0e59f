//! `truegap confirm` on the command line: exit codes and what is printed.

#![allow(clippy::unwrap_used)]

mod common;

use common::Bench;
use serde_json::Value;

/// The built-in example in two folders: the first runs, and the last ones.
fn in_two_folders(bench: &Bench) {
    let whole = truegap::diagnosis::example_recording().unwrap();
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
    // the table of an earlier answer is a recording like any other
    std::fs::copy(bench.path("b/recording.csv"), bench.path("judged/confirmation.csv")).unwrap();
    bench.file("judged.toml", "schema = \"truegap.recording/1\"\nfile = \"judged/confirmation.csv\"\n");
    for other in ["judged/confirmation.csv", "judged.toml"] {
        bench.refuses(&["-q", "confirm", "out/augmented.toml", other, "-o", "judged"], &["confirmation.csv: is read here"]);
    }
    bench.refuses(&["-q", "confirm", "a/recording.toml", "b"], &["a/recording.toml", "truegap.model/1"]);
    bench.refuses(&["-q", "confirm", "out/augmented.toml", "b", "--free", "slope"], &["slope", "gain"]);
}

/// One run instead of two: the diagnosis of `a` is judged on `b` by the same figures as `truegap confirm` gives, in the JSON, on the page and on the terminal.
#[test]
fn a_diagnosis_is_judged_in_the_same_run() {
    let bench = Bench::new();
    in_two_folders(&bench);
    let said = bench.run(&["-q", "diagnose", "a", "--confirm", "b", "--free", "gain,offset", "-o", "out"]);
    assert_eq!(said.code, 1, "{}{}", said.out, said.err);
    assert!(said.out.contains("b/recording.toml, which took no part: ") || said.out.contains("On b"), "{}", said.out);
    let alone = bench.run(&["-q", "confirm", "out/augmented.toml", "b", "--free", "gain,offset", "--json"]);
    let alone: Value = serde_json::from_str(&alone.out).unwrap();
    let diagnosis: Value = serde_json::from_str(&std::fs::read_to_string(bench.path("out/diagnosis.json")).unwrap()).unwrap();
    let within = &diagnosis["confirmation"];
    // the file holds each number to its last bit
    for key in ["verdict", "base", "augmented", "noise", "test", "free", "unit", "recording"] {
        assert_eq!(within[key], alone[key], "{key}");
    }
    // a number and its sign are kept on one line
    let page = std::fs::read_to_string(bench.path("out/report.html")).unwrap().replace('\u{a0}', " ");
    assert!(page.contains("On a recording that took no part") && page.contains(within["says"].as_str().unwrap()));
    bench.refuses(&["-q", "diagnose", "a", "--confirm", "a", "-o", "no"], &["took no part"]);
    bench.refuses(&["-q", "diagnose", "a", "--confirm", "nowhere.toml", "-o", "no"], &["nowhere.toml"]);
    bench.refuses(&["-q", "diagnose", "a", "--confirm", "b", "--free", "slope", "-o", "no"], &["slope", "gain"]);
}

/// Nothing is named where only an effect that is not there may be, so there is nothing to judge, and that is said.
#[test]
fn where_nothing_is_named_there_is_nothing_to_confirm() {
    let bench = Bench::new();
    in_two_folders(&bench);
    let said =
        bench.run(&["-q", "diagnose", "a", "--confirm", "b", "--effects", "contact_toe_in", "--library-only", "-o", "out"]);
    let diagnosis: Value = serde_json::from_str(&std::fs::read_to_string(bench.path("out/diagnosis.json")).unwrap()).unwrap();
    assert_eq!(diagnosis["findings"].as_array().unwrap().len(), 0, "{}", said.out);
    let refused = diagnosis["confirmation"]["refused"].as_str().unwrap();
    assert!(refused.contains("nothing to confirm") && said.out.contains(refused), "{refused}");
}

/// The example has one cause that every run shows: it is named without each of them, and the error of those choices stands beside that of the one choice.
#[test]
fn what_is_named_is_chosen_again_without_each_part() {
    let bench = Bench::new();
    in_two_folders(&bench);
    let said = bench.run(&["-q", "diagnose", "a", "--select-in-folds", "--library-only", "-o", "out"]);
    let diagnosis: Value = serde_json::from_str(&std::fs::read_to_string(bench.path("out/diagnosis.json")).unwrap()).unwrap();
    let again = &diagnosis["fit"]["held_out"]["selected_again"];
    let parts = again["parts"].as_array().unwrap();
    let named = |part: &&Value| part["named"] == serde_json::json!(["thermal_lag"]);
    assert_eq!((parts.len(), parts.iter().filter(named).count() as u64), (4, again["same"].as_u64().unwrap()));
    assert!(again["same"].as_u64().unwrap() >= 3, "{again}");
    assert!(said.out.contains(again["says"].as_str().unwrap()), "{}", said.out);
    let [chosen_again, once] = [&again["rmse"], &diagnosis["fit"]["held_out"]["rmse_after"]].map(|e| e.as_f64().unwrap());
    assert!((0.99..1.5).contains(&(chosen_again / once)), "{chosen_again} {once}");
    let page = std::fs::read_to_string(bench.path("out/report.html")).unwrap();
    assert!(page.contains("What is named without each part"));
}

/// Where a recording never rests, its noise was what the base model leaves in short stretches: there a lag leaves ten times the noise, and the table said that the noise is larger than the
/// error of the augmented model.
#[test]
fn the_noise_is_never_larger_than_what_the_augmented_model_leaves() {
    let bench = Bench::new();
    let simulated = |t: f64| 0.5 + 0.3 * (t / 1.1).sin() + 0.15 * (t / 0.37).sin();
    let (mut late, mut state, mut rows) = (simulated(0.0), 7u64, String::new());
    for row in 0..2000 {
        let t = f64::from(row) * 0.1;
        if row > 0 {
            late += (0.5 * (simulated(t) + simulated(t - 0.1)) - late) * (1.0 - (-0.1f64 / 2.0).exp());
        }
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        // uniform over 0.004 mV/V: a standard deviation of 0.00115 mV/V
        let noise = ((state >> 33) as f64 / f64::from(1u32 << 31) - 0.5) * 0.004;
        rows += &format!("{t},{},{}\n", simulated(t), late + noise);
    }
    bench.file("late.toml", common::LATE_SIMULATION).file("other.csv", &format!("time_s,simulated,bridge [mV/V]\n{rows}"));
    let said = bench.run(&["-q", "--json", "confirm", "late.toml", "other.csv", "--map", "response=bridge [mV/V]"]);
    let answer: serde_json::Value = serde_json::from_str(&said.out).unwrap_or_else(|_| panic!("{}{}", said.out, said.err));
    let [noise, left] = ["noise", "augmented"].map(|part| answer[part]["rmse"].as_f64().unwrap());
    assert!(noise <= left && (0.0009..0.0015).contains(&noise), "{noise} beside {left}: {}", answer["noise"]);
    assert_eq!(answer["noise"]["measured"], false, "{}", answer["noise"]);
}
