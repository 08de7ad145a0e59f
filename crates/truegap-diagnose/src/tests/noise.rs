//! How loud the noise is: never louder than what a model leaves over.

use crate::{
    Diagnosis, Options, Problem, RecordingFacts, Verdict,
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

/// White noise beside noise of one memory, each with its standard deviation.
fn coloured(random: &mut ChaCha8Rng, rows: usize, [white, ar]: [f64; 2], correlation: f64) -> Vec<f64> {
    let (mut state, fresh) = (ar * drawn(random), ar * (1.0 - correlation * correlation).sqrt());
    let next = |_| {
        state = correlation * state + fresh * drawn(random);
        state + white * drawn(random)
    };
    (0..rows).map(next).collect()
}

/// Six runs of steps of the load, a step each twenty rows; four of them begin with fifty rows at rest, and two hundred such rows do not show a memory of two rows.
fn little_rest() -> Inputs {
    let rows = 6 * 300;
    let rest = |row: usize| if row < 4 * 300 { 50 } else { 0 };
    let steps = |row: usize| (row % 300).saturating_sub(rest(row)).div_ceil(20);
    Inputs {
        run: (0..rows).map(|row| 1 + (row / 300) as u32).collect(),
        time_s: Some((0..rows).map(|row| row as f64 + 900.0 * (row / 300) as f64).collect()),
        force_n: Some((0..rows).map(|row| (3 * steps(row) % 7) as f64 * 0.6).collect()),
        temperature_c: Some((0..rows).map(|row| 22.0 + 4.0 * (row / 300) as f64).collect()),
        ..Inputs::default()
    }
}

/// What is said of a plate with little rest, given what its reading has beside the truth.
fn said_with_little_rest(beside: &[f64]) -> Diagnosis {
    let (plate, inputs) = (Plate::new(Some(true)), little_rest());
    let mut response = plate.respond(&TRUE, &inputs, &[]).unwrap();
    response.iter_mut().zip(beside).for_each(|(value, beside)| *value += beside);
    let problem = Problem { inputs: &inputs, response: &response, simulator: &plate };
    let facts = RecordingFacts { rows: response.len(), runs: 6, ..RecordingFacts::default() };
    let options = Options { effects: vec!["offset_steps".into(), "offset_drift".into()], ..Options::default() };
    diagnose(&problem, facts, &options, &|_| (), &AtomicBool::new(false)).unwrap().diagnosis
}

/// The zero jumps at three borders of runs by as much as the noise or half of it. The noise has a memory of two rows. Rest does not show that memory, and slow noise, which has some memory at least, was taken for it: for six of 24 seeds by the whole
/// recording (the first one here), for nine by rest itself (the second one); beside smaller jumps nothing was missing then (the third one).
#[test]
fn where_rest_shows_no_memory_jumps_of_a_zero_are_no_slow_noise() {
    for (seed, jump) in [(2, 0.9), (14, 0.9), (14, 0.5)] {
        let noise = coloured(&mut ChaCha8Rng::seed_from_u64(seed), little_rest().len(), [0.77 * NOISE, 0.63 * NOISE], 0.5);
        let jumps = [0.0, 1.0, 1.0, 2.0, 2.0, 3.0];
        let beside: Vec<f64> = noise.iter().enumerate().map(|(row, noise)| jump * NOISE * jumps[row / 300] + noise).collect();
        let said = said_with_little_rest(&beside);
        assert!(!said.noise.says.contains("1/f"), "{seed}: {}", said.noise.says);
        assert_ne!(said.verdict, Verdict::Agrees, "{seed}: {}", said.says);
        // of 1800 rows, a third of them with a memory of two rows
        approx::assert_relative_eq!(said.noise.white_sd.hypot(said.noise.ar_sd), NOISE, max_relative = 0.1);
    }
}

/// The same rest beside slow noise: parts whose memories lie a factor of four apart, which are not the model's own.
#[test]
fn where_rest_shows_slow_noise_that_the_whole_recording_has_it_stays() {
    let random = &mut ChaCha8Rng::seed_from_u64(5);
    let rows = little_rest().len();
    let mut noise = coloured(random, rows, [NOISE, 0.0], 0.5);
    for memory in (0..7).map(|k| 3.0 * 4f64.powi(k)) {
        let part = coloured(random, rows, [0.0, 0.4 * NOISE], (-1.0 / memory).exp());
        noise.iter_mut().zip(part).for_each(|(noise, part)| *noise += part);
    }
    let said = said_with_little_rest(&noise);
    assert!(said.noise.says.ends_with("slow like 1/f"), "{}", said.noise.says);
    assert_eq!(said.verdict, Verdict::Agrees, "{}", said.says);
}
