//! What is wrong with a recording is told, and what only looks so is not: commands that are held, rest at exactly 0, ceilings, inputs that switch fast.

#![allow(clippy::unwrap_used)]

mod common;

use common::Plate;
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;
use rand_distr::{Distribution, StandardNormal, Uniform};
use std::sync::atomic::AtomicBool;
use truegap_core::{Driver, Inputs, Parameter, Simulator};
use truegap_diagnose::quality::{Notice, NoticeKind, Rows, clipped_rows, outliers_of_inputs, troubles};
use truegap_diagnose::{Options, Problem, RecordingFacts, Verdict, diagnose};

fn gaussian(seed: u64) -> impl FnMut() -> f64 {
    let mut random = ChaCha8Rng::seed_from_u64(seed);
    move || StandardNormal.sample(&mut random)
}

fn inputs(force: Vec<f64>) -> Inputs {
    let rows = force.len();
    let time = (0..rows).map(|row| 0.1 * row as f64).collect();
    Inputs { time_s: Some(time), run: vec![1; rows], force_n: Some(force), ..Inputs::default() }
}

/// Notices of a kind on a recording of the plate.
fn told(force: Vec<f64>, response: &[f64], kind: NoticeKind) -> Vec<Notice> {
    let (plate, inputs) = (Plate::new(None), inputs(force));
    let problem = Problem { inputs: &inputs, response, simulator: &plate };
    let rows = Rows { inputs: &inputs, given: None, unit: "pF" };
    troubles(&problem, &rows).into_iter().filter(|notice| notice.kind == kind).collect()
}

/// 0 to 1 and back in ramps of 50 rows, with holds of 200 rows.
fn cycle(row: usize) -> f64 {
    match row % 500 {
        r @ 0..50 => r as f64 / 50.0,
        50..250 => 1.0,
        r @ 250..300 => 1.0 - (r - 250) as f64 / 50.0,
        _ => 0.0,
    }
}

/// A reading that gives way by 40 % of its range while the load is held, and comes back at rest, with noise.
fn relaxing(rows: usize) -> Vec<f64> {
    let (mut late, mut noise) = (0.0, gaussian(1));
    let mut one = |row: usize| {
        late += (cycle(row) - late) / 40.0;
        210.0 + cycle(row) - 0.6 * late + 0.002 * noise()
    };
    (0..rows).map(&mut one).collect()
}

#[test]
fn a_command_that_is_held_is_not_dead() {
    let commanded: Vec<f64> = (0..2000).map(|row| 3.0 * cycle(row)).collect();
    assert_eq!(told(commanded, &relaxing(2000), NoticeKind::DeadInput), []);
}

#[test]
fn a_load_that_is_cut_off_at_rest_is_no_more_than_a_doubt() {
    let mut noise = gaussian(2);
    let measured = |row| if cycle(row) == 0.0 { 0.0 } else { 3.0 * cycle(row) + 0.004 * noise() };
    let notices = told((0..2000).map(measured).collect(), &relaxing(2000), NoticeKind::DeadInput);
    assert!(notices.iter().all(|notice| !notice.withholds), "{notices:?}");
}

#[test]
fn a_measured_load_that_hangs_while_the_reading_goes_on_is_dead() {
    let mut noise = gaussian(3);
    let mut force: Vec<f64> = (0..2000).map(|row| 3.0 * cycle(row) + 0.004 * noise()).collect();
    let last = force[900];
    force[900..1400].fill(last);
    let notices = told(force, &relaxing(2000), NoticeKind::DeadInput);
    assert!(notices.len() == 1 && notices[0].withholds && notices[0].says.contains("rows 901 to 1400"), "{notices:?}");
}

/// A level that comes late after what drives it and stays at the converter's 211 pF while that goes on: the same load is met on the ceiling and below it.
#[test]
fn a_reading_at_its_ceiling_is_clipped_and_not_dead() {
    let mut noise = gaussian(4);
    let load = |row: usize| 2.0 + (row as f64 / 47.0).sin() + 0.9 * (row as f64 / 71.0).cos();
    let force: Vec<f64> = (0..1500).map(load).collect();
    let mut level = 0.0;
    let mut late = |force: &f64| {
        level += (force - level) / 30.0;
        (208.4 + level + 0.01 * noise()).min(211.0)
    };
    let response: Vec<f64> = force.iter().map(&mut late).collect();
    assert!(response.iter().filter(|r| **r == 211.0).count() > 60);
    let clipped = told(force.clone(), &response, NoticeKind::Clipped);
    assert!(clipped.len() == 1 && clipped[0].says.contains("never goes above 211 pF"), "{clipped:?}");
    assert_eq!(told(force, &response, NoticeKind::DeadChannel), []);
}

/// An accelerometer that is clipped at both ends: the rows of one end alone were found, and the other stayed in.
#[test]
fn both_ends_of_a_range_are_clipped() {
    let mut noise = gaussian(6);
    let force: Vec<f64> = (0..1500).map(|row| 2.0 + 2.0 * (row as f64 / 60.0).sin()).collect();
    let response: Vec<f64> = force.iter().map(|load| (200.0 + load + 0.01 * noise()).clamp(200.4, 203.6)).collect();
    let clipped = told(force.clone(), &response, NoticeKind::Clipped);
    assert!(clipped.len() == 1, "{clipped:?}");
    assert!(
        clipped[0].says.contains("never goes above 203.6 pF") && clipped[0].says.contains("never goes below 200.4 pF"),
        "{clipped:?}"
    );
    let problem = Problem { inputs: &inputs(force), response: &response, simulator: &Plate::new(None) };
    let (_, out) = clipped_rows(&problem, &Rows { inputs: problem.inputs, given: None, unit: "pF" }).unwrap();
    assert!(out.is_sorted() && [200.4, 203.6].iter().all(|end| out.iter().any(|row| response[*row] == *end)));
}

#[test]
fn a_reading_that_hangs_and_jumps_back_is_dead_and_not_clipped() {
    let (mut noise, mut response) = (gaussian(5), Vec::new());
    let force: Vec<f64> = (0..1500).map(|row| 2.0 + 2.0 * (row as f64 / 60.0).sin()).collect();
    response.extend(force.iter().map(|f| 210.0 + 0.5 * f + 0.005 * noise()));
    // broken off: far below anything else, with a jump at both ends
    response[700..900].fill(0.0);
    assert_eq!(told(force.clone(), &response, NoticeKind::Clipped), []);
    assert!(told(force, &response, NoticeKind::DeadChannel).len() == 1);
}

/// 0 to 600 mN at random in every row: by itself it looks like noise of 170 mN about 300 mN.
#[test]
fn an_input_that_switches_from_row_to_row_is_no_constant() {
    let (plate, mut noise) = (Plate::new(None), gaussian(6));
    let (random, jumps) = (&mut ChaCha8Rng::seed_from_u64(7), Uniform::new(0.0, 0.6).unwrap());
    let inputs = inputs((0..1200).map(|_| jumps.sample(random)).collect());
    let mut response = plate.respond(&[10.0, 6.0], &inputs, &[]).unwrap();
    response.iter_mut().for_each(|value| *value += 0.004 * noise());
    let problem = Problem { inputs: &inputs, response: &response, simulator: &plate };
    let options = Options { effects: vec!["offset_drift".into(), "readout_lag".into()], ..Options::default() };
    let facts = RecordingFacts { rows: 1200, runs: 1, ..RecordingFacts::default() };
    let said = diagnose(&problem, facts, &options, &|_| (), &AtomicBool::new(false)).unwrap().diagnosis;
    assert_eq!(said.verdict, Verdict::Agrees, "{}", said.says);
    assert!(said.noise.load_sd < 0.01, "{} N of noise on the load", said.noise.load_sd);
}

/// A simulation of the user's own, in millivolts where the reading is in volts, and one whose own gain may well be a thousand.
#[test]
fn a_power_of_a_thousand_is_a_unit_unless_a_number_of_the_simulator_can_make_it() {
    let plate = |sd: f64| common::Line { parameters: vec![Parameter::normal("gain", "V/N", 2.0, sd, "gain")] };
    let inputs = inputs((0..400).map(|row| 3.0 * cycle(row)).collect());
    let mut noise = gaussian(4);
    let response: Vec<f64> = (0..400).map(|row| 6000.0 * cycle(row) + 0.1 * noise()).collect();
    let told = |sd: f64, factor: f64| {
        let (simulator, response) = (plate(sd), response.iter().map(|v| v * factor).collect::<Vec<_>>());
        let problem = Problem { inputs: &inputs, response: &response, simulator: &simulator };
        let rows = Rows { inputs: &inputs, given: None, unit: "V" };
        troubles(&problem, &rows).into_iter().find(|notice| notice.kind == NoticeKind::WrongUnit)
    };
    let wrong = told(0.1, 1.0).unwrap();
    assert!(wrong.withholds && wrong.says.contains("6.00 V") && wrong.says.contains("unit"), "{}", wrong.says);
    assert!(told(0.1, 1e-6).is_some());
    // right, off by ten, and a gain of which nothing is known
    assert!(told(0.1, 1e-3).is_none() && told(0.1, 1e-2).is_none() && told(1000.0, 1.0).is_none());
}

/// Rows of a recording of the plate that are left out for a value of an input.
fn left_out(inputs: &Inputs, response: &[f64]) -> Vec<usize> {
    let plate = Plate::new(None);
    let problem = Problem { inputs, response, simulator: &plate };
    let found = outliers_of_inputs(&problem, &Rows { inputs, given: None, unit: "pF" });
    found.map_or_else(Vec::new, |(notice, out)| {
        assert!(notice.kind == NoticeKind::Outliers && !notice.withholds, "{}", notice.says);
        out
    })
}

/// A thermometer that reports -127 degC where it has no answer: the row took the whole answer. A reading that follows such a value says that it was there.
#[test]
fn a_value_that_the_reading_does_not_follow_is_left_out() {
    let mut noise = gaussian(5);
    let mut warm: Vec<f64> = (0..600).map(|row| 22.0 + 3.0 * (f64::from(row) / 80.0).sin() + 0.2 * noise()).collect();
    warm[311] = -127.0;
    let mut read: Vec<f64> = (0..600).map(|_| 210.0 + 0.002 * noise()).collect();
    let inputs = Inputs { temperature_c: Some(warm), ..inputs(vec![0.0; 600]) };
    assert_eq!(left_out(&inputs, &read), [311]);
    read[311] -= 1.0;
    assert_eq!(left_out(&inputs, &read), [0usize; 0]);
}

/// A wind from north: 358 and 2 degrees are neighbours, and their rows were left out as values that nothing follows.
#[test]
fn a_direction_that_goes_round_has_no_outliers() {
    let mut noise = gaussian(7);
    let mut from = |row: usize| match row {
        0..36 => 10.0 * row as f64,
        400 | 600 => 357.5,
        _ => 20.0 + 4.0 * noise(),
    };
    let values: Vec<f64> = (0..900).map(|row| (from(row) * 10.0).round() / 10.0).collect();
    let read: Vec<f64> = (0..900).map(|_| 210.0 + 0.002 * noise()).collect();
    let beside = |unit: &str| {
        let drivers = vec![Driver { name: "wind".into(), unit: unit.into(), values: values.clone() }];
        left_out(&Inputs { drivers, ..inputs(vec![0.0; 900]) }, &read)
    };
    assert!(!beside("1").is_empty());
    assert_eq!(beside("deg"), [0usize; 0]);
}

/// A force that is held for 40 rows a step, and two rows of it that were lost: beside a reading that follows every other step at once they are no load, beside a slow one they may be a command.
#[test]
fn a_lost_row_of_a_force_that_steps_is_told_by_its_other_steps() {
    let level = |step: usize| 10.0 + ((step * step * 37 + 11 * step) % 101) as f64 / 4.0;
    let held: Vec<f64> = (0..1200).map(|row| level(row / 40)).collect();
    let mut force = held.clone();
    force[500..502].fill(0.0);
    let mut noise = gaussian(6);
    let at_once: Vec<f64> = held.iter().map(|newton| 210.0 + 0.1 * newton + 0.005 * noise()).collect();
    assert_eq!(left_out(&inputs(force.clone()), &at_once), [500, 501]);
    let mut late = held[0];
    let mut follow = |newton: &f64| {
        late += (newton - late) / 200.0;
        210.0 + 0.1 * late + 0.005 * noise()
    };
    let slow: Vec<f64> = held.iter().map(&mut follow).collect();
    assert_eq!(left_out(&inputs(force), &slow), [0usize; 0]);
    // so many short pulses that they were done
    let pulse = |(row, newton): (usize, &f64)| if row % 40 == 20 { 0.0 } else { *newton };
    assert_eq!(left_out(&inputs(held.iter().enumerate().map(pulse).collect()), &at_once), [0usize; 0]);
}

/// A stretch at the end of a range was left out, and the gap that this made was told as a pause of the logger.
#[test]
fn rows_that_are_left_out_make_no_pause() {
    let plate = Plate::new(None);
    let kept: Vec<usize> = (0..300).chain(500..900).collect();
    let inputs = Inputs { time_s: Some(kept.iter().map(|row| *row as f64).collect()), ..inputs(vec![0.0; kept.len()]) };
    let mut noise = gaussian(8);
    let response: Vec<f64> = kept.iter().map(|_| 210.0 + 0.01 * noise()).collect();
    let problem = Problem { inputs: &inputs, response: &response, simulator: &plate };
    let told = |given: Option<&[usize]>| {
        let notices = troubles(&problem, &Rows { inputs: &inputs, given, unit: "pF" });
        notices.iter().filter(|notice| notice.kind == NoticeKind::Gap).count()
    };
    assert_eq!((told(Some(&kept)), told(None)), (0, 1));
}
