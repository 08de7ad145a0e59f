//! What a stranger types first: the built-in example, and the model that comes out of it.

#![allow(clippy::unwrap_used)]

mod common;

use common::Bench;
use serde_json::Value;

fn json(bench: &Bench, name: &str) -> Value {
    serde_json::from_str(&std::fs::read_to_string(bench.path(name)).unwrap()).unwrap()
}

#[test]
fn the_example_is_diagnosed_and_its_model_simulates() {
    let bench = Bench::new();
    let said = bench.run(&["-q", "diagnose", "example", "-o", "out"]);
    assert_eq!(said.code, 1, "{}{}", said.out, said.err);
    assert!(said.out.contains("thermal lag") && said.out.contains("report.html"), "{}", said.out);
    for file in ["report.html", "augmented.toml", "prediction.csv"] {
        assert!(bench.path("out").join(file).is_file(), "{file} is missing");
    }
    names_the_concealed_cause(&json(&bench, "out/diagnosis.json"));
    suggests_no_run_against_what_is_excluded(&json(&bench, "out/diagnosis.json"));
    simulates(&bench);
}

/// The slab's mean temperature follows slow changes by pi^2 / 12 of the slowest time constant, 22.57 s: see the recording's README.
fn names_the_concealed_cause(diagnosis: &Value) {
    assert_eq!(diagnosis["verdict"], "explained");
    let findings = diagnosis["findings"].as_array().unwrap();
    assert_eq!(findings.len(), 1, "{findings:?}");
    assert_eq!(findings[0]["effect"], "thermal_lag");
    let time = &findings[0]["parameters"].as_array().unwrap()[0];
    let (value, sd) = (time["value"].as_f64().unwrap(), time["sd"].as_f64().unwrap());
    let expected = 22.568_549 * std::f64::consts::PI.powi(2) / 12.0;
    assert!(sd < 0.1 * expected && (value - expected).abs() < 3.0 * sd, "{value} +- {sd} s, expected {expected} s");
    let held_out = &diagnosis["fit"]["held_out"];
    assert!(held_out["rmse_after"].as_f64().unwrap() < 0.8 * held_out["rmse_before"].as_f64().unwrap(), "{held_out}");
}

/// The cause is sure: a run that would tell it from excluded rivals "by 10435 standard deviations" tells nobody anything.
fn suggests_no_run_against_what_is_excluded(diagnosis: &Value) {
    let next = &diagnosis["next_experiment"];
    assert!(next["separates"].as_array().unwrap().is_empty(), "{next}");
    assert!(next["says"].as_str().unwrap().starts_with("nothing is left that thermal lag would have to be told from"), "{next}");
    for option in next["options"].as_array().unwrap() {
        assert!((0.0..0.8).contains(&option["error_left"].as_f64().unwrap()), "{option}");
    }
    let line = &diagnosis["reference"][0];
    assert_eq!((line["name"].as_str(), line["inputs"].as_array().unwrap().len()), (Some("straight_line"), 2));
    assert!(line["held_out"].as_f64() > diagnosis["fit"]["held_out"]["rmse_after"].as_f64(), "{line}");
}

fn simulates(bench: &Bench) {
    let lines = |arguments: &[&str]| -> Vec<Value> {
        let said = bench.run(arguments);
        assert_eq!(said.code, 0, "{}", said.err);
        said.out.lines().map(|line| serde_json::from_str(line).unwrap()).collect()
    };
    let history = lines(&["-q", "simulate", "--model", "out/augmented.toml", "--drive", "example", "--json"]);
    let recording = truegap::diagnosis::example_recording().unwrap();
    assert_eq!(history.len(), recording.len());
    // noise of the response (4 fF) and what 0.05 K and 5 mN of noise on the inputs make of it: below 20 fF together; the range is 3 pF
    let squares = history.iter().zip(&recording.response).map(|(row, read)| (row["response"].as_f64().unwrap() - read).powi(2));
    let rms = (squares.sum::<f64>() / recording.len() as f64).sqrt();
    assert!(rms < 0.02, "{rms} pF");
    // what the report proposes to type
    let profile = lines(&["-q", "simulate", "--model", "out/augmented.toml", "--profile", "thermal-sweep-loaded", "--json"]);
    let warmest = profile.iter().map(|row| row["temperature_c"].as_f64().unwrap()).fold(0.0, f64::max);
    assert_eq!((profile.len(), warmest, profile[0]["force_n"].as_f64()), (800, 50.0, Some(4.5)));
    bench.refuses(&["simulate", "--model", "out/augmented.toml", "--profile", "dance"], &["dance", "long-hold", "overnight"]);
    let points =
        lines(&["simulate", "--model", "out/augmented.toml", "--load", "0,4.5 N", "--temperature", "20,50 degC", "--json"]);
    let response = |k: usize| points[k]["response"].as_f64().unwrap();
    assert_eq!((points.len(), &points[3]["temperature_c"], &points[3]["unit"]), (4, &Value::from(50.0), &Value::from("pF")));
    assert!(response(1) > response(0) + 1.0 && (response(2) - response(0)).abs() > 0.05, "{points:?}");
    let table = bench.run(&["simulate", "--model", "out/augmented.toml", "--load", "1 N"]);
    assert!(table.code == 0 && table.out.contains("response"), "{}{}", table.out, table.err);
    bench.refuses(&["simulate", "--model", "out/augmented.toml", "--load", "1 kPa"], &["kPa", "mN, kN"]);
    bench.refuses(
        &["simulate", "--model", "out/augmented.toml", "--load", "9 kN"],
        &["9000 N at 20 degC", "closes the gap", "stay below"],
    );
    bench.refuses(&["simulate", "--model", "nowhere.toml", "--load", "1 N"], &["nowhere.toml", "cannot be read", "diagnosis"]);
    bench.refuses(&["simulate", "--model", "out/prediction.csv", "--load", "1 N"], &["out/prediction.csv", "augmented.toml"]);
}
