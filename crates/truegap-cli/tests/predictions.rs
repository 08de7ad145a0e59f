//! `sensors`, `coefficients`, `simulate`: the contract's keys, grids, and agreement with the library.

#![allow(clippy::unwrap_used)]

mod common;

use common::Bench;
use serde_json::Value;
use truegap::core::{Inputs, Recording, recording::BaseSpec};
use truegap::model::{Point, StackOptions, states};

fn lines(text: &str) -> Vec<Value> {
    text.lines().map(|line| serde_json::from_str(line).unwrap()).collect()
}

fn keys(value: &Value) -> Vec<&str> {
    value.as_object().unwrap().keys().map(String::as_str).collect()
}

const STATE: [&str; 10] = [
    "force_n",
    "temperature_c",
    "strain",
    "curvature_per_m",
    "c_rtv_pf",
    "c_polyimide_pf",
    "c_main_pf",
    "c_backing_pf",
    "c_tail_pf",
    "c_total_pf",
];

#[test]
fn simulate_prints_one_object_a_point_with_the_keys_of_the_contract() {
    let bench = Bench::new();
    let said = bench.run(&["simulate", "--load", "0:4.5 N:3", "--temperature", "20,50 degC", "--json"]);
    assert_eq!((said.code, said.err.as_str()), (0, ""));
    let points = lines(&said.out);
    assert_eq!(points.len(), 6);
    assert!(points.iter().all(|p| keys(p) == STATE));
    let sensor = truegap::predict::find_sensor("singletact-s15-4.5n", None).unwrap();
    let asked = [Point { force_n: 4.5, temperature_c: 50.0 }];
    let known = states(&sensor, StackOptions::default(), &asked).unwrap()[0];
    assert_eq!(points[5]["c_total_pf"].as_f64(), Some(known.c_total_pf), "JSON must keep every digit");
    assert_eq!((points[1]["force_n"].as_f64(), points[1]["temperature_c"].as_f64()), (Some(2.25), Some(20.0)));
}

#[test]
fn without_the_warp_the_electrode_stays_flat() {
    let bench = Bench::new();
    let curvature = |more: &[&str]| {
        let said = bench.run(&[&["simulate", "--load", "0 N", "--temperature", "50 degC", "--json"], more].concat());
        lines(&said.out)[0]["curvature_per_m"].as_f64().unwrap()
    };
    assert_eq!(curvature(&["--no-warp"]), 0.0);
    assert!(curvature(&[]) > 0.01);
}

#[test]
fn negative_temperatures_need_no_tricks() {
    let said = Bench::new().run(&["simulate", "--load", "1 N", "--temperature", "-10 degC", "--json"]);
    assert_eq!(lines(&said.out)[0]["temperature_c"].as_f64(), Some(-10.0));
}

#[test]
fn a_recording_drives_the_model_row_by_row() {
    let bench = Bench::new();
    let inputs = Inputs {
        time_s: Some(vec![0.0, 0.5, 2.0]),
        run: vec![1, 1, 2],
        force_n: Some(vec![0.0, 1.5, 4.5]),
        temperature_c: Some(vec![20.0, 21.0, 50.0]),
        ..Inputs::default()
    };
    let base = BaseSpec { model: "stack".into(), sensor: Some("singletact-s15-4.5n".into()), ..BaseSpec::default() };
    Recording::new(inputs, vec![74.0, 75.0, 76.0], "pF", base).unwrap().write(bench.path("")).unwrap();
    let driven = lines(&bench.run(&["simulate", "--drive", "recording.toml", "--json"]).out);
    assert_eq!(driven.len(), 3);
    assert_eq!((driven[2]["run"].as_u64(), driven[1]["time_s"].as_f64()), (Some(2), Some(0.5)));
    let point = lines(&bench.run(&["simulate", "--load", "4.5 N", "--temperature", "50 degC", "--json"]).out);
    for key in STATE {
        assert_eq!(driven[2][key], point[0][key], "{key}");
    }
}

#[test]
fn coefficients_have_the_keys_of_the_contract_and_are_secants_of_simulate() {
    let bench = Bench::new();
    let said = bench.run(&["coefficients", "--sensor", "singletact-s8-optimised", "--json"]);
    let c = lines(&said.out).remove(0);
    let wanted = [
        "baseline_pf",
        "span_pf",
        "k_baseline_pf_per_k",
        "k_baseline_pct_fsr_per_k",
        "k_sensitivity_pct_per_k",
        "linearity_pct",
        "k_linearity_pct_per_k",
    ];
    assert_eq!(keys(&c), wanted);
    let sensor = truegap::predict::find_sensor("singletact-s8-optimised", None).unwrap();
    let load = format!("0,{} N", sensor.full_scale);
    let points = lines(
        &bench
            .run(&["simulate", "--sensor", "singletact-s8-optimised", "--load", &load, "--temperature", "20,50 degC", "--json"])
            .out,
    );
    let total = |k: usize| points[k]["c_total_pf"].as_f64().unwrap();
    let number = |key: &str| c[key].as_f64().unwrap();
    // two routes, each rounds a difference of some 75 pF: 1e-14 pF over a drift of 0.01 pF/K
    approx::assert_relative_eq!(number("baseline_pf"), total(0), max_relative = 1e-14);
    approx::assert_relative_eq!(number("span_pf"), total(1) - total(0), max_relative = 1e-11);
    approx::assert_relative_eq!(number("k_baseline_pf_per_k"), (total(2) - total(0)) / 30.0, max_relative = 1e-10);
    let sensitivities = [(total(1) - total(0)), (total(3) - total(2))];
    let drift = 100.0 * (sensitivities[1] - sensitivities[0]) / sensitivities[0] / 30.0;
    approx::assert_relative_eq!(number("k_sensitivity_pct_per_k"), drift, max_relative = 1e-8);
}

#[test]
fn the_printed_equations_stand_beside_the_corrected_ones() {
    let bench = Bench::new();
    let printed = lines(&bench.run(&["coefficients", "--as-printed", "--json"]).out).remove(0)["as_printed"].take();
    for row in printed["equation_12"].as_array().unwrap() {
        let (corrected, printed) = (row["corrected"].as_f64().unwrap(), row["printed"].as_f64().unwrap());
        assert!(corrected < 0.0 && printed > 0.0, "the printed form opens the gap");
        let difference = row["size_difference_pct"].as_f64().unwrap();
        // the errata's figures: 0.1 % of e at 0.05, 0.7 % at 0.13
        let expected = 100.0 * 0.5 * corrected * corrected;
        assert!(difference.abs() < 3.0 * expected && difference.abs() > 0.0, "{row}");
    }
    let planes = printed["equation_17"].as_array().unwrap();
    assert!(planes.iter().all(|p| p["printed_least"].as_f64().unwrap() > 0.0), "{planes:?}");
    let table = bench.run(&["coefficients", "--as-printed"]).out;
    assert!(table.contains("K_baseline") && table.contains("%/K") && table.contains("no root"), "{table}");
}

#[test]
fn sensors_lists_what_find_sensor_finds() {
    let bench = Bench::new();
    let listed = lines(&bench.run(&["sensors", "--json"]).out).remove(0);
    let listed = listed.as_array().unwrap();
    assert!(listed.len() >= 3);
    for sensor in listed {
        assert!(truegap::predict::find_sensor(sensor["name"].as_str().unwrap(), None).is_ok());
    }
    assert!(bench.run(&["sensors"]).out.contains("singletact-s8-optimised"));
}

#[test]
fn quiet_keeps_notes_to_itself() {
    let bench = Bench::new();
    bench.file("r.csv", "time_s,force_n,capacitance_pf\n0,1,74\n1,1,75\n");
    let loud = bench.run(&["simulate", "--drive", "r.csv"]);
    assert!(loud.err.contains("note: ") && loud.code == 0, "{}", loud.err);
    let quiet = bench.run(&["simulate", "--drive", "r.csv", "--quiet"]);
    assert_eq!((quiet.err.as_str(), quiet.out), ("", loud.out));
}

/// Without options `--load` was asked for, and with it there was "no load that --load could give"; a profile needed "a column `Simulated`".
#[test]
fn a_model_that_follows_a_recorded_column_asks_for_a_recording_at_once() {
    let bench = Bench::new();
    bench.file("late.toml", common::LATE_SIMULATION);
    let asked = |more: &[&str], parts: &[&str]| bench.refuses(&[&["simulate", "--model", "late.toml"], more].concat(), parts);
    asked(&[], &["`external` follows the column `simulated`", "--drive RECORDING"]);
    asked(&["--load", "1 N"], &["`external` follows the column `simulated`", "--drive RECORDING"]);
    asked(&["--profile", "rates"], &["a profile has time, load and temperature alone", "--drive RECORDING"]);
    bench.file("cell.csv", "time_s,force_n,response_mv/v\n0,1,1\n1,2,2\n");
    asked(&["--drive", "cell.csv"], &["needs a column `simulated`"]);
}

/// Of a table with a planned load it was said that it had no `capacitance_pf`, which is what was asked for.
#[test]
fn a_history_to_follow_needs_no_response() {
    let bench = Bench::new();
    bench.file("plan.csv", "time_s,force_n,temperature_c\n0,1,20\n1,2,25\n2,1,30\n");
    bench.file("measured.csv", "time_s,force_n,temperature_c,capacitance_pf\n0,1,20,74\n1,2,25,75\n2,1,30,74\n");
    let along = |file: &str| bench.run(&["-q", "--json", "simulate", "--drive", file]);
    let (planned, measured) = (along("plan.csv"), along("measured.csv"));
    assert_eq!((planned.code, lines(&planned.out).len(), &planned.out), (0, 3, &measured.out), "{}", planned.err);
    bench.file("late.toml", common::LATE_SIMULATION);
    bench.file("simulated.csv", "time_s,simulated\n0,1\n1,2\n2,3\n");
    let followed = bench.run(&["-q", "--json", "simulate", "--model", "late.toml", "--drive", "simulated.csv"]);
    assert_eq!((followed.code, lines(&followed.out).len()), (0, 3), "{}", followed.err);
    bench.refuses(&["diagnose", "plan.csv", "--base", "stack"], &["no column for response: `capacitance_pf`"]);
}
