//! Bases of the user's own, end to end: a simulated column, a line, a table, and recordings with hardly anything in them.

#![allow(clippy::unwrap_used)]

#[path = "common/noise.rs"]
mod noise;

use noise::noise;
use std::sync::atomic::AtomicBool;
use truegap::core::Recording;
use truegap::diagnose::answer::{Diagnosis, Verdict};
use truegap::diagnosis::{Diagnosed, Request, diagnose, open};

/// A recording as a user has it, in a folder of its own.
fn recorded(base: &str, header: &str, rows: usize, row: impl FnMut(usize) -> Vec<f64>) -> (tempfile::TempDir, Recording) {
    let folder = tempfile::tempdir().unwrap();
    let line = |values: Vec<f64>| values.iter().map(|v| format!("{v:.6}")).collect::<Vec<_>>().join(",") + "\n";
    let rows: String = (0..rows).map(row).map(line).collect();
    std::fs::write(folder.path().join("r.csv"), format!("{header}\n{rows}")).unwrap();
    // C = 10 + F + 0.05 (T - 20), at the corners of what is recorded
    std::fs::write(
        folder.path().join("table.csv"),
        "force_n,temperature_c,response_mv\n0,20,10\n5,20,15\n0,30,10.5\n5,30,15.5\n",
    )
    .unwrap();
    let toml = format!("schema = \"truegap.recording/1\"\nfile = \"r.csv\"\n[base]\n{base}");
    std::fs::write(folder.path().join("r.toml"), toml).unwrap();
    let recording = Recording::open(folder.path().join("r.toml")).unwrap();
    (folder, recording)
}

fn diagnosed(recording: Recording) -> Diagnosed {
    let request = Request::default();
    let files = vec![("r.csv".to_owned(), recording.sha256.clone())];
    let opened = open(vec![recording], &request).unwrap();
    let diagnosed = diagnose(opened, files, &request, &|_| (), &AtomicBool::new(false)).unwrap();
    // page and model file have words for every base
    assert!(truegap::diagnosis::report::html(&diagnosed.subject()).contains("Base model"));
    let model = diagnosed.model_file().unwrap().to_toml().unwrap();
    assert!(model.contains("[base]"), "{model}");
    diagnosed
}

fn named(diagnosis: &Diagnosis) -> Vec<&str> {
    diagnosis.findings.iter().map(|f| f.effect.as_str()).collect()
}

/// A thermometer beside a room that warms and cools, 2.6 K off and a minute and a half behind: what its simulation leaves out is the lag, the offset is
/// calibrated.
#[test]
fn a_simulated_thermometer_is_found_to_lag() {
    let (mut noise, mut inside) = (noise(1), 20.0);
    let row = |i: usize| {
        let room = 18.0 + 4.0 * (i as f64 / 60.0).sin() + 2.0 * (i as f64 / 23.0).cos();
        inside += (room - inside) / 9.0;
        vec![10.0 * i as f64, room, room, inside + 2.6 + 0.02 * noise()]
    };
    let (_folder, recording) = recorded("model = \"external\"\n", "time_s,temperature_c,simulated,response_degC", 720, row);
    let diagnosis = diagnosed(recording).outcome.diagnosis;
    assert_eq!(diagnosis.base.parameters.iter().map(|p| p.name.as_str()).collect::<Vec<_>>(), ["offset"]);
    let offset = diagnosis.base.parameters[0].value;
    assert!((offset - 2.6).abs() < 0.05, "{offset}");
    // where the simulation is the room's temperature itself, a late temperature and a late reading are one and the same
    let lags = ["thermal_lag", "readout_lag"];
    assert!(!named(&diagnosis).is_empty() && named(&diagnosis).iter().all(|effect| lags.contains(effect)), "{}", diagnosis.says);
    let told = diagnosis.ambiguity.iter().flatten().map(String::as_str).chain(named(&diagnosis));
    assert!(told.into_iter().any(|effect| effect == "thermal_lag"), "{}", diagnosis.says);
    assert!(diagnosis.fit.in_sample.rmse_after < 0.025, "{}", diagnosis.fit.in_sample.rmse_after);
}

#[test]
fn a_simulation_that_may_not_be_adjusted_has_no_parameters_and_is_diagnosed() {
    let mut noise = noise(1);
    let row = |i: usize| {
        let simulated = 5.0 + (i as f64 / 40.0).sin();
        vec![i as f64, simulated, simulated + 0.01 * noise()]
    };
    let (_folder, recording) = recorded("model = \"external\"\nfree = []\n", "time_s,simulated,response_v", 600, row);
    let diagnosis = diagnosed(recording).outcome.diagnosis;
    assert!(diagnosis.base.parameters.is_empty());
    assert_eq!((diagnosis.verdict, diagnosis.findings.len()), (Verdict::Agrees, 0), "{}", diagnosis.says);
}

/// Gain 1.2 and offset 0.4 against the simulation, and nothing else.
/// A pump that slips by its outlet pressure, which its simulation does not know: the column was not looked at, and recording and model were said to agree.
#[test]
fn a_pressure_that_no_base_follows_is_a_driver_there_and_in_another_recording() {
    let pumped = |seed: u64, start: usize| {
        let mut noise = noise(seed);
        let row = move |i: usize| {
            let flow = 8.0 + ((i + start) / 40 * 29 % 7) as f64 / 2.0;
            let bar = 3.0 + 2.0 * ((i + start) as f64 / 31.0).sin();
            vec![i as f64, 1e5 * bar, flow, flow - 0.06 * bar + 0.02 * noise()]
        };
        recorded("model = \"external\"\n", "time_s,pressure_pa,simulated,response_v", 600, row)
    };
    let (_folder, recording) = pumped(12, 0);
    let found = diagnosed(recording);
    let diagnosis = &found.outcome.diagnosis;
    assert_eq!(named(diagnosis), ["driver_coefficient"], "{}", diagnosis.says);
    // 0.06 a bar
    let size = &diagnosis.findings[0].parameters[0];
    assert!((size.value + 6e-7).abs() < 4.0 * size.sd && size.unit == "V/Pa", "{size:?}");
    let (folder, other) = pumped(13, 200);
    let file = folder.path().join("augmented.toml");
    std::fs::write(&file, found.model_file().unwrap().to_toml().unwrap()).unwrap();
    let free = truegap::diagnosis::confirm::Free { gain: false, offset: false, clock: false };
    let said = truegap::diagnosis::confirm::confirm(&file, other, None, free).unwrap().document;
    assert_eq!(said.verdict, truegap::diagnose::confirmation::Judgement::Confirmed, "{}", said.says);
}

#[test]
fn a_gain_that_is_allowed_is_calibrated() {
    let mut noise = noise(1);
    let row = |i: usize| {
        let simulated = 5.0 + (i as f64 / 40.0).sin();
        vec![i as f64, simulated, 0.4 + 1.2 * simulated + 0.01 * noise()]
    };
    let (_folder, recording) =
        recorded("model = \"external\"\ngain = true\noffset = true\n", "time_s,simulated,response_v", 600, row);
    let diagnosis = diagnosed(recording).outcome.diagnosis;
    let value = |name: &str| diagnosis.base.parameters.iter().find(|p| p.name == name).unwrap().value;
    assert!((value("gain") - 1.2).abs() < 0.01 && (value("offset") - 0.4).abs() < 0.05, "{} {}", value("gain"), value("offset"));
    assert_eq!(diagnosis.verdict, Verdict::Agrees, "{}", diagnosis.says);
}

/// A simulation that is no prediction of the reading but of something that it follows: the gain is -3 mV for each g/m3, far from 1.
#[test]
fn a_gain_between_two_units_is_calibrated_from_the_recording_alone() {
    let mut noise = noise(1);
    let row = |i: usize| {
        let vapour = 5.0 + (i as f64 / 40.0).sin();
        vec![i as f64, vapour, 0.4 - 0.003 * vapour + 3e-5 * noise()]
    };
    let base = "model = \"external\"\nfree = [\"gain\", \"offset\"]\n[units]\nsimulated = \"g/m3\"\n";
    let (_folder, recording) = recorded(base, "time_s,simulated,response_v", 600, row);
    let diagnosed = diagnosed(recording);
    let diagnosis = &diagnosed.outcome.diagnosis;
    let gain = diagnosis.base.parameters.iter().find(|p| p.name == "gain").unwrap();
    assert!((gain.value + 0.003).abs() < 1e-5, "{}", gain.value);
    assert_eq!((diagnosis.verdict, gain.unit.as_str()), (Verdict::Agrees, "V per g/m3"), "{}", diagnosis.says);
    let model = diagnosed.model_file().unwrap().to_toml().unwrap();
    assert!(model.contains("own_unit = \"g/m3\""), "{model}");
}

fn force(i: usize) -> f64 {
    5.0 * (1.0 - ((i % 200) as f64 / 100.0 - 1.0).abs())
}

#[test]
fn a_load_cell_that_is_a_line_agrees_with_one() {
    let mut noise = noise(1);
    let row = |i: usize| vec![0.5 * i as f64, force(i), 2.0 + 0.8 * force(i) + 0.005 * noise()];
    let (_folder, recording) = recorded("model = \"linear\"\n", "time_s,force_n,response_mv", 800, row);
    let diagnosis = diagnosed(recording).outcome.diagnosis;
    assert_eq!((diagnosis.verdict, diagnosis.findings.len()), (Verdict::Agrees, 0), "{}", diagnosis.says);
    let value = |name: &str| diagnosis.base.parameters.iter().find(|p| p.name == name).unwrap().value;
    assert!(
        (value("offset") - 2.0).abs() < 0.01 && (value("slope") - 4.0).abs() < 0.02,
        "{} {}",
        value("offset"),
        value("slope")
    );
}

/// A spring on a piston, followed by its recorded position: nothing under [columns] drives it, and the line is taken along `[drivers]`, by name or because
/// nothing else moves.
#[test]
fn a_line_follows_a_named_driver() {
    for driver in ["driver = \"position\"\n", ""] {
        let mut noise = noise(1);
        let row = |i: usize| vec![0.5 * i as f64, 10.0 + 6.0 * force(i), 2.0 + 0.04 * (10.0 + 6.0 * force(i)) + 0.005 * noise()];
        let drivers = "[drivers]\nposition = { column = \"position_mm\", unit = \"mm\" }\n";
        let base = format!("model = \"linear\"\n{driver}{drivers}");
        let (_folder, recording) = recorded(&base, "time_s,position_mm,response_mv", 800, row);
        let diagnosed = diagnosed(recording);
        let file = diagnosed.model_file().unwrap();
        assert_eq!(truegap::models::ModelFile::parse(&file.to_toml().unwrap(), "m.toml".as_ref()).unwrap(), file);
        let diagnosis = diagnosed.outcome.diagnosis;
        assert_eq!((diagnosis.verdict, diagnosis.findings.len()), (Verdict::Agrees, 0), "{}", diagnosis.says);
        let value = |name: &str| diagnosis.base.parameters.iter().find(|p| p.name == name).unwrap().value;
        let followed = diagnosis.not_testable.iter().find(|n| n.effect == "driver_coefficient").unwrap();
        assert!(followed.says.contains("follows this driver by itself"), "{}", followed.says);
        // over 30 mm from 10 mm on: 2.4 + 1.2 u
        assert!(
            (value("offset") - 2.4).abs() < 0.005 && (value("slope") - 1.2).abs() < 0.01,
            "{} {}",
            value("offset"),
            value("slope")
        );
    }
}

/// A temperature coefficient of the zero, 0.03 mV/K, beside a table that has 0.05 mV/K of its own.
#[test]
fn a_table_is_a_base_and_what_it_lacks_is_found() {
    let mut noise = noise(1);
    let warm = |i: usize| 25.0 + 4.0 * (i as f64 / 150.0).sin();
    let row = |i: usize| {
        let reading = 10.0 + force(i) + 0.08 * (warm(i) - 20.0) + 0.005 * noise();
        vec![0.5 * i as f64, force(i), warm(i), reading]
    };
    let header = "time_s,force_n,temperature_c,response_mv";
    let (_folder, recording) = recorded("model = \"table\"\ntable = \"table.csv\"\nfree = []\n", header, 1200, row);
    let diagnosis = diagnosed(recording).outcome.diagnosis;
    assert_eq!(named(&diagnosis), ["temperature_coefficient"], "{}", diagnosis.says);
    assert!(diagnosis.fit.in_sample.rmse_after < 0.006, "{}", diagnosis.fit.in_sample.rmse_after);
}

#[test]
fn a_row_that_the_table_does_not_hold_is_named() {
    let row = |i: usize| vec![0.5 * i as f64, if i == 33 { 9.0 } else { force(i) }, 25.0, 10.0 + force(i)];
    let header = "time_s,force_n,temperature_c,response_mv";
    let (_folder, recording) = recorded("model = \"table\"\ntable = \"table.csv\"\n", header, 100, row);
    let told = truegap::models::base_model(&recording).err().unwrap().to_string();
    assert!(told.contains("row 34: force is 9") && told.contains("extend the table"), "{told}");
}

#[test]
fn words_under_base_that_mean_nothing_are_refused_with_those_that_do() {
    for (base, part) in [
        ("model = \"external\"\nfree = [\"slope\"]\n", "free = [\"slope\"] is not known"),
        ("model = \"external\"\ngain = -1.0\n", "standard deviation about 1"),
        ("model = \"linear\"\ndriver = \"voltage\"\n", "\"temperature\""),
        ("model = \"linear\"\norder = 9\n", "from 1 to 6"),
        ("model = \"linear\"\nslope = 2\n", "[base] has no key `slope`; known there: model"),
        ("model = \"table\"\n", "table = \"curve.csv\""),
    ] {
        let row = |i: usize| vec![i as f64, force(i), force(i), force(i)];
        let (_folder, recording) = recorded(base, "time_s,force_n,simulated,response_mv", 40, row);
        let told = truegap::models::base_model(&recording).err().unwrap().to_string();
        assert!(told.contains(part), "`{part}` is missing in: {told}");
    }
}

/// `--base` and `--sensor` take the place of what would have been taken for want of a word, and the notes no longer say that it was.
#[test]
fn a_base_that_is_asked_for_is_the_only_one_that_is_spoken_of() {
    let row = |i: usize| vec![i as f64, 1e-3 * (2.0 + force(i)), 5.0 / (2.0 + force(i))];
    let (folder, _) = recorded("model = \"constant\"\n", "time_s,gap_m,capacitance_pf", 60, row);
    let bare = Recording::open(folder.path().join("r.csv")).unwrap();
    assert!(bare.notes.iter().any(|note| note.to_string().contains("`gap-plate` was taken")));
    let request = Request { base: Some("linear".into()), ..Request::default() };
    let opened = open(vec![bare], &request).unwrap();
    assert!(opened.recording.notes.iter().all(|note| !note.to_string().contains("was taken")), "{:?}", opened.recording.notes);
}

/// A reading behind its simulation by three time constants, of 25, 40 and 60 s. The library's law of the lag has two ways side by side, so it is slightly off, and other effects follow what it leaves: they
/// are carried, and the lag alone is the cause. They had been named beside it; and where one of them was found alone, rows left out were predicted with ten times the error.
#[test]
fn what_follows_the_rest_of_a_law_that_is_slightly_off_is_carried_and_not_named() {
    let (mut noise, mut wander, mut late) = (noise(1), 0.0, [f64::NAN; 3]);
    let row = |i: usize| {
        let seconds = 10.0 * i as f64;
        wander += 0.1 * (noise() - wander);
        let simulated = 5.0 + 2.0 * (seconds / 300.0).sin() + wander;
        let mut behind = simulated;
        for (stage, tau) in late.iter_mut().zip([60.0, 25.0, 40.0]) {
            let before = if stage.is_nan() { behind } else { *stage };
            *stage = behind + (before - behind) * (-10.0f64 / tau).exp();
            behind = *stage;
        }
        vec![seconds, simulated, behind + 0.002 * noise()]
    };
    let (_folder, recording) = recorded("model = \"external\"\n", "time_s,simulated,response_v", 700, row);
    let diagnosis = diagnosed(recording).outcome.diagnosis;
    let lags = ["slow_response", "readout_lag"];
    assert!(named(&diagnosis).len() == 1 && lags.contains(&named(&diagnosis)[0]), "{}", diagnosis.says);
    assert!(!diagnosis.carried.is_empty() && diagnosis.says.contains("not claimed as a cause"), "{}", diagnosis.says);
    let held_out = diagnosis.fit.held_out.rmse_after.unwrap();
    assert!(held_out < 0.01, "{held_out}");
}
