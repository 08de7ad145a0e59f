//! A column hidden on purpose: is its absence noticed, and does the recovered course follow it?

#![allow(clippy::unwrap_used)]

#[path = "common/noise.rs"]
mod noise;

use noise::noise;
use std::sync::atomic::AtomicBool;
use truegap::core::{BaseSpec, Inputs, Recording};
use truegap::diagnose::answer::Verdict;
use truegap::diagnose::answer::{ConcealedColumn, Through};
use truegap::diagnosis::{Diagnosed, Request, diagnose, example_recording, open};

fn concealed(recording: Recording) -> (Diagnosed, ConcealedColumn) {
    let request = Request { conceal: vec!["temperature".into()], ..Request::default() };
    let opened = open(vec![recording], &request).unwrap();
    let diagnosed = diagnose(opened, Vec::new(), &request, &|_| (), &AtomicBool::new(false)).unwrap();
    let column = diagnosed.outcome.diagnosis.concealed_column.clone().unwrap();
    (diagnosed, column)
}

/// A value that should not move beside a room that warms and cools, `per_kelvin` of which gets into it.
fn in_a_room(per_kelvin: f64) -> Recording {
    let rows = 900;
    let room: Vec<f64> =
        (0..rows).map(|i| 22.0 + 3.0 * (f64::from(i) / 110.0).sin() + 1.5 * (f64::from(i) / 37.0).cos()).collect();
    let noise: Vec<f64> = std::iter::repeat_with(noise(1)).take(rows as usize).collect();
    let response = room.iter().zip(&noise).map(|(t, e)| 10.0 + per_kelvin * (t - 22.0) + 0.02 * e).collect();
    let inputs = Inputs {
        time_s: Some((0..rows).map(|i| 20.0 * f64::from(i)).collect()),
        run: vec![1; rows as usize],
        temperature_c: Some(room),
        ..Inputs::default()
    };
    let base = BaseSpec { model: "constant".into(), ..BaseSpec::default() };
    Recording::new(inputs, response, "V", base).unwrap()
}

#[test]
fn a_hidden_temperature_is_missed_and_its_course_followed() {
    let (diagnosed, column) = concealed(in_a_room(0.05));
    let diagnosis = &diagnosed.outcome.diagnosis;
    assert!(column.missing && column.through == Through::Zero, "{}", column.says);
    assert_eq!((diagnosis.verdict, diagnosis.findings.len()), (Verdict::Unexplained, 0), "{}", diagnosis.says);
    assert!(diagnosis.says.contains("not recorded"), "{}", diagnosis.says);
    // noise of 0.02 in rows, knots of 15 rows: the course is good to about 0.006, the temperature moves it by 0.12
    assert!(column.correlation.unwrap() > 0.99, "{}", column.says);
    let [slope, low, high] = column.slope.unwrap();
    assert!((slope - 0.05).abs() < 0.002 && low < 0.05 && 0.05 < high && low > 0.04, "{slope} {low} {high}");
    assert!(column.all.rmse_after.unwrap() < 0.025 && column.all.rmse_before.unwrap() > 0.1, "{:?}", column.all);
    let page = truegap::diagnosis::report::html(&diagnosed.subject());
    assert!(
        page.contains("The hidden column") && (page.contains("recovered course (mV)") || page.contains("recovered course / mV")),
        "no axis"
    );
}

#[test]
fn a_hidden_temperature_that_does_nothing_is_not_missed() {
    let (diagnosed, column) = concealed(in_a_room(0.0));
    assert!(!column.missing, "{}", column.says);
    assert_eq!(diagnosed.outcome.diagnosis.verdict, Verdict::Agrees, "{}", diagnosed.outcome.diagnosis.says);
}

#[test]
fn without_its_temperature_the_example_asks_for_a_slow_input() {
    let (_, column) = concealed(example_recording().unwrap());
    assert!(column.missing, "{}", column.says);
    // runs 3 and 4 are thermal sweeps under load: what the load reads tells the temperature
    for run in column.runs.iter().filter(|r| [3, 4].contains(&r.run)) {
        assert!(run.correlation.unwrap() > 0.98, "{run:?}");
        assert!(run.errors.rmse_after.unwrap() < 0.2 * run.errors.rmse_before.unwrap(), "{run:?}");
    }
    let [slope, low, high] = column.slope.unwrap();
    assert!(low > 0.0 && low < slope && slope < high, "{}", column.says);
}
