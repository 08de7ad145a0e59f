//! Physics that no library lists: recordings made here, with code of their own, of what a supply voltage and a rate of the load do to a reading.

#![allow(clippy::unwrap_used)]

mod common;

use common::Plate;
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;
use rand_distr::{Distribution, StandardNormal};
use std::sync::atomic::AtomicBool;
use truegap_core::{Driver, Inputs, Simulator};
use truegap_diagnose::mechanism::MechanismFile;
use truegap_diagnose::{Diagnosis, Library, Options, Problem, RecordingFacts, Verdict, diagnose};

const ROWS: usize = 1600;
const STEP_S: f64 = 0.5;
const NOISE: f64 = 0.004;

/// Presses every 40 s, a supply that goes its own way, rest in between.
fn inputs() -> Inputs {
    let time: Vec<f64> = (0..ROWS).map(|row| STEP_S * row as f64).collect();
    let press = |t: &f64| {
        let phase = (t / 40.0).fract();
        let strength = 1.0 + 3.0 * ((t / 40.0).floor() * 0.37).fract();
        if phase < 0.5 { 0.0 } else { strength * (std::f64::consts::PI * (phase - 0.5) * 2.0).sin() }
    };
    let supply: Vec<f64> = time.iter().map(|t| 5.0 + 0.6 * (t / 61.0).sin() + 0.3 * (t / 23.7).cos()).collect();
    let drivers = vec![Driver { name: "supply".into(), unit: "V".into(), values: supply }];
    let force: Vec<f64> = time.iter().map(press).collect();
    Inputs { time_s: Some(time), run: vec![1; ROWS], force_n: Some(force), drivers, ..Inputs::default() }
}

/// What the plate reads with `added` on top, and white noise.
fn recorded(inputs: &Inputs, added: impl Fn(usize) -> f64) -> Vec<f64> {
    recorded_by(&Plate::new(None), inputs, added)
}

fn recorded_by(plate: &Plate, inputs: &Inputs, added: impl Fn(usize) -> f64) -> Vec<f64> {
    let random = &mut ChaCha8Rng::seed_from_u64(5);
    let mut noisy = |(row, value): (usize, f64)| {
        let unit: f64 = StandardNormal.sample(random);
        value + added(row) + NOISE * unit
    };
    let clean = plate.respond(&[10.2, 6.5], inputs, &[]).unwrap();
    clean.into_iter().enumerate().map(&mut noisy).collect()
}

/// Diagnosed with a library that does not hold what is added.
fn told(inputs: &Inputs, response: &[f64], options: &Options) -> Diagnosis {
    told_by(&Plate::new(None), inputs, response, options)
}

fn told_by(plate: &Plate, inputs: &Inputs, response: &[f64], options: &Options) -> Diagnosis {
    let problem = Problem { inputs, response, simulator: plate };
    let facts = RecordingFacts { rows: ROWS, runs: 1, ..RecordingFacts::default() };
    diagnose(&problem, facts, options, &|_| (), &AtomicBool::new(false)).unwrap().diagnosis
}

fn small_library() -> Options {
    Options { effects: ["offset_drift", "saturation", "strain_stiffening"].map(String::from).to_vec(), ..Options::default() }
}

/// Above 5.3 V the reading rises by 0.2 pF a volt.
fn knee(inputs: &Inputs) -> impl Fn(usize) -> f64 + '_ {
    |row| 0.2 * (inputs.drivers[0].values[row] - 5.3).max(0.0)
}

#[test]
fn a_knee_in_a_recorded_driver_is_told_in_its_words() {
    let inputs = inputs();
    let response = recorded(&inputs, knee(&inputs));
    let diagnosis = told(&inputs, &response, &small_library());
    let found = diagnosis.discovered.first().expect(&diagnosis.says);
    let words = (found.driver.as_str(), found.kinetics.as_str(), found.form.as_str());
    assert_eq!(words, ("supply", "static", "threshold"), "{}", found.says);
    assert!(found.named && diagnosis.findings[0].effect == "discovered", "{}", diagnosis.says);
    assert!(found.probability.driver["supply"] > 0.99 && found.probability.kinetics["static"] > 0.9, "{:?}", found.probability);
    assert!(found.control_p_value < 0.02);
    let number = |name: &str| found.parameters.iter().find(|p| p.name == name).map(|p| (p.value, p.sd)).unwrap();
    let (at, sd) = number("threshold");
    // made at 5.3 V
    assert!((at - 5.3).abs() < 4.0 * sd && sd < 0.05, "{at} {sd}");
    let held = &diagnosis.fit.held_out;
    assert!(held.rmse_after.unwrap() < 1.2 * NOISE && held.rmse_before.unwrap() > 2.0 * NOISE);
}

#[test]
fn a_drag_that_fades_after_each_press_follows_the_rate_of_the_load() {
    let inputs = inputs();
    // y' = (|rate| - y) / 8 s by Euler's rule with a hundred steps a row; stiffness acts through the strain, so it scales what the load makes
    let force = inputs.force_n.clone().unwrap();
    let (mut y, mut activity) = (0.0, vec![0.0; ROWS]);
    for row in 1..ROWS {
        let rate = (force[row] - force[row - 1]).abs() / 4.5 / STEP_S;
        (0..100).for_each(|_| y += (rate - y) / 8.0 * STEP_S / 100.0);
        activity[row] = y;
    }
    let response = recorded(&inputs, |row| 0.9 * activity[row]);
    let diagnosis = told(&inputs, &response, &small_library());
    let found = diagnosis.discovered.first().expect(&diagnosis.says);
    assert_eq!((found.driver.as_str(), found.kinetics.as_str()), ("load_rate", "first_order"), "{}", found.says);
    assert!(found.named, "{}", diagnosis.says);
}

/// A sensor that is 6 s behind its thermometer, which goes from level to level. The base model follows the temperature at once: what is late has to take the place of that, and calibration has no
/// other scale of the temperature.
#[test]
fn a_sensor_that_is_behind_its_thermometer_is_late_and_does_not_play() {
    let mut inputs = inputs();
    // 8 K in 30 s, held for 170 s, and back
    let levels =
        |row: usize| 20.0 + 8.0 * (((row % 800) as f64 / 60.0).min(1.0) - ((row % 800) as f64 / 60.0 - 6.7).clamp(0.0, 1.0));
    let room: Vec<f64> = (0..ROWS).map(levels).collect();
    // y' = (T - y) / 6 s by Euler's rule with a hundred steps a row
    let (mut y, mut behind) = (room[0], room.clone());
    for row in 1..ROWS {
        (0..100).for_each(|_| y += (room[row] - y) / 6.0 * STEP_S / 100.0);
        behind[row] = y;
    }
    inputs.temperature_c = Some(behind);
    let plate = Plate::new(Some(true));
    let response = recorded_by(&plate, &inputs, |_| 0.0);
    let random = &mut ChaCha8Rng::seed_from_u64(8);
    let read = |t: &f64| {
        let unit: f64 = StandardNormal.sample(random);
        t + 0.05 * unit
    };
    inputs.temperature_c = Some(room.iter().map(read).collect());
    let diagnosis = told_by(&plate, &inputs, &response, &small_library());
    let found = diagnosis.discovered.first().expect(&diagnosis.says);
    let words = (found.place.as_str(), found.driver.as_str(), found.kinetics.as_str());
    assert_eq!(words, ("inputs", "temperature", "first_order"), "{}", found.says);
    assert!(found.probability.kinetics["first_order"] > 0.9, "{:?}", found.probability);
    let number = |name: &str| found.parameters.iter().find(|p| p.name == name).map(|p| (p.value, p.sd)).unwrap();
    let (tau, sd) = number("tau");
    assert!((tau - 6.0).abs() < 4.0 * sd && sd < 2.0, "{tau} {sd}");
}

#[test]
fn nothing_is_composed_where_nothing_is_missing() {
    let inputs = inputs();
    let diagnosis = told(&inputs, &recorded(&inputs, |_| 0.0), &small_library());
    assert_eq!((diagnosis.verdict, diagnosis.discovered.len()), (Verdict::Agrees, 0), "{}", diagnosis.says);
}

/// The library explains it, under its name; words say what it follows without that name, and the answer stays what it was.
#[test]
fn what_the_library_explains_is_told_in_words_as_if_no_effect_had_a_name() {
    let inputs = inputs();
    let response = recorded(&inputs, |row| 0.05 * (inputs.drivers[0].values[row] - 5.0));
    let library = || Options { effects: ["offset_drift", "driver_coefficient"].map(String::from).to_vec(), ..Options::default() };
    let diagnosis = told(&inputs, &response, &library());
    let alone = told(&inputs, &response, &Options { compose: false, ..library() });
    let named = |d: &Diagnosis| d.findings.iter().map(|f| (f.effect.clone(), f.probability)).collect::<Vec<_>>();
    assert_eq!((diagnosis.verdict, named(&diagnosis)), (alone.verdict, named(&alone)), "{}", diagnosis.says);
    assert_eq!(diagnosis.findings[0].effect, "driver_coefficient");
    let found = diagnosis.discovered.first().expect(&diagnosis.says);
    assert_eq!((found.driver.as_str(), found.kinetics.as_str()), ("supply", "static"), "{}", found.says);
    assert!(found.in_other_words && !found.named && found.held_out.rmse_after.unwrap() < 1.2 * NOISE);
    assert!(alone.discovered.is_empty());
    // nor does it count among what was tried, or as one more effect that may act beside the rest
    let tried = |d: &Diagnosis| d.candidates.iter().map(|c| c.effect.clone()).collect::<Vec<_>>();
    let numbers = |d: &Diagnosis| d.base.parameters_after.iter().map(|p| (p.value, p.sd)).collect::<Vec<_>>();
    assert_eq!((tried(&diagnosis), numbers(&diagnosis)), (tried(&alone), numbers(&alone)));
}

/// A supply that falls nearly evenly: a zero that drifts explains the recording to the noise, and the supply itself explains its ripple as well.
#[test]
fn words_that_are_likelier_than_a_name_are_the_answer() {
    let mut inputs = inputs();
    let time = inputs.time_s.clone().unwrap();
    inputs.drivers[0].values = time.iter().map(|t| 5.0 - 3e-5 * t + 0.0075 * (t / 50.0).sin()).collect();
    let response = recorded(&inputs, |row| 0.2 * (inputs.drivers[0].values[row] - 5.0));
    let library = || Options { effects: vec!["offset_drift".into()], ..Options::default() };
    let alone = told(&inputs, &response, &Options { compose: false, ..library() });
    assert_eq!(alone.findings.iter().map(|f| f.effect.as_str()).collect::<Vec<_>>(), ["offset_drift"], "{}", alone.says);
    let diagnosis = told(&inputs, &response, &library());
    let found = diagnosis.discovered.first().expect(&diagnosis.says);
    assert_eq!((found.driver.as_str(), found.kinetics.as_str()), ("supply", "static"), "{}", found.says);
    assert!(found.named && !found.in_other_words && found.log_odds > Some(0.0), "{}", diagnosis.says);
}

/// A parabola of the supply follows a knee of it to a sixteenth of the misfit, and takes the name; that its law is none, and where the knee is, is told beside it.
#[test]
fn a_knee_is_told_beside_an_effect_that_follows_the_same_driver() {
    let inputs = inputs();
    let response = recorded(&inputs, knee(&inputs));
    let library = Options { effects: vec!["offset_drift".into(), "driver_coefficient".into()], ..Options::default() };
    let diagnosis = told(&inputs, &response, &library);
    let found = diagnosis.discovered.first().expect(&diagnosis.says);
    assert!(found.form == "threshold" && found.says.contains("5.30 V"), "{} {}", diagnosis.says, found.says);
    assert!(found.named || diagnosis.verdict == Verdict::WrongForm, "{}", diagnosis.says);
}

#[test]
fn on_request_the_library_is_all() {
    let inputs = inputs();
    let response = recorded(&inputs, knee(&inputs));
    let diagnosis = told(&inputs, &response, &Options { compose: false, ..small_library() });
    assert!(diagnosis.discovered.is_empty() && diagnosis.findings.iter().all(|f| f.effect != "discovered"));
}

#[test]
fn a_mechanism_from_a_file_is_an_effect_like_any_other() {
    let inputs = inputs();
    let file: MechanismFile = toml::from_str(
        r#"
        schema = "truegap.mechanism/1"
        id = "supply_knee"
        quantity = "reading"
        action = "adds"
        driver = { recorded = "supply" }
        kinetics = "static"
        form = "threshold"
        size = { sd = 1.0, unit = "pF/V" }
        threshold = { value = 5.1, sd = 0.3, unit = "V" }
        "#,
    )
    .unwrap();
    let library = Library::default().with(Box::new(file.effect().unwrap()));
    let effects = ["offset_drift", "saturation", "supply_knee"].map(String::from).to_vec();
    let diagnosis = told(&inputs, &recorded(&inputs, knee(&inputs)), &Options { library, effects, ..Options::default() });
    let named: Vec<&str> = diagnosis.findings.iter().map(|f| f.effect.as_str()).collect();
    assert_eq!((diagnosis.verdict, named), (Verdict::Explained, vec!["supply_knee"]), "{}", diagnosis.says);
    let size = &diagnosis.findings[0].parameters[0];
    // made with 0.2 pF/V
    assert!((size.value - 0.2).abs() < 4.0 * size.sd, "{} {}", size.value, size.sd);
}
