//! A base model without any free number, and recordings with hardly anything beside the response: every step of a diagnosis has an answer.

#![allow(clippy::unwrap_used)]

mod at_work;
mod clocks;
mod follows_late;
mod given;
mod laws;
mod looked_for;
mod loops;
mod noise_that_lasts;
mod part_of_it;
mod switches;

use given::{Given, noisy, said, simulated};
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;
use rand_distr::{Distribution, StandardNormal};
use std::sync::atomic::{AtomicBool, Ordering};
use truegap_core::{Driver, Inputs};
use truegap_diagnose::{Options, Problem, RecordingFacts, Verdict, diagnose};

#[test]
fn a_simulation_without_a_free_number_that_is_right_agrees() {
    let inputs = simulated();
    let truth = inputs.simulated.clone().unwrap();
    let said = said(&Given::fixed(), &inputs, &noisy(1, |row| truth[row], truth.len()));
    assert_eq!((said.verdict, said.findings.len()), (Verdict::Agrees, 0), "{}", said.says);
}

/// One row a run, an hour apart: no time passes inside a run, and a drift is told from run to run.
#[test]
fn one_row_a_run_with_a_clock_is_diagnosed() {
    let rows = 120;
    let inputs = Inputs {
        time_s: Some((0..rows).map(|row| 3600.0 * f64::from(row)).collect()),
        run: (1..=rows).collect(),
        temperature_c: Some((0..rows).map(|row| 22.0 + 5.0 * (f64::from(row) / 9.0).sin()).collect()),
        ..Inputs::default()
    };
    let warm = inputs.temperature_c.clone().unwrap();
    let said = said(&Given::with_level(), &inputs, &noisy(3, |row| 3.0 + 0.05 * (warm[row] - 20.0), rows as usize));
    let named: Vec<&str> = said.findings.iter().map(|f| f.effect.as_str()).collect();
    assert_eq!(named, ["temperature_coefficient"], "{}", said.says);
    let lag = said.not_testable.iter().find(|n| n.effect == "thermal_lag").unwrap();
    assert!(lag.says.contains("every run is one row"), "{}", lag.says);
}

/// A thermometer that swings by 5 K, 2 mV/K: one standard deviation of a row. One row in 1800 is off by a hundred.
#[test]
fn a_single_wild_row_does_not_take_the_verdict() {
    let inputs = Inputs {
        time_s: Some((0..1800).map(f64::from).collect()),
        run: vec![1; 1800],
        temperature_c: Some((0..1800).map(|row| 22.0 + 5.0 * (f64::from(row) / 90.0).sin()).collect()),
        ..Inputs::default()
    };
    let warm = inputs.temperature_c.clone().unwrap();
    let wild = |row: usize| if row == 700 { 1.0 } else { 0.0 };
    let said = said(&Given::with_level(), &inputs, &noisy(5, |row| 3.0 + 0.002 * (warm[row] - 20.0) + wild(row), 1800));
    let named: Vec<&str> = said.findings.iter().map(|f| f.effect.as_str()).collect();
    assert_eq!((said.verdict, named), (Verdict::Explained, vec!["temperature_coefficient"]), "{}", said.says);
    assert!(said.noise.says.contains("wild"), "{}", said.noise.says);
}

/// Nothing but the reading, no clock, and it drifts: there is no input along which it could be located, and the answer says that it is wrong.
#[test]
fn a_response_alone_is_diagnosed() {
    let inputs = Inputs { run: vec![1; 400], ..Inputs::default() };
    let said = said(&Given::with_level(), &inputs, &noisy(4, |row| 3.0 + 0.002 * row as f64, 400));
    assert!(said.verdict != Verdict::Agrees && said.findings.is_empty() && said.mismatch.is_empty(), "{}", said.says);
}

/// A level that jumps by 1 V after a fifth of the rows, under noise with a long memory. Under that noise a fit follows changes from row to row and ends midway between the ends of
/// the recording, 0.5 V off at each; by least squares the level is the mean, and what it leaves is the scatter about it.
#[test]
fn the_base_model_alone_is_calibrated_by_least_squares() {
    let base = Given::with_level();
    let mut random = ChaCha8Rng::seed_from_u64(12);
    let mut slow = 0.0;
    let mut noisy = |row: usize| {
        let unit: f64 = StandardNormal.sample(&mut random);
        slow = 0.97 * slow + 0.005 * unit;
        3.0 + slow + f64::from(u8::from(row >= 160))
    };
    let response: Vec<f64> = (0..800).map(&mut noisy).collect();
    let time = (0..800).map(f64::from).collect();
    let inputs = Inputs { time_s: Some(time), run: vec![1; 800], ..Inputs::default() };
    let problem = Problem { inputs: &inputs, response: &response, simulator: &base };
    let facts = RecordingFacts { rows: 800, runs: 1, ..RecordingFacts::default() };
    let found = diagnose(&problem, facts, &Options::default(), &|_| (), &AtomicBool::new(false)).unwrap().diagnosis;
    let mean = response.iter().sum::<f64>() / 800.0;
    let scatter = (response.iter().map(|y| (y - mean).powi(2)).sum::<f64>() / 800.0).sqrt();
    assert_ne!(found.verdict, Verdict::Agrees, "{}", found.says);
    // the prior of the level, 5 V wide, weighs nothing beside 800 rows; iterations end within a thousandth
    approx::assert_relative_eq!(found.fit.in_sample.rmse_before, scatter, max_relative = 2e-3);
}

/// The proof is a function of the user's own: an exception in it ends the whole diagnosis, even where it is thrown by the last question of all.
#[test]
fn a_simulator_is_never_asked_without_the_drivers_that_were_recorded() {
    let fan = |row: usize| (row as f64 / 40.0).sin();
    let inputs = Inputs {
        time_s: Some((0..900).map(f64::from).collect()),
        run: vec![1; 900],
        temperature_c: Some((0..900).map(|row| 22.0 + 5.0 * (f64::from(row) / 90.0).sin()).collect()),
        drivers: vec![Driver { name: "fan".into(), unit: "1/s".into(), values: (0..900).map(fan).collect() }],
        ..Inputs::default()
    };
    let warm = inputs.temperature_c.clone().unwrap();
    let simulator = Given { follows_driver: true, ..Given::with_level() };
    let response = noisy(7, |row| 3.0 + fan(row) + 0.02 * (warm[row] - 20.0), 900);
    let said = said(&simulator, &inputs, &response);
    assert!(said.findings.iter().any(|f| f.effect == "temperature_coefficient"), "{}", said.says);
    assert_eq!(simulator.asked_without.load(Ordering::Relaxed), 0);
}

/// A curve and a late clock, each of an eighth of the noise: tests see both, and neither is felt on rows left out. No rest says how the noise lasts, so that one that lasts does as much. Beside one
/// of the two tests see the other: that is no more reason to say that something is missing.
#[test]
fn what_all_together_is_hardly_felt_agrees_where_the_noise_was_not_measured() {
    let rows = 6000;
    let random = &mut ChaCha8Rng::seed_from_u64(31);
    let mut wander = (0.0, 0.0);
    let simulated: Vec<f64> = (0..rows)
        .map(|_| {
            let kick: f64 = StandardNormal.sample(random);
            wander.0 += -0.02 * wander.0 + 0.02 * kick;
            wander.1 += 0.1 * (wander.0 - wander.1);
            3.0 + 2.0 * wander.1
        })
        .collect();
    let slope = |row: usize| simulated[(row + 1).min(rows - 1)] - simulated[row.saturating_sub(1)];
    let curve = |row: usize| (simulated[row] - 3.0).powi(2);
    let rms = |of: &dyn Fn(usize) -> f64| {
        let mean = (0..rows).map(of).sum::<f64>() / rows as f64;
        ((0..rows).map(|row| (of(row) - mean).powi(2)).sum::<f64>() / rows as f64).sqrt()
    };
    let (late, bent) = (0.0013 / rms(&slope), 0.0013 / rms(&curve));
    let response = noisy(32, |row| simulated[row] + late * slope(row) + bent * curve(row), rows);
    let inputs = Inputs {
        time_s: Some((0..rows).map(|row| row as f64).collect()),
        run: vec![1; rows],
        simulated: Some(simulated.clone()),
        ..Inputs::default()
    };
    let said = said(&Given::fixed(), &inputs, &response);
    assert!(!said.noise.measured, "{}", said.noise.says);
    // each has 6000 x 0.13^2 = 100 squares of the noise, less what calibration and the other take of it
    let before = said.adequacy.before.unwrap();
    assert!(before.smooth.statistic > 60.0, "{before:?}");
    assert_eq!(said.verdict, Verdict::Agrees, "{}", said.says);
}
