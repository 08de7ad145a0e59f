//! How loud the noise is: never louder than what a model leaves over.

use crate::{
    Options, Problem, RecordingFacts, Verdict,
    common::{Plate, recording},
    diagnose,
    noise::{
        rescale::quieter_than,
        several::{measured, with_wild_rows},
    },
};
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;
use rand_distr::{Distribution, StandardNormal};
use std::sync::atomic::AtomicBool;
use truegap_core::{Inputs, Simulator};

/// Noise of the reading, pF.
const NOISE: f64 = 0.004;
/// True parameters of the plate.
const TRUE: [f64; 2] = [10.4, 6.6];

fn drawn(random: &mut ChaCha8Rng) -> f64 {
    StandardNormal.sample(random)
}

#[test]
fn a_noise_taken_three_times_too_loud_is_found_out_and_a_right_one_is_left_alone() {
    let (plate, inputs) = (Plate::new(Some(true)), recording());
    let random = &mut ChaCha8Rng::seed_from_u64(3);
    let misfit: Vec<f64> = (0..inputs.len()).map(|_| NOISE * drawn(random)).collect();
    let clean = plate.respond(&TRUE, &inputs, &[]).unwrap();
    let response: Vec<f64> = clean.iter().zip(&misfit).map(|(c, m)| c + m).collect();
    let problem = Problem { inputs: &inputs, response: &response, simulator: &plate };
    let (_, noise) = measured(&problem).unwrap();
    assert!(quieter_than(&problem, &misfit, &noise).is_none());
    let found = quieter_than(&problem, &misfit, &noise.scaled(3.0)).unwrap();
    // from some hundred rows at rest: 10 %
    approx::assert_relative_eq!(found.response.white_sd.hypot(found.response.ar_sd), NOISE, max_relative = 0.15);
}

/// What a model of the wrong form leaves is slow and three times as large as the noise. One row is wild beside it: that row weighs less, and the others are as quiet as before.
#[test]
fn a_wild_row_makes_the_other_rows_no_louder() {
    let (plate, inputs) = (Plate::new(Some(true)), recording());
    let random = &mut ChaCha8Rng::seed_from_u64(4);
    let clean = plate.respond(&TRUE, &inputs, &[]).unwrap();
    let response: Vec<f64> = clean.iter().map(|c| c + NOISE * drawn(random)).collect();
    let problem = Problem { inputs: &inputs, response: &response, simulator: &plate };
    let (_, noise) = measured(&problem).unwrap();
    let wild = inputs.len() / 2 + 7;
    let slow = |row: usize| 3.0 * NOISE * (row as f64 / 40.0).sin();
    let misfit: Vec<f64> =
        (0..inputs.len()).map(|row| slow(row) + NOISE * drawn(random) + if row == wild { 80.0 * NOISE } else { 0.0 }).collect();
    let found = with_wild_rows(&problem, &misfit, &noise).unwrap();
    let size = |noise: &crate::whitening::noise_model::NoiseModel| noise.response.white_sd.hypot(noise.response.ar_sd);
    assert!(found.input_error.louder[wild] > (20.0 * NOISE).powi(2), "{}", found.input_error.louder[wild]);
    assert!(size(&found) <= size(&noise), "{} against {}", size(&found), size(&noise));
}

/// A load that somebody's hand makes: its speed is pushed at random four times as hard as its noise is large, so that no straight line holds and differences of
/// any order overstate the noise.
fn by_hand(random: &mut ChaCha8Rng) -> (Inputs, Inputs) {
    let (rows, noise_n) = (1500, 0.005);
    let (mut force, mut speed) = (2.0, 0.0);
    let mut truth = Inputs { time_s: Some(vec![]), force_n: Some(vec![]), temperature_c: Some(vec![]), ..Inputs::default() };
    for row in 0..rows {
        speed = 0.95 * speed + 0.02 * drawn(random);
        force += speed;
        if !(0.1..4.4).contains(&force) {
            (force, speed) = (force.clamp(0.1, 4.4), -speed);
        }
        truth.run.push(1);
        truth.time_s.as_mut().unwrap().push(0.2 * f64::from(row));
        truth.force_n.as_mut().unwrap().push(force);
        truth.temperature_c.as_mut().unwrap().push(24.0 + 4.0 * (f64::from(row) / 400.0).sin());
    }
    let mut recorded = truth.clone();
    recorded.force_n.as_mut().unwrap().iter_mut().for_each(|f| *f += noise_n * drawn(random));
    (truth, recorded)
}

#[test]
fn a_load_that_bends_all_the_time_makes_no_noise_of_itself() {
    let plate = Plate::new(Some(true));
    let random = &mut ChaCha8Rng::seed_from_u64(8);
    let (truth, recorded) = by_hand(random);
    let mut response = plate.respond(&TRUE, &truth, &[]).unwrap();
    response.iter_mut().for_each(|r| *r += NOISE * drawn(random));
    let problem = Problem { inputs: &recorded, response: &response, simulator: &plate };
    let facts = RecordingFacts { rows: response.len(), runs: 1, ..RecordingFacts::default() };
    let said = diagnose(&problem, facts, &Options::default(), &|_| (), &AtomicBool::new(false)).unwrap().diagnosis;
    assert_eq!(said.verdict, Verdict::Agrees, "{}", said.says);
    let left = said.adequacy.before.unwrap().stretches;
    let loudness = left.statistic / left.freedom as f64;
    // 1 with a noise that is known; differences of the load alone make it a tenth. Up to 0.7 of the variance is left alone, and the courses that the
    // error of the load may follow take up part of what is there.
    assert!((0.3..1.4).contains(&loudness), "{loudness}");
}

/// Five rows at each of forty points of load and temperature, ten minutes apart: three of five second differences would span a pause.
#[test]
fn points_measured_with_pauses_between_them_are_not_joined_by_lines() {
    let plate = Plate::new(Some(true));
    let random = &mut ChaCha8Rng::seed_from_u64(21);
    let mut truth = Inputs { time_s: Some(vec![]), force_n: Some(vec![]), temperature_c: Some(vec![]), ..Inputs::default() };
    for row in 0..200_u32 {
        let point = row / 5;
        truth.run.push(1);
        truth.time_s.as_mut().unwrap().push(600.0 * f64::from(point) + f64::from(row % 5));
        truth.force_n.as_mut().unwrap().push(if point % 2 == 1 { 4.5 } else { 0.0 });
        truth.temperature_c.as_mut().unwrap().push(20.0 + 15.0 * f64::from(point / 2 % 3));
    }
    let mut response = plate.respond(&TRUE, &truth, &[]).unwrap();
    response.iter_mut().for_each(|r| *r += NOISE * drawn(random));
    let mut recorded = truth;
    recorded.force_n.as_mut().unwrap().iter_mut().for_each(|f| *f += 0.005 * drawn(random));
    let problem = Problem { inputs: &recorded, response: &response, simulator: &plate };
    let facts = RecordingFacts { rows: response.len(), runs: 1, ..RecordingFacts::default() };
    let said = diagnose(&problem, facts, &Options::default(), &|_| (), &AtomicBool::new(false)).unwrap().diagnosis;
    assert_eq!(said.verdict, Verdict::Agrees, "{}", said.says);
    // 120 second differences of three rows each, in full loads of 4.5 N
    approx::assert_relative_eq!(said.noise.load_sd, 0.005, max_relative = 0.3);
}
