//! A cause that the library does not hold is called `unexplained`; one that it holds keeps its name.

#![allow(clippy::unwrap_used)]

mod common;

use common::{Plate, recording};
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;
use rand_distr::{Distribution, StandardNormal};
use std::sync::atomic::AtomicBool;
use truegap_core::{Inputs, Simulator};
use truegap_diagnose::{Diagnosis, Options, Problem, RecordingFacts, Verdict, diagnose};

/// Noise of the reading, pF.
const NOISE: f64 = 0.004;

/// The diagnosis of the plate's own reading with noise and with what `added` puts on each row.
fn said_of(added: impl Fn(&Inputs, usize) -> f64) -> Diagnosis {
    said_with(&Options::default(), added)
}

fn said_with(options: &Options, added: impl Fn(&Inputs, usize) -> f64) -> Diagnosis {
    let (plate, inputs) = (Plate::new(Some(true)), recording());
    let random = &mut ChaCha8Rng::seed_from_u64(11);
    let mut response = plate.respond(&[10.4, 6.6], &inputs, &[]).unwrap();
    for (row, value) in response.iter_mut().enumerate() {
        let drawn: f64 = StandardNormal.sample(random);
        *value += NOISE * drawn + added(&inputs, row);
    }
    let problem = Problem { inputs: &inputs, response: &response, simulator: &plate };
    let facts = RecordingFacts { rows: response.len(), runs: inputs.runs().len(), ..RecordingFacts::default() };
    diagnose(&problem, facts, options, &|_| (), &AtomicBool::new(false)).unwrap().diagnosis
}

/// A zero that wanders over minutes, by some ten times the noise: slower than the noise, faster than a drift, and with no input of the recording.
fn wandering(inputs: &Inputs, row: usize) -> f64 {
    let t = inputs.time_s.as_ref().unwrap()[row];
    let tone = |period: f64, phase: f64| (std::f64::consts::TAU * t / period + phase).sin();
    6.0 * NOISE * (tone(700.0, 0.3) + tone(431.0, 1.0) + tone(1130.0, 2.0))
}

#[test]
fn a_zero_that_wanders_is_not_given_the_name_of_a_drift() {
    let said = said_of(wandering);
    assert_eq!((said.verdict, said.findings.len()), (Verdict::Unexplained, 0), "{}", said.says);
}

#[test]
fn a_zero_that_is_another_in_each_run_keeps_its_name() {
    let first = recording().run[0];
    let said = said_of(|inputs, row| if inputs.run[row] == first { 0.0 } else { 0.02 * f64::from(inputs.run[row] % 7) / 7.0 });
    let named: Vec<&str> = said.findings.iter().map(|f| f.effect.as_str()).collect();
    assert_eq!((said.verdict, named), (Verdict::Explained, vec!["offset_steps"]), "{}", said.says);
}

#[test]
fn a_reading_that_follows_the_speed_of_the_load_is_not_called_another_zero_in_each_run() {
    let said = said_of(|inputs, row| {
        let (time, force) = (inputs.time_s.as_ref().unwrap(), inputs.force_n.as_ref().unwrap());
        let before = row.saturating_sub(1);
        let speed = if row > 0 && inputs.run[row] == inputs.run[before] {
            (force[row] - force[before]) / (time[row] - time[before])
        } else {
            0.0
        };
        4.0 * NOISE * (speed / 2.0).powi(2).min(1.0)
    });
    // no effect of the library is named; what is composed of words says what it follows
    assert!(said.findings.iter().all(|f| f.effect.starts_with("discovered")), "{}", said.says);
    assert!(said.says.contains("how fast the load changes"), "{}", said.says);
    let found = &said.discovered[0];
    assert!(found.named && found.probability.driver["load_rate"] > 0.9, "{:?}", found.probability);
}

/// Less than half as large as the noise of a row: no run by itself shows it, and means of rows silence it.
#[test]
fn a_faint_tone_is_said_to_be_one() {
    let said = said_of(|inputs, row| 0.42 * NOISE * (0.55 * inputs.time_s.as_ref().unwrap()[row]).sin());
    assert_eq!((said.verdict, said.findings.len()), (Verdict::Unexplained, 0), "{}", said.says);
    assert!(said.says.contains("a tone at 0.087") && said.adequacy.interference, "{}", said.says);
    assert!(said.next_experiment.says.contains("sampling rate"), "{}", said.next_experiment.says);
}

/// Mains is the electronics' own: an effect that holds less than it keeps its name, and both are said.
#[test]
fn a_steady_tone_takes_no_name_away() {
    let first = recording().run[0];
    let said = said_of(|inputs, row| {
        let zero = if inputs.run[row] == first { 0.0 } else { 5.0 * NOISE * f64::from(inputs.run[row] % 7) / 7.0 };
        zero + 1.2 * NOISE * (0.55 * inputs.time_s.as_ref().unwrap()[row]).sin()
    });
    assert_eq!((said.verdict, said.findings.len()), (Verdict::Ambiguous, 1), "{}", said.says);
    assert!(said.says.contains("offset_drift or offset_steps"), "{}", said.says);
    let tone = said.adequacy.tone.unwrap();
    assert!(tone.steady && said.says.contains("a tone at 0.087"), "{tone:?} {}", said.says);
}

#[test]
fn no_unmodelled_cause_is_claimed_where_nothing_is_missing() {
    let said = said_of(|_, _| 0.0);
    assert_eq!(said.verdict, Verdict::Agrees, "{}", said.says);
}

/// A zero that wanders, and a library of one effect that cannot follow it: within the library nothing is the likeliest by far, beside unmodelled causes it is not.
#[test]
fn all_probabilities_are_on_one_scale() {
    let options = Options { effects: vec!["thermal_lag".into()], ..Options::default() };
    let said = said_with(&options, wandering);
    let unmodelled: f64 = said.unmodelled.iter().map(|cause| cause.probability).sum();
    assert!(unmodelled > 0.9, "{unmodelled}");
    assert!(said.probability_agrees + unmodelled < 1.0 + 1e-9, "{} and {unmodelled}", said.probability_agrees);
}
