//! Everything that a user may get wrong: file, line, value, remedy, exit code 2, nothing left behind.

#![allow(clippy::unwrap_used)]

mod common;

use common::Bench;

const DRIVE: &[&str] = &["simulate", "--drive", "r.csv"];
const DRIVE_TOML: &[&str] = &["simulate", "--drive", "r.toml"];

/// A recording that the tool must refuse, and what it must say.
fn refuse_csv(text: &str, parts: &[&str]) {
    let bench = Bench::new();
    bench.file("r.csv", text);
    let parts: Vec<&str> = ["r.csv"].iter().chain(parts).copied().collect();
    bench.refuses(DRIVE, &parts);
}

#[test]
fn a_missing_column_is_named_with_those_that_are_there() {
    let bench = Bench::new();
    bench.file("r.csv", "time_s,force_n\n0,1\n");
    bench.refuses(&["diagnose", "r.csv"], &["r.csv", "response", "`capacitance_pf`", "`time_s`, `force_n`", "[columns]"]);
}

#[test]
fn a_history_without_force_does_not_drive_a_sensor() {
    refuse_csv("time_s,capacitance_pf\n0,74\n1,75\n", &["force", "singletact-s15-4.5n", "[columns]"]);
}

#[test]
fn text_in_a_number_column_is_named() {
    refuse_csv("time_s,force_n,capacitance_pf\n0,1,74\n1,heavy,75\n", &["line 3", "`heavy`", "`force_n`", "leave the row out"]);
}

#[test]
fn time_running_backwards_is_named() {
    refuse_csv("time_s,force_n,capacitance_pf\n0,1,74\n5,1,74\n4,1,75\n", &["line 4", "from 5 s to 4 s", "start a new run"]);
}

#[test]
fn an_empty_file_and_a_header_alone_are_named() {
    refuse_csv("", &["empty", "header"]);
    refuse_csv("time_s,force_n,capacitance_pf\n", &["no row", "record something"]);
}

#[test]
fn a_column_that_is_mostly_empty_is_named() {
    refuse_csv("time_s,force_n,capacitance_pf\n0,1,74\n1,NaN,75\n2,,76\n", &["2 of 3 rows", "line 3", "`force_n`", "fill"]);
    refuse_csv("time_s,force_n,capacitance_pf\n0,1,\n", &["1 of 1 rows", "line 2", "`capacitance_pf`"]);
}

#[test]
fn a_wrong_unit_is_named_with_those_that_would_do() {
    let bench = Bench::new();
    bench.file("r.csv", "time_s,load,capacitance_pf\n0,1,74\n");
    let toml = |unit: &str| {
        format!("schema = \"truegap.recording/1\"\nfile = \"r.csv\"\n[columns]\nforce = \"load\"\n[units]\nforce = \"{unit}\"\n")
    };
    bench.file("r.toml", &toml("kPa"));
    bench.refuses(DRIVE_TOML, &["r.toml", "line 6", "`kPa`", "mN, kN"]);
    bench.refuses(&["simulate", "--load", "4.5 kPa"], &["`kPa`", "mN, kN"]);
    bench.refuses(&["simulate", "--load", "4.5"], &["`4.5` has no unit", "mN, kN"]);
    bench.refuses(&["simulate", "--load", "1 N", "--temperature", "50 bar"], &["`bar`", "degC"]);
}

#[test]
fn an_unknown_key_and_another_schema_are_named() {
    let bench = Bench::new();
    bench.file("r.csv", "time_s,force_n,capacitance_pf\n0,1,74\n");
    bench.file("r.toml", "schema = \"truegap.recording/1\"\nfile = \"r.csv\"\n[colums]\nforce = \"load\"\n");
    bench.refuses(DRIVE_TOML, &["r.toml", "line 3", "colums", "columns"]);
    bench.file("r.toml", "schema = \"truegap.case/1\"\nfile = \"r.csv\"\n");
    bench.refuses(DRIVE_TOML, &["r.toml", "line 1", "truegap.case/1", "truegap.recording/1"]);
}

#[test]
fn a_file_that_is_not_there_is_named() {
    Bench::new().refuses(&["simulate", "--drive", "nowhere.toml"], &["nowhere.toml", "no such file"]);
}

/// The built-in sensor with one line changed.
fn changed_sensor(from: &str, to: &str) -> String {
    let built_in = truegap::core::sensor::builtin_sensors()[0].toml;
    assert!(built_in.contains(from), "the built-in sensor no longer says `{from}`");
    built_in.replace(from, to)
}

#[test]
fn a_negative_thickness_is_named() {
    let bench = Bench::new();
    bench.file("s.toml", &changed_sensor("height = \"162 um +- 5 um\"", "height = \"-162 um\""));
    for command in ["simulate", "coefficients"] {
        let load: &[&str] = if command == "simulate" { &["--load", "1 N"] } else { &[] };
        bench.refuses(
            &[&[command, "--sensor", "s.toml"], load].concat(),
            &["s.toml, line", "`dielectric.height`: -162 um ", "greater than 0"],
        );
    }
}

#[test]
fn beads_that_cover_more_than_the_electrode_are_named() {
    let bench = Bench::new();
    bench.file("s.toml", &changed_sensor("count = 65", "count = 6500"));
    bench.refuses(&["coefficients", "--sensor", "s.toml"], &["s.toml, line", "6500 beads", "mm2", "fewer or smaller"]);
}

#[test]
fn a_load_that_closes_the_gap_is_named() {
    let bench = Bench::new();
    bench.refuses(&["simulate", "--load", "1 N, 4.5 kN"], &["4500 N", "20 degC", "closes the gap", "stay below"]);
    bench.file("r.csv", "time_s,force_n,capacitance_pf\n0,1,74\n1,9000,75\n");
    bench.refuses(DRIVE, &["r.csv", "row 2", "9000 N", "closes the gap"]);
}

#[test]
fn an_unknown_sensor_is_answered_with_the_nearest() {
    let bench = Bench::new();
    bench.refuses(&["coefficients", "--sensor", "singletact-s15-45n"], &["did you mean", "`singletact-s15-4.5n`"]);
    bench.refuses(&["coefficients", "--sensor", "mine.toml"], &["mine.toml", "cannot be read", "truegap sensors"]);
}

#[test]
fn arguments_that_clap_refuses_end_with_2_as_well() {
    let bench = Bench::new();
    for arguments in
        [&["simulate"][..], &["simulate", "--load", "1 N", "--drive", "x"], &["nonsense"], &["coefficients", "--series", "wrong"]]
    {
        assert_eq!(bench.run(arguments).code, 2, "{arguments:?}");
    }
}

/// What `diagnose -o` must refuse without leaving a folder.
fn refuse_diagnosis(name: &str, parts: &[&str], files: &[(&str, &str)]) {
    let bench = Bench::new();
    files.iter().for_each(|(file, text)| {
        bench.file(file, text);
    });
    // notes are not errors: -q keeps them apart; a CSV by itself does not say which sensor it is of
    let sensor: &[&str] = if name.ends_with(".csv") { &["--sensor", "singletact-s15-4.5n"] } else { &[] };
    bench.refuses(&[&["-q", "diagnose", name, "-o", "out"], sensor].concat(), parts);
}

#[test]
fn a_diagnosis_of_a_bad_csv_leaves_no_folder() {
    let cases: [(&str, &[&str]); 8] = [
        ("", &["r.csv", "empty", "header"]),
        ("time_s,force_n,capacitance_pf\n", &["r.csv", "no row", "record something"]),
        ("time_s,force_n\n0,1\n", &["r.csv", "`capacitance_pf`", "[columns]"]),
        (
            "time_s,force_n,capacitance_pf\n0,1,74\n1,heavy,75\n",
            &["r.csv", "line 3", "`heavy`", "`force_n`", "leave the row out"],
        ),
        ("time_s,force_n,capacitance_pf\n0,1,74\n5,1,74\n4,1,75\n", &["r.csv", "line 4", "from 5 s to 4 s", "start a new run"]),
        ("time_s,force_n,capacitance_pf\n0,1,74\n1,NaN,75\n2,,76\n", &["r.csv", "2 of 3 rows", "line 3", "`force_n`"]),
        ("time_s,force_n,capacitance_pf\n0,1,\n", &["r.csv", "line 2", "`capacitance_pf`", "rename it"]),
        ("time_s,force_n,capacitance_pf\n0,1,74\n1,1,75\n", &["r.csv", "2 rows are too few", "at least"]),
    ];
    for (text, parts) in cases {
        refuse_diagnosis("r.csv", parts, &[("r.csv", text)]);
    }
    refuse_diagnosis("nowhere.csv", &["nowhere.csv", "no such file"], &[]);
}

/// Three hundred rows that the paper's sensor could have recorded, but for the load of the last one.
fn ramp(last_n: f64) -> String {
    let rows = (0..300).map(|row| {
        let force = if row == 299 { last_n } else { 4.5 * f64::from(row) / 299.0 };
        format!("{row},{force:.4},{:.4}\n", 75.0 + 2.0 * force.min(4.5))
    });
    "time_s,force_n,capacitance_pf\n".to_owned() + &rows.collect::<String>()
}

fn manifest(base: &str) -> String {
    format!("schema = \"truegap.recording/1\"\nfile = \"r.csv\"\n{base}")
}

#[test]
fn a_load_without_a_sensor_or_a_base_is_asked_what_it_acted_on() {
    let bench = Bench::new();
    bench.file("r.csv", &ramp(4.5));
    let parts = [
        "r.csv",
        "force = `force_n`",
        "--sensor NAME",
        "singletact-s15-4.5n",
        "--base parallel-plate",
        "--base linear",
        "[base]",
    ];
    bench.refuses(&["-q", "diagnose", "r.csv", "-o", "out"], &parts);
    bench.file("p.csv", &ramp(4.5).replace("force_n,capacitance_pf", "pressure_kpa,response_counts"));
    bench.refuses(&["-q", "diagnose", "p.csv", "-o", "out"], &["p.csv", "pressure = `pressure_kpa`", "--base parallel-plate"]);
}

#[test]
fn a_column_called_after_a_role_in_another_unit_is_not_dropped() {
    for (header, unit) in [("force_pa", "pa"), ("force_xyz", "xyz"), ("Temperature [bar]", "bar")] {
        let text = ramp(4.5).replace("force_n", header);
        refuse_diagnosis(
            "r.csv",
            &["r.csv", header, &format!("`{unit}` is no unit"), "rename", "[columns]"],
            &[("r.csv", &text)],
        );
    }
}

#[test]
fn the_place_of_the_answer_is_checked_before_the_work_begins() {
    let bench = Bench::new();
    bench.file("out", "mine");
    std::fs::create_dir(bench.path("full")).unwrap();
    bench.file("full/thesis.tex", "mine");
    // the recording is not even there: the folder is looked at first
    for (folder, parts) in [
        ("out", ["out", "there is a file"]),
        ("out/deeper", ["out", "there is a file"]),
        ("full", ["thesis.tex", "would be lost"]),
    ] {
        bench.refuses(&["-q", "diagnose", "nowhere.csv", "-o", folder], &parts);
    }
}

#[test]
fn a_diagnosis_with_a_wrong_unit_or_an_unknown_model_leaves_no_folder() {
    let csv = ramp(4.5);
    let bad = [
        ("[units]\nforce = \"kPa\"\n", &["r.toml", "line 4", "`kPa`", "mN, kN"][..]),
        ("[base]\nmodel = \"stak\"\n", &["r.toml", "`stak`", "stack"]),
        ("[base]\nmodel = \"stack\"\nsensor = \"nowhere.toml\"\n", &["r.toml", "nowhere.toml", "cannot be read"]),
    ];
    for (base, parts) in bad {
        refuse_diagnosis("r.toml", parts, &[("r.csv", &csv), ("r.toml", &manifest(base))]);
    }
}

#[test]
fn a_diagnosis_with_an_impossible_sensor_leaves_no_folder() {
    let csv = ramp(4.5);
    let toml = manifest("[base]\nmodel = \"stack\"\nsensor = \"s.toml\"\n");
    let bad = [
        (
            "height = \"162 um +- 5 um\"",
            "height = \"-162 um\"",
            &["s.toml, line", "`dielectric.height`: -162 um ", "greater than 0"][..],
        ),
        ("count = 65", "count = 6500", &["s.toml, line", "6500 beads", "mm2", "fewer or smaller"]),
    ];
    for (from, to, parts) in bad {
        refuse_diagnosis("r.toml", parts, &[("r.csv", &csv), ("r.toml", &toml), ("s.toml", &changed_sensor(from, to))]);
    }
}

#[test]
fn a_diagnosis_of_a_load_that_closes_the_gap_leaves_no_folder() {
    let parts = ["r.csv, row 300", "9000 N", "closes the gap of `singletact-s15-4.5n`", "leave the row out"];
    refuse_diagnosis("r.csv", &parts, &[("r.csv", &ramp(9000.0))]);
}

#[test]
fn a_diagnosis_does_not_overwrite_what_it_did_not_write() {
    let bench = Bench::new();
    bench.file("out", "mine").file("r.csv", &ramp(4.5));
    bench.refuses(&["-q", "diagnose", "r.csv", "-o", "out"], &["out", "file of this name", "-o"]);
    assert_eq!(std::fs::read_to_string(bench.path("out")).unwrap(), "mine");
}

/// Only names were compared: a page of the user's own, called as ours, was replaced without a word.
#[test]
fn no_command_replaces_a_page_that_truegap_did_not_write() {
    let bench = Bench::new();
    std::fs::create_dir(bench.path("mine")).unwrap();
    bench.file("mine/report.html", "mine").file("r.csv", &ramp(4.5));
    let sensor = ["--sensor", "singletact-s15-4.5n"];
    let commands: [&[&str]; 5] = [
        &["diagnose", "r.csv", sensor[0], sensor[1]],
        &["audit"],
        &["sensitivity", "--rows", "64"],
        &["tolerance", "--samples", "64"],
        &["optimise", "--searches", "1"],
    ];
    for command in commands {
        let typed = [&["-q"], command, &["-o", "mine"]].concat();
        bench.refuses(&typed, &["mine", "`report.html`", "would be lost", "-o"]);
        assert_eq!(std::fs::read_to_string(bench.path("mine/report.html")).unwrap(), "mine", "{command:?}");
    }
}

/// An empty sketch was written, with a word of no column, and exit code 0.
#[test]
fn a_header_without_rows_is_not_sketched() {
    let bench = Bench::new();
    bench.file("r.csv", "time_s,force_n,capacitance_pf\n");
    bench.refuses(&["init", "r.csv"], &["r.csv", "there is no row below the header"]);
}

/// What was edited by hand passed, or was told without the name of its file.
#[test]
fn a_model_file_that_was_edited_is_refused_by_its_name() {
    let bench = Bench::new();
    bench.file("r.csv", "time_s,simulated,response_mV\n0,1,1\n1,2,2\n");
    let simulate = &["-q", "simulate", "--model", "late.toml", "--drive", "r.csv"];
    let cases: [(&str, &str, &[&str]); 7] = [
        ("sd = 0.05", "sd = -0.05", &["the sd of `tau` of readout_lag is -0.05", "from 0 on"]),
        ("verdict = \"explained\"", "verdict = \"splendid\"", &["verdict = \"splendid\" is none", "explained", "undecided"]),
        ("noise_sd = 0.002", "noise_sd = 0.002\nnoise_sdd = 1", &["[scales] has no key `noise_sdd`", "did you mean `noise_sd`"]),
        ("sd = 0.05", "sd = 0.05\nsdd = 1", &["[effect.parameters] has no key `sdd`", "did you mean `sd`"]),
        ("offset = true", "ofset = true\noffset = true", &["[base.options] has no key `ofset`", "did you mean `offset`"]),
        ("reference_c = 20.0", "reference_c = -500", &["reference_c = -500", "not below -273.15"]),
        ("value = 2.0", "value = -2.0", &["`tau` of readout_lag is -2"]),
    ];
    for (from, to, parts) in cases {
        bench.file("late.toml", &common::LATE_SIMULATION.replacen(from, to, 1));
        let said = bench.refuses(simulate, &[&["error: late.toml: "], parts].concat());
        assert!(!said.contains("the model file: "), "{said}");
    }
    bench.file("late.toml", common::LATE_SIMULATION);
    assert_eq!(bench.run(simulate).code, 0);
}

/// It was answered without the effect, as if nothing were missing.
#[test]
fn a_model_that_follows_the_temperature_is_not_driven_without_it() {
    let bench = Bench::new();
    let effect = "[[effect]]\nid = \"temperature_coefficient\"\nparameters = [{ name = \"per_kelvin\", unit = \"mV/V/K\", value = 0.1, sd = 0.01 }, \
                  { name = \"bend\", unit = \"1/K\", value = 0.0, sd = 0.01 }]\n";
    let (head, _) = common::LATE_SIMULATION.split_once("[[effect]]").unwrap();
    bench.file("warm.toml", &format!("{head}{effect}"));
    bench.file("cold.csv", "time_s,simulated\n0,1\n1,2\n").file("r.csv", "time_s,simulated,temperature_c\n0,1,20\n1,2,30\n");
    let words = ["cold.csv", "no column for temperature", "`temperature_coefficient` needs", "--map temperature=COLUMN"];
    bench.refuses(&["-q", "simulate", "--model", "warm.toml", "--drive", "cold.csv"], &words);
    let said = bench.run(&["simulate", "--model", "warm.toml", "--drive", "r.csv"]);
    assert_eq!(said.code, 0, "{}", said.err);
}

/// The diagnosis went through, and the recording that was to judge it was refused at its end; alone, it was told of its temperature.
#[test]
fn one_row_judges_nothing() {
    let bench = Bench::new();
    let row = |i: usize| format!("{i},{},{}\n", (i as f64 / 9.0).sin(), 74.0 + (i as f64 / 9.0).sin());
    let rows: String = (0..40).map(row).collect();
    bench.file("r.csv", &format!("time_s,simulated,bridge_mv\n{rows}")).file("one.csv", "time_s,simulated,bridge_mv\n0,1,74\n");
    bench.file("late.toml", common::LATE_SIMULATION);
    let map = ["--map", "response=bridge_mv:mV/V"];
    let words = ["one.csv: 1 row is too few", "at least 20"];
    let diagnose = ["-q", "diagnose", "r.csv", "--base", "external", "--confirm", "one.csv", "-o", "out"];
    bench.refuses(&[&diagnose[..], &map].concat(), &words);
    bench.refuses(&[&["-q", "confirm", "late.toml", "one.csv"][..], &map].concat(), &words);
}
