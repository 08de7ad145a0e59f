//! Recordings that something is wrong with: the tool says what, where and what to do, and never names physics on them.

#![allow(clippy::unwrap_used)]

mod common;

use common::Bench;
use serde_json::Value;
use truegap::core::{BaseSpec, Inputs, Recording, Simulator};
use truegap::model::{Stack, StackOptions};

/// Unit Gaussian numbers, always the same.
fn gaussian() -> impl FnMut() -> f64 {
    let mut state = 11u64;
    let mut uniform = move || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        ((state >> 11) as f64 + 0.5) / (1u64 << 53) as f64
    };
    move || (-2.0 * uniform().ln()).sqrt() * (std::f64::consts::TAU * uniform()).cos()
}

const SENSOR: &str = "singletact-s15-4.5n";
const NOISE_PF: f64 = 0.01;

/// Rest and two staircases up and down at a warming temperature, in two runs, on the default sensor, to which nothing is missing.
fn clean(full_load_n: f64) -> Recording {
    let sensor = truegap::predict::find_sensor(SENSOR, None).unwrap();
    let stack = Stack::new(&sensor, StackOptions::default());
    let rows = 29 * 15;
    let level = |row: usize| (10.0 - ((row / 15) as f64 - 18.0).abs()).max(0.0) / 10.0;
    let mut noise = gaussian();
    let inputs = Inputs {
        time_s: Some((0..2 * rows).map(|row| 0.5 * row as f64 + if row < rows { 0.0 } else { 120.0 }).collect()),
        run: (0..2 * rows).map(|row| 1 + u32::from(row >= rows)).collect(),
        force_n: Some((0..2 * rows).map(|row| full_load_n * level(row % rows) + 0.003 * noise()).collect()),
        temperature_c: Some((0..2 * rows).map(|row| 22.0 + 8.0 * row as f64 / 870.0 + 0.03 * noise()).collect()),
        ..Inputs::default()
    };
    let values: Vec<f64> = stack.parameters().iter().map(|p| p.centre()).collect();
    let response = stack.respond(&values, &inputs, &[]).unwrap().into_iter().map(|r| r + NOISE_PF * noise()).collect();
    let base = BaseSpec { model: "stack".into(), sensor: Some(SENSOR.into()), ..BaseSpec::default() };
    Recording::new(inputs, response, "pF", base).unwrap()
}

/// Diagnoses a recording: exit code and diagnosis.json.
fn diagnosed(recording: &Recording, further: &[&str]) -> (i32, Value) {
    let bench = Bench::new();
    std::fs::create_dir(bench.path("r")).unwrap();
    recording.write(bench.path("r")).unwrap();
    let said = bench.run(&[&["-q", "diagnose", "r/recording.toml", "-o", "out"], further].concat());
    let json = std::fs::read_to_string(bench.path("out/diagnosis.json"));
    let json = json.unwrap_or_else(|_| panic!("{}{}", said.out, said.err));
    let page = std::fs::read_to_string(bench.path("out/report.html")).unwrap();
    let json: Value = serde_json::from_str(&json).unwrap();
    for notice in json["notices"].as_array().unwrap() {
        let start: String = notice["says"].as_str().unwrap().chars().skip(1).take(30).collect();
        assert!(page.contains(&start), "the report does not say `{start}`");
        assert!(said.out.contains(&start), "the terminal does not say `{start}`");
    }
    (said.code, json)
}

/// What must be refused with exit code 2.
fn refused(recording: &Recording, parts: &[&str]) {
    let bench = Bench::new();
    std::fs::create_dir(bench.path("r")).unwrap();
    recording.write(bench.path("r")).unwrap();
    bench.refuses(&["-q", "diagnose", "r/recording.toml", "-o", "out"], parts);
}

/// A notice of this kind that says all `parts`.
fn says<'a>(diagnosis: &'a Value, kind: &str, parts: &[&str]) -> &'a Value {
    let notices = diagnosis["notices"].as_array().unwrap();
    let notice = notices.iter().find(|n| n["kind"] == kind).unwrap_or_else(|| panic!("no {kind}: {notices:?}"));
    let text = notice["says"].as_str().unwrap();
    parts.iter().for_each(|part| assert!(text.contains(part), "`{part}` is missing in: {text}"));
    notice
}

/// Nothing is named, because the recording cannot be trusted.
fn withheld(recording: &Recording, kind: &str, parts: &[&str], further: &[&str]) {
    let (code, diagnosis) = diagnosed(recording, further);
    says(&diagnosis, kind, parts);
    assert_eq!((code, diagnosis["verdict"].as_str().unwrap()), (1, "undecided"), "{}", diagnosis["says"]);
    for list in ["findings", "candidates", "ambiguity"] {
        assert_eq!(diagnosis[list].as_array().unwrap().len(), 0, "{list}: {}", diagnosis[list]);
    }
    assert!(diagnosis["says"].as_str().unwrap().starts_with("no physics is named"), "{}", diagnosis["says"]);
}

#[test]
fn a_clean_recording_has_no_notice_and_agrees() {
    let (code, diagnosis) = diagnosed(&clean(4.0), &[]);
    assert_eq!(diagnosis["notices"].as_array().unwrap().len(), 0, "{}", diagnosis["notices"]);
    assert_eq!((code, diagnosis["verdict"].as_str().unwrap()), (0, "agrees"), "{}", diagnosis["says"]);
}

#[test]
fn two_rows_are_refused() {
    refused(&clean(4.0).select(&[0, 300]), &["2 rows are too few", "at least 20"]);
}

#[test]
fn constant_inputs_are_refused() {
    let mut recording = clean(4.0);
    let noise: Vec<f64> = recording.inputs.temperature_c.as_ref().unwrap().iter().map(|t| 0.03 * (1e3 * t).sin()).collect();
    recording.inputs.force_n = Some(noise.iter().map(|n| 1.2 + 0.1 * n).collect());
    recording.inputs.temperature_c = Some(noise.iter().map(|n| 22.0 + n).collect());
    refused(&recording, &["force is 1.20 N in all 870 rows", "load cycle or a temperature sweep", "constant"]);
}

#[test]
fn a_dead_channel_is_refused() {
    let mut recording = clean(4.0);
    recording.response.fill(232.5);
    refused(&recording, &["232.5 pF in every row", "dead channel", "wiring"]);
}

#[test]
fn a_channel_that_dies_on_the_way_is_not_explained() {
    let mut recording = clean(4.0);
    let last = recording.response[520];
    recording.response[520..].fill(last);
    withheld(&recording, "dead_channel", &["rows 521 to 870", "350 rows", "wiring"], &[]);
}

#[test]
fn an_input_that_dies_on_the_way_is_not_explained() {
    let mut recording = clean(4.0);
    let force = recording.inputs.force_n.as_mut().unwrap();
    let last = force[620];
    force[620..].fill(last);
    withheld(&recording, "dead_input", &["force stays at exactly", " N in rows 621 to 870", "logger"], &[]);
}

#[test]
fn loads_beyond_full_scale_are_not_explained() {
    withheld(&clean(6.0), "out_of_range", &["force goes outside", "0 to 4.50 N", "6.0", "row ", "leave these rows out"], &[]);
    let mut pulled = clean(4.0);
    pulled.inputs.force_n.as_mut().unwrap().iter_mut().for_each(|f| *f = -*f);
    withheld(&pulled, "out_of_range", &["-4.0", "sign and the tare"], &[]);
}

#[test]
fn a_temperature_in_another_unit_is_not_explained() {
    let warmer = |by: f64| {
        let mut recording = clean(4.0);
        recording.inputs.temperature_c.as_mut().unwrap().iter_mut().for_each(|t| *t += by);
        recording
    };
    withheld(&warmer(-80.0), "out_of_range", &["-40 to 125 °C", "-58.", "unit of the column"], &[]);
    // kelvins, so hot that the model has no answer any more
    refused(&warmer(273.15), &["r/recording.toml", "-40 to 125 °C", "303.", "unit of the column"]);
}

#[test]
fn another_sensor_is_not_explained() {
    withheld(
        &clean(2.0),
        "wrong_sensor",
        &["does not look like this sensor", "pF", "--sensor"],
        &["--sensor", "singletact-s8-optimised"],
    );
    let mut femto = clean(4.0);
    femto.response.iter_mut().for_each(|r| *r *= 1e3);
    withheld(&femto, "wrong_sensor", &["power of a thousand", "unit"], &[]);
}

/// What a logger leaves out or writes twice stopped the program, a row at a time; frames with the same holes were read.
#[test]
fn empty_cells_and_repeated_times_are_counted_and_told() {
    let bench = Bench::new();
    std::fs::create_dir(bench.path("r")).unwrap();
    clean(4.0).write(bench.path("r")).unwrap();
    let text = std::fs::read_to_string(bench.path("r/recording.csv")).unwrap();
    let mut lines: Vec<String> = text.lines().map(str::to_owned).collect();
    for line in [40, 41, 300] {
        let (head, _) = lines[line].rsplit_once(',').unwrap();
        lines[line] = format!("{head},");
    }
    lines.insert(200, lines[199].clone());
    bench.file("r/recording.csv", &(lines.join("\n") + "\n"));
    let said = bench.run(&["diagnose", "r/recording.toml", "-o", "out"]);
    assert_eq!(said.code, 0, "{}{}", said.out, said.err);
    let json: Value = serde_json::from_str(&std::fs::read_to_string(bench.path("out/diagnosis.json")).unwrap()).unwrap();
    assert_eq!((json["verdict"].as_str(), json["recording"]["rows"].as_u64()), (Some("agrees"), Some(867)));
    for told in ["3 rows without a value in", "the first on line 41", "1 row has the time of the row before, on line 201"] {
        assert!(said.err.contains(told), "`{told}` is missing in: {}", said.err);
        assert!(json["recording_issues"].to_string().contains(told), "`{told}` is missing in: {}", json["recording_issues"]);
    }
}

#[test]
fn a_clock_that_stands_more_often_than_it_goes_is_refused() {
    let bench = Bench::new();
    let rows: String = (0..40).map(|i| format!("{},{},{}\n", i / 4, 0.1 * f64::from(i), 232.0 + 0.05 * f64::from(i))).collect();
    bench.file("r.csv", &format!("time_s,force_n,capacitance_pf\n{rows}"));
    let parts = ["30 of 40 rows have the time of the row before", "line 3", "average the rows"];
    bench.refuses(&["-q", "diagnose", "r.csv", "-o", "out"], &parts);
}

#[test]
fn a_gap_is_told_and_no_physics_is_made_of_it() {
    let mut recording = clean(4.0);
    recording.inputs.time_s.as_mut().unwrap()[200..].iter_mut().for_each(|t| *t += 3600.0);
    let (_, diagnosis) = diagnosed(&recording, &[]);
    says(&diagnosis, "gap", &["60.0 min", "row 201", "usual step is 500 ms", "new run"]);
    assert_eq!(diagnosis["verdict"], "agrees", "{}", diagnosis["says"]);
}

#[test]
fn outliers_are_left_out_and_no_physics_is_made_of_them() {
    let mut recording = clean(4.0);
    for (row, by) in [(40, 3.0), (222, -2.0), (223, -2.2), (500, 8.0), (731, 1.5)] {
        recording.response[row] += by;
    }
    let (code, diagnosis) = diagnosed(&recording, &[]);
    let notice = says(&diagnosis, "outliers", &["5 readings", "row 41 (t = 20.0 s)", "pF", "left out", "loose contact"]);
    assert_eq!(notice["rows"], serde_json::json!([[41, 41], [223, 224], [501, 501], [732, 732]]));
    assert_eq!((code, diagnosis["verdict"].as_str().unwrap()), (1, "agrees"), "{}", diagnosis["says"]);
    assert_eq!(diagnosis["recording"]["rows"], 865);
}

#[test]
fn too_many_outliers_are_not_explained() {
    let mut recording = clean(4.0);
    (10..860).step_by(12).for_each(|row| recording.response[row] += 4.0);
    withheld(&recording, "outliers", &["too many for a channel that works", "record again"], &[]);
}

#[test]
fn clipped_rows_are_left_out_and_what_the_model_says_of_them_tells_the_ceiling() {
    let mut recording = clean(4.0);
    let greatest = recording.response.iter().copied().fold(f64::MIN, f64::max);
    let least = recording.response.iter().copied().fold(f64::MAX, f64::min);
    let rail = least + 0.8 * (greatest - least);
    recording.response.iter_mut().for_each(|r| *r = r.min(rail));
    let (code, diagnosis) = diagnosed(&recording, &[]);
    says(&diagnosis, "clipped", &["never goes above", "pF", "left out", "Widen the range"]);
    assert_eq!((code, diagnosis["verdict"].as_str()), (1, Some("explained")), "{}", diagnosis["says"]);
    let findings = diagnosis["findings"].as_array().unwrap();
    assert_eq!(findings.len(), 1, "{findings:?}");
    assert_eq!(findings[0]["effect"], "saturation");
    assert!(diagnosis["probability_agrees"].as_f64().unwrap() < 0.1, "{}", diagnosis["probability_agrees"]);
    let on_rail = &findings[0]["held_out"];
    assert!(on_rail["rmse_after"].as_f64().unwrap() < 0.1 * on_rail["rmse_before"].as_f64().unwrap(), "{on_rail}");
}

#[test]
fn many_clipped_readings_are_explained_by_saturation_or_not_at_all() {
    let mut recording = clean(4.0);
    let (low, high) = recording.response.iter().fold((f64::MAX, f64::MIN), |(l, h), r| (l.min(*r), h.max(*r)));
    let rail = low + 0.2 * (high - low);
    recording.response.iter_mut().for_each(|r| *r = r.min(rail));
    let (code, diagnosis) = diagnosed(&recording, &[]);
    says(&diagnosis, "clipped", &["never goes above", "pF", "rows", "Widen the range"]);
    assert_eq!(code, 1);
    let named: Vec<&str> = diagnosis["findings"].as_array().unwrap().iter().map(|f| f["effect"].as_str().unwrap()).collect();
    assert!(named.iter().all(|effect| *effect == "saturation"), "{named:?}");
    assert!(diagnosis["candidates"].as_array().unwrap().iter().all(|c| c["effect"] == "saturation"));
    println!("{} {named:?}", diagnosis["says"]);
}
