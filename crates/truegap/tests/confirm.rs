//! What a diagnosis found on one recording, judged on another: the same physics is confirmed, its absence refutes it, and what cannot be judged is refused.

#![allow(clippy::unwrap_used)]

use std::path::{Path, PathBuf};
use std::sync::{OnceLock, atomic::AtomicBool};
use truegap::core::{Driver, Inputs, Recording};
use truegap::diagnose::answer::{AddedEffect, NamedValue, RivalModel};
use truegap::diagnose::confirmation::Judgement;
use truegap::diagnose::{Context, library};
use truegap::diagnosis::confirm::{self, ConfirmError, Confirmation, Free, SCHEMA, confirm};
use truegap::diagnosis::{Request, diagnose, example_recording, open};
use truegap::models::ModelFile;

const FIXED: Free = Free { gain: false, offset: false, clock: false };
const BOTH: Free = Free { gain: true, offset: true, clock: false };

/// What the built-in recording is diagnosed with: a thermal lag.
fn found() -> &'static ModelFile {
    static FOUND: OnceLock<ModelFile> = OnceLock::new();
    FOUND.get_or_init(|| {
        let (recording, request) = (example_recording().unwrap(), Request::default());
        let files = vec![("example".to_owned(), recording.sha256.clone())];
        let diagnosed = diagnose(open(vec![recording], &request).unwrap(), files, &request, &|_| (), &AtomicBool::new(false));
        diagnosed.unwrap().model_file().unwrap()
    })
}

fn written(folder: &Path, file: &ModelFile) -> PathBuf {
    let path = folder.join("augmented.toml");
    std::fs::write(&path, file.to_toml().unwrap()).unwrap();
    path
}

/// Unit Gaussian numbers, always the same for a seed.
fn gaussian(seed: u64) -> impl FnMut() -> f64 {
    let mut state = seed;
    let mut uniform = move || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        ((state >> 11) as f64 + 0.5) / (1u64 << 53) as f64
    };
    move || (-2.0 * uniform().ln()).sqrt() * (std::f64::consts::TAU * uniform()).cos()
}

/// Another history: a slow swing of the temperature and steps of load, one run, with rest at its begin.
fn history(rows: usize) -> Inputs {
    let time: Vec<f64> = (0..rows).map(|row| 10.0 * row as f64).collect();
    let moving = |t: &f64| (t - 1500.0).max(0.0);
    Inputs {
        run: vec![1; rows],
        force_n: Some(time.iter().map(|t| f64::from((moving(t) / 700.0) as u32 % 4)).collect()),
        temperature_c: Some(time.iter().map(|t| 25.0 + 8.0 * (moving(t) / 100.0).sin()).collect()),
        time_s: Some(time),
        ..Inputs::default()
    }
}

/// A recording of the sensor of [`found`] on this history, with or without the lag; the lag by the equations that no fit uses.
fn other(has_lag: bool, gain: f64, offset: f64) -> Recording {
    let (file, inputs) = (found(), history(1200));
    let sensor = truegap::Sensor::from_toml(file.sensor.as_ref().unwrap(), "sensor").unwrap();
    let base = file.base.build(Some(&sensor)).unwrap();
    let values: Vec<f64> = file.parameters.iter().map(|p| p.value).collect();
    let effects = library();
    let lag = effects.iter().find(|e| e.id().0 == "thermal_lag").unwrap();
    let context = Context::new(&inputs, base.as_ref(), 1.0, file.scales.noise_sd);
    let numbers: Vec<f64> = file.effects[0].parameters.iter().map(|p| p.value).collect();
    let stage = lag.sibling(&numbers, &context).unwrap();
    let stages = if has_lag { vec![stage.as_ref()] } else { Vec::new() };
    let mut noise = gaussian(11);
    let mut response = base.respond(&values, &inputs, &stages).unwrap();
    response.iter_mut().for_each(|r| *r = gain * *r + offset + file.scales.noise_sd * noise());
    Recording::new(inputs, response, &file.unit, example_recording().unwrap().base).unwrap()
}

fn judged(recording: Recording, free: Free) -> Confirmation {
    let folder = tempfile::tempdir().unwrap();
    let confirmed = confirm(&written(folder.path(), found()), recording, None, free).unwrap();
    let out = confirmed.write(&folder.path().join("out")).unwrap();
    let json: serde_json::Value = serde_json::from_str(&std::fs::read_to_string(out.join("confirmation.json")).unwrap()).unwrap();
    assert_eq!((json["schema"].as_str(), json["level"].as_f64()), (Some(SCHEMA), Some(0.05)));
    assert_eq!(std::fs::read_to_string(out.join("confirmation.csv")).unwrap().lines().count(), 1201);
    confirmed.document
}

#[test]
fn the_same_physics_on_another_history_is_confirmed() {
    assert_eq!(found().effects.iter().map(|e| e.id.as_str()).collect::<Vec<_>>(), ["thermal_lag"]);
    let alone = |name: &str| found().base_alone.iter().find(|p| p.name == name).unwrap().value;
    assert_eq!(found().base_alone.len(), found().parameters.len());
    assert!(found().parameters.iter().any(|p| alone(&p.name) != p.value), "these are the values of the augmented fit");
    let answer = judged(other(true, 1.0, 0.0), FIXED);
    assert_eq!(answer.verdict, Judgement::Confirmed, "{}", answer.says);
    assert!(answer.model.base_is_known && answer.notes.is_empty(), "{:?}", answer.notes);
    // white noise of this size is all that is left but the difference of the two forms of the lag
    let sd = found().scales.noise_sd;
    assert!((0.95..1.5).contains(&(answer.augmented.rmse / sd)), "{} of {sd}", answer.augmented.rmse);
    assert!((0.8..1.25).contains(&(answer.noise.rmse / sd)), "{} of {sd}: {}", answer.noise.rmse, answer.noise.says);
    // the lag that calibration alone cannot take up is as large as the noise: sqrt(2) or more
    assert!(answer.base.rmse > 1.41 * answer.augmented.rmse, "{}", answer.says);
}

/// The clock of one recording says nothing of another one: with it or without it in the file the figures are the same, and where it is all that was found there
/// is nothing to confirm.
#[test]
fn a_clock_is_left_to_the_recording_that_it_was_found_in() {
    let number = |name: &str, value: f64| NamedValue { name: name.into(), unit: "s".into(), value, sd: 1e-3 };
    let clock = AddedEffect { id: "time_offset".into(), parameters: vec![number("late", 25.0)], mechanism: None, carried: false };
    let with = |effects: Vec<AddedEffect>| ModelFile { effects, ..found().clone() };
    let folder = tempfile::tempdir().unwrap();
    let file = written(folder.path(), &with(vec![clock.clone(), found().effects[0].clone()]));
    let answer = confirm(&file, other(true, 1.0, 0.0), None, FIXED).unwrap().document;
    let without = judged(other(true, 1.0, 0.0), FIXED);
    assert_eq!((answer.augmented.rmse, answer.verdict), (without.augmented.rmse, Judgement::Confirmed));
    assert_eq!(answer.model.effects, ["thermal_lag"]);
    assert!(
        answer.notes.iter().any(|note| note.starts_with("time offset is left out here: it belongs to what recorded")),
        "{:?}",
        answer.notes
    );
    let alone = confirm(&written(folder.path(), &with(vec![clock])), other(true, 1.0, 0.0), None, FIXED).err().unwrap();
    assert!(matches!(alone, ConfirmError::LeftOut { .. }) && alone.to_string().contains("time offset"), "{alone}");
}

/// A recording whose load is stamped by another clock: what was found is hidden behind it until a clock is fitted, and that clock is the planted one.
#[test]
fn a_clock_of_the_other_recording_is_fitted_where_it_is_free() {
    let planted = |recording: Recording| {
        let time = recording.inputs.time_s.clone().unwrap();
        let first = time[0];
        // the load of the time t stands in the row of t + s
        let late = |t: f64| 35.0 + 0.004 * (t - first);
        let force = recording.inputs.force_n.clone().unwrap();
        let at = |t: f64| {
            let after = time.partition_point(|other| *other < t).clamp(1, time.len() - 1);
            let share = ((t - time[after - 1]) / (time[after] - time[after - 1])).clamp(0.0, 1.0);
            force[after - 1] + share * (force[after] - force[after - 1])
        };
        let stamped = time.iter().map(|t| at(t - late(*t))).collect();
        Recording { inputs: Inputs { force_n: Some(stamped), ..recording.inputs.clone() }, ..recording }
    };
    let without = judged(planted(other(true, 1.0, 0.0)), BOTH);
    let with = judged(planted(other(true, 1.0, 0.0)), Free { clock: true, ..BOTH });
    assert!(without.verdict != Judgement::Confirmed && without.augmented.clock.is_none(), "{}", without.says);
    assert_eq!((with.verdict, with.free.as_slice()), (Judgement::Confirmed, &["gain", "offset", "clock"][..]), "{}", with.says);
    assert!(with.augmented.rmse < 0.5 * without.augmented.rmse, "{} {}", with.says, without.says);
    let clock = with.augmented.clock.unwrap();
    // rows are 10 s apart, and the load of the planted recording is straight between them
    assert!((clock.late_s - 35.0).abs() < 2.5 && (clock.rate - 0.004).abs() < 4e-4, "{clock:?}");
    assert!(with.base.clock.is_some());
    let mut timeless = other(true, 1.0, 0.0);
    timeless.inputs.time_s = None;
    let folder = tempfile::tempdir().unwrap();
    let refused = confirm(&written(folder.path(), found()), timeless, None, Free { clock: true, ..BOTH }).err().unwrap();
    assert!(refused.to_string().contains("no time"), "{refused}");
}

/// The first recording could not tell a drift from the lag that acts, and named the drift. The second tells them apart: the lag leaves no more than noise, and the drift is excluded. A rival that is a
/// clock of the first recording, and one that the library does not have, are not judged; and a file without rivals says nothing of them.
#[test]
fn another_recording_tells_rivals_apart() {
    let number = |name: &str, unit: &str, value: f64| NamedValue { name: name.into(), unit: unit.into(), value, sd: 1e-3 };
    let effect = |id: &str, numbers: &[NamedValue]| AddedEffect {
        id: id.into(),
        parameters: numbers.to_vec(),
        mechanism: None,
        carried: false,
    };
    let drift = effect("offset_drift", &[number("rate", &format!("{}/h", found().unit), 0.01), number("fading", "1/h", 0.0)]);
    let clock = effect("time_offset", &[number("late", "s", 25.0)]);
    let rival = |added: AddedEffect| RivalModel {
        instead_of: drift.id.clone(),
        id: added.id.clone(),
        parameters: found().parameters.clone(),
        effects: vec![added],
    };
    let rivals = vec![rival(found().effects[0].clone()), rival(clock), rival(effect("phlogiston", &[]))];
    let file = ModelFile { effects: vec![drift.clone()], rivals, ..found().clone() };
    let folder = tempfile::tempdir().unwrap();
    let answer = confirm(&written(folder.path(), &file), other(true, 1.0, 0.0), None, FIXED).unwrap().document;
    let lag = judged(other(true, 1.0, 0.0), FIXED);
    assert!(lag.rivals.is_none());
    let among = answer.rivals.unwrap();
    assert_eq!((among.judged.len(), among.refused.len(), among.level), (1, 2, 0.05));
    assert_eq!((among.judged[0].id.as_str(), among.judged[0].errors.rmse), ("thermal_lag", lag.augmented.rmse));
    assert!(among.judged[0].behind_the_best.is_none());
    assert_eq!(among.augmented_behind_the_best.unwrap().judgement, Judgement::Confirmed);
    let told = "could not tell apart, the smallest error here is that of thermal lag in the place of offset drift (";
    assert!(among.says.contains(told) && among.says.contains("excluded: offset drift as named"), "{}", among.says);
    assert!(
        among.refused[0].contains("belongs to what recorded") && among.refused[1].contains("phlogiston"),
        "{:?}",
        among.refused
    );
    // the right one was named: it stays, and the other way round the drift is what is excluded
    let rivals = vec![rival(drift.clone())];
    let right = ModelFile { effects: found().effects.clone(), rivals, ..found().clone() };
    let among = confirm(&written(folder.path(), &right), other(true, 1.0, 0.0), None, FIXED).unwrap().document.rivals.unwrap();
    assert!(among.augmented_behind_the_best.is_none());
    assert_eq!(among.judged[0].behind_the_best.as_ref().unwrap().judgement, Judgement::Confirmed);
    assert!(among.says.contains("the smallest error here is that of thermal lag as named ("), "{}", among.says);
}

/// The rows of the recording that was fitted, saved again with other bytes, took part all the same.
#[test]
fn a_recording_that_was_saved_again_took_part() {
    let fitted = other(true, 1.0, 0.0);
    let again = Recording { sha256: "another".into(), ..fitted.clone() };
    let parts = [fitted];
    assert!(matches!(confirm::other(again.clone(), None, &parts), Err(ConfirmError::TookPart { .. })));
    let mut new = again;
    new.response[7] += 1e-6;
    assert!(confirm::other(new, None, &parts).is_ok());
}

/// By the file of the model the same: it knew the bytes of the table alone, and a table that was saved again confirmed itself.
#[test]
fn a_model_file_knows_the_readings_that_it_was_fitted_to() {
    let folder = tempfile::tempdir().unwrap();
    let mut example = example_recording().unwrap();
    example.sha256 = "another".into();
    let error = confirm(&written(folder.path(), found()), example.clone(), None, FIXED).err().unwrap();
    assert!(matches!(error, ConfirmError::TookPart { .. }), "{error}");
    example.response[7] += 1e-6;
    assert!(confirm(&written(folder.path(), found()), example, None, FIXED).is_ok());
}

/// Another sensor, base model or unit of a driver was judged as if it were the model's.
#[test]
fn a_recording_that_says_something_else_of_itself_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    let model = ModelFile { drivers: [("supply".into(), "V".into())].into(), ..found().clone() };
    let file = written(folder.path(), &model);
    let refused = |change: &dyn Fn(&mut Recording)| {
        let mut recording = other(true, 1.0, 0.0);
        change(&mut recording);
        confirm(&file, recording, None, FIXED).err().unwrap().to_string()
    };
    let told = refused(&|r| r.base.sensor = Some("foam-s15".into()));
    assert!(told.contains("its sensor is `foam-s15`, and `singletact-s15-4.5n` in the model file"), "{told}");
    let told = refused(&|r| r.base.model = "linear".into());
    assert!(told.contains("its base model is `linear`, and `stack` in the model file"), "{told}");
    let told =
        refused(&|r| r.inputs.drivers = vec![Driver { name: "supply".into(), unit: "mV".into(), values: vec![5.0; 1200] }]);
    assert!(told.contains("the unit of the driver `supply` is `mV`, and `V` in the model file"), "{told}");
    // before a diagnosis is made, beside the recording that it is made of
    let (part, mut foam) = (other(true, 1.0, 0.0), other(true, 1.0, 1.0));
    assert!(confirm::other(foam.clone(), None, std::slice::from_ref(&part)).is_ok());
    foam.base.sensor = Some("foam-s15".into());
    let told = confirm::other(foam, None, &[part]).err().unwrap().to_string();
    assert!(told.contains("and `singletact-s15-4.5n` in the recording that is diagnosed"), "{told}");
}

/// A number in the place of a driver that was not recorded, or was in another unit, would be taken for physics.
#[test]
fn recordings_with_different_drivers_are_not_diagnosed_together() {
    let with = |drivers: Vec<Driver>| {
        let mut recording = other(true, 1.0, drivers.len() as f64);
        recording.inputs.drivers = drivers;
        recording
    };
    let supply = |unit: &str| vec![Driver { name: "supply".into(), unit: unit.into(), values: vec![5.0; 1200] }];
    let refused =
        |second: Recording| open(vec![with(supply("V")), second], &Request::default()).err().map(|error| error.to_string());
    assert!(refused(with(Vec::new())).unwrap().contains("has no driver `supply`"));
    assert!(refused(with(supply("mV"))).unwrap().contains("is in `mV`, and in `V` in"));
    let mut alike = with(supply("V"));
    alike.response[0] += 1e-6;
    assert_eq!(refused(alike), None);
}

#[test]
fn a_recording_without_the_physics_refutes_it() {
    let answer = judged(other(false, 1.0, 0.0), FIXED);
    assert_eq!(answer.verdict, Judgement::Refuted, "{}", answer.says);
    assert!(answer.augmented.rmse > answer.base.rmse && answer.test.difference < 0.0, "{}", answer.says);
}

/// Two error values of a logger: counted, they were most of both errors, and nothing could be told.
#[test]
fn readings_far_outside_are_left_out_and_told() {
    let clean = judged(other(true, 1.0, 0.0), FIXED);
    let mut recording = other(true, 1.0, 0.0);
    let far = 1000.0 * found().scales.noise_sd;
    [400, 900].into_iter().for_each(|row: usize| recording.response[row] += far);
    let folder = tempfile::tempdir().unwrap();
    let said = confirm(&written(folder.path(), found()), recording, None, FIXED).unwrap().document;
    assert_eq!((said.verdict, said.recording.rows), (Judgement::Confirmed, 1198), "{}", said.says);
    assert!(said.notes.iter().any(|note| note.contains("2 readings stand far outside")), "{:?}", said.notes);
    // two rows of 1200 are all that differs
    approx::assert_relative_eq!(said.augmented.rmse, clean.augmented.rmse, max_relative = 0.01);
}

/// A daily cycle goes with the date: its phase was set to 0 in another recording, which refuted what is right.
#[test]
fn a_daily_cycle_is_carried_over_by_the_date_and_by_nothing_else() {
    let size = 10.0 * found().scales.noise_sd;
    // highest at two in the afternoon
    let numbers = [("size", "pF", size), ("highest", "s", 14.0 * 3600.0), ("second", "1", 0.0), ("second_highest", "s", 0.0)];
    let number = |(name, unit, value): (&str, &str, f64)| NamedValue { name: name.into(), unit: unit.into(), value, sd: 1e-3 };
    let cycle = numbers.map(number).into();
    let cycle = AddedEffect { id: "daily_cycle".into(), parameters: cycle, mechanism: None, carried: false };
    let mut file = ModelFile { effects: vec![cycle], ..found().clone() };
    file.scales.moved.as_mut().unwrap().dated = true;
    // four days that begin at six in the morning of a day
    let (mut recording, midnight) = (other(false, 1.0, 0.0), 20_786.0 * 86_400.0);
    recording.inputs = Inputs { began_s: Some(midnight + 6.0 * 3600.0), ..recording.inputs };
    let time = recording.inputs.time_s.as_mut().unwrap();
    time.iter_mut().for_each(|t| *t *= 30.0);
    for (read, t) in recording.response.iter_mut().zip(time.iter()) {
        *read += 0.5 * size * (std::f64::consts::TAU * (t / 3600.0 + 6.0 - 14.0) / 24.0).cos();
    }
    let folder = tempfile::tempdir().unwrap();
    let path = written(folder.path(), &file);
    let said = confirm(&path, recording.clone(), None, FIXED).unwrap().document;
    assert_eq!(said.verdict, Judgement::Confirmed, "{}", said.says);
    approx::assert_relative_eq!(said.augmented.rmse, found().scales.noise_sd, max_relative = 0.1);
    recording.inputs.began_s = None;
    let refused = confirm(&path, recording, None, FIXED).err().unwrap();
    assert!(matches!(refused, ConfirmError::LeftOut { .. }) && refused.to_string().contains("goes with the date"), "{refused}");
}

#[test]
fn a_reading_with_a_gain_and_zero_of_its_own_is_judged_where_they_are_free() {
    let answer = judged(other(true, 0.9, 40.0), BOTH);
    assert_eq!(answer.verdict, Judgement::Confirmed, "{}", answer.says);
    let reading = answer.augmented.reading;
    assert!((reading.gain - 0.9).abs() < 0.01 && answer.free == ["gain", "offset"], "{reading:?}");
    // not free: both models are off by the level, which says nothing of the lag; a verdict that hangs on that is told
    let fixed = judged(other(true, 0.9, 40.0), FIXED);
    assert!(fixed.augmented.rmse > 10.0 * answer.augmented.rmse, "{}", fixed.says);
    let told = fixed.notes.iter().any(|note| note.contains("--free gain,offset"));
    assert_eq!(told, fixed.verdict != Judgement::Confirmed, "{:?} {:?}", fixed.verdict, fixed.notes);
}

#[test]
fn a_file_without_the_values_of_the_base_alone_is_read_and_that_is_told() {
    let folder = tempfile::tempdir().unwrap();
    let old = ModelFile { base_alone: Vec::new(), ..found().clone() };
    let answer = confirm(&written(folder.path(), &old), other(true, 1.0, 0.0), None, FIXED).unwrap().document;
    assert_eq!((answer.verdict, answer.model.base_is_known), (Judgement::Confirmed, false));
    assert!(answer.notes[0].contains("[[base_alone]]"), "{:?}", answer.notes);
}

#[test]
fn what_cannot_be_judged_is_refused_with_its_reason() {
    let folder = tempfile::tempdir().unwrap();
    let refused = |file: &ModelFile, recording: Recording| -> ConfirmError {
        confirm(&written(folder.path(), file), recording, None, FIXED).err().unwrap()
    };
    let same = other(true, 1.0, 0.0);
    let counts = Recording { response_unit: "counts".into(), ..same.clone() };
    assert!(matches!(refused(found(), counts), ConfirmError::Unit { .. }));
    assert!(matches!(refused(found(), example_recording().unwrap()), ConfirmError::TookPart { .. }));
    let bare = ModelFile { effects: Vec::new(), ..found().clone() };
    assert!(matches!(refused(&bare, same.clone()), ConfirmError::NothingAdded { .. }));
    let mut loadless = same.clone();
    loadless.inputs.force_n = None;
    assert!(matches!(refused(found(), loadless), ConfirmError::NoAnswer(_)));
    let mut cold = same.clone();
    cold.inputs.temperature_c = None;
    assert!(matches!(refused(found(), cold), ConfirmError::NotShown { .. }));
    let number = |name: &str| NamedValue { name: name.into(), unit: String::new(), value: 0.1, sd: 0.01 };
    let steps = AddedEffect {
        id: "offset_steps".into(),
        parameters: vec![number("size"), number("jump_2")],
        mechanism: None,
        carried: false,
    };
    let mut jumps = ModelFile { effects: vec![steps], ..found().clone() };
    jumps.scales.runs = Some(2);
    let error = refused(&jumps, same);
    assert!(matches!(error, ConfirmError::BoundToRuns { .. }) && error.to_string().contains("offset_steps"), "{error}");
    assert!(matches!(Free::of(&["slope".into()]), Err(ConfirmError::Free { .. })));
}
