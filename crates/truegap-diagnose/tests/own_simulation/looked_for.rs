//! What is not looked for, or not left out, where the recording cannot show it.

use crate::given::{Given, noisy, said, simulated};
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;
use rand_distr::{Distribution, StandardNormal};
use truegap_core::{Driver, Inputs};
use truegap_diagnose::quality::{Rows, repeated};
use truegap_diagnose::{Context, Problem, Verdict, library};

#[test]
fn friction_is_not_looked_for_where_nothing_turns() {
    let base = Given::with_level();
    let asked = |x: &dyn Fn(f64) -> f64| {
        let values = (0..200).map(|row| x(f64::from(row) / 200.0)).collect();
        let driver = Driver { name: "stage".into(), unit: "m".into(), values };
        let time = (0..200).map(f64::from).collect();
        let inputs = Inputs { time_s: Some(time), run: vec![1; 200], drivers: vec![driver], ..Inputs::default() };
        let context = Context::new(&inputs, &base, 1.0, 0.01);
        library().iter().find(|effect| effect.id().0 == "friction").unwrap().testable(&context)
    };
    let one_way = asked(&|t| 3.0 * t + 0.02 * (300.0 * t).sin()).unwrap_err();
    assert!(one_way.contains("stage") && one_way.contains("one way"), "{one_way}");
    assert!(asked(&|t| (7.0 * t).sin()).is_ok());
}

/// Set points in any order turn at every second row; that is no way that friction could hold back.
#[test]
fn friction_is_not_looked_for_in_a_table_of_set_points() {
    let base = Given::with_level();
    let asked = |values: Vec<f64>| {
        let driver = Driver { name: "stage".into(), unit: "m".into(), values };
        let inputs = Inputs { run: vec![1; 200], drivers: vec![driver], ..Inputs::default() };
        let context = Context::new(&inputs, &base, 1.0, 0.01);
        library().iter().find(|effect| effect.id().0 == "friction").unwrap().testable(&context).is_ok()
    };
    assert!(!asked((0..200).map(|row| f64::from(row * 77 % 200)).collect()));
    assert!(asked((0..200).map(|row| f64::from(100 - (row - 100i32).abs())).collect()));
}

/// Every fifth specimen of a table reads as the one before it. With a clock that is a logger that wrote old values again.
#[test]
fn rows_repeat_where_a_clock_says_that_they_follow_one_another() {
    let base = Given::with_level();
    let mut random = ChaCha8Rng::seed_from_u64(5);
    let mut response: Vec<f64> = Vec::new();
    for row in 0..400 {
        let unit: f64 = StandardNormal.sample(&mut random);
        let drawn = (1e4 * (3.0 + 0.05 * unit)).round() / 1e4;
        response.push(if row % 5 == 4 { response[row - 1] } else { drawn });
    }
    let said = |time_s: Option<Vec<f64>>| {
        let inputs = Inputs { time_s, run: vec![1; 400], ..Inputs::default() };
        let problem = Problem { inputs: &inputs, response: &response, simulator: &base };
        repeated(&problem, &Rows { inputs: &inputs, given: None, unit: "V" }).is_some()
    };
    assert!(said(Some((0..400).map(f64::from).collect())));
    assert!(!said(None));
}

/// A rudder that is told to stand still for some rows now and then, read in steps of 3 mrad, coarser than its noise: neighbouring rows are equal since nothing moves, and none is left out.
#[test]
fn a_reading_in_steps_does_not_repeat_where_what_it_follows_stands_still() {
    let told = |row: usize| 4.0 * ((row - (row % 12).min(3)) as f64 / 7.0).sin();
    let mut random = ChaCha8Rng::seed_from_u64(6);
    let mut read = |row: usize| {
        let unit: f64 = StandardNormal.sample(&mut random);
        ((told(row) + 0.0004 * unit) / 0.003).round() * 0.003
    };
    let response: Vec<f64> = (0..800).map(&mut read).collect();
    let inputs = Inputs {
        time_s: Some((0..800).map(f64::from).collect()),
        run: vec![1; 800],
        simulated: Some((0..800).map(told).collect()),
        ..Inputs::default()
    };
    let problem = Problem { inputs: &inputs, response: &response, simulator: &Given::fixed() };
    assert!(repeated(&problem, &Rows { inputs: &inputs, given: None, unit: "rad" }).is_none());
}

/// An encoder behind friction: it stands for some rows at each turn while the command moves on, and its step is near its noise. Three to fourteen rows were left out as old values of the
/// logger. Rows that were held on the way are found as before.
#[test]
fn a_reading_in_steps_does_not_repeat_where_friction_holds_it() {
    let told = |row: usize| 3.0 * (row as f64 / 60.0).sin();
    let read = |noise: f64, seed: u64, held: &dyn Fn(usize) -> bool| {
        let (mut random, mut at, mut last) = (ChaCha8Rng::seed_from_u64(seed), 0.0f64, 0.0f64);
        let mut one = |row: usize| {
            at = at.clamp(told(row) - 0.06, told(row) + 0.06);
            let unit: f64 = StandardNormal.sample(&mut random);
            last = if held(row) { last } else { ((at + noise * unit) / 0.005).round() * 0.005 };
            last
        };
        let response: Vec<f64> = (0..3000).map(&mut one).collect();
        let inputs = Inputs {
            time_s: Some((0..3000).map(f64::from).collect()),
            run: vec![1; 3000],
            simulated: Some((0..3000).map(told).collect()),
            ..Inputs::default()
        };
        let problem = Problem { inputs: &inputs, response: &response, simulator: &Given::fixed() };
        repeated(&problem, &Rows { inputs: &inputs, given: None, unit: "mm" }).map(|(_, rows)| rows)
    };
    for seed in 0..10 {
        for noise in [0.0, 0.001, 0.002, 0.004, 0.008] {
            assert_eq!(read(noise, seed, &|_| false), None, "noise {noise}, seed {seed}");
        }
        // four rows on the way, where it moves by ten steps from row to row
        assert_eq!(read(0.004, seed, &|row| (750..754).contains(&row)), Some((750..754).collect()), "seed {seed}");
    }
}

/// Two instruments on one quantity that wanders, each with noise of its own. A lag of the second behind the first smooths the noise of the first and errs less, and so does a mean without a delay.
#[test]
fn noise_of_the_column_that_is_followed_is_no_lag() {
    let rows = 1500;
    let random = &mut ChaCha8Rng::seed_from_u64(53);
    let mut wander = 0.0;
    let mut simulated = Vec::with_capacity(rows);
    let quantity: Vec<f64> = (0..rows)
        .map(|_| {
            let [kick, own]: [f64; 2] = [StandardNormal.sample(random), StandardNormal.sample(random)];
            wander += -0.01 * wander + 0.1 * kick;
            simulated.push(3.0 + wander + 0.15 * own);
            3.0 + wander
        })
        .collect();
    let time = (0..rows).map(|row| row as f64).collect();
    let inputs = Inputs { time_s: Some(time), run: vec![1; rows], simulated: Some(simulated), ..Inputs::default() };
    let response: Vec<f64> = quantity
        .iter()
        .map(|x| {
            x + 0.1 * {
                let own: f64 = StandardNormal.sample(random);
                own
            }
        })
        .collect();
    let said = said(&Given::fixed(), &inputs, &response);
    assert!(said.findings.is_empty(), "{}", said.says);
    assert!(said.recording_issues.iter().any(|doubt| doubt.contains("without a delay")), "{:?}", said.recording_issues);
}

/// The column of a simulation holds noise of its own, 0.05 V, five times that of the reading. Any lag smooths it and errs less; a mean to both sides does so as well. Without that rival a lag is named.
#[test]
fn a_lag_that_a_mean_to_both_sides_does_without_is_not_named() {
    let inputs = simulated();
    let truth = inputs.simulated.clone().unwrap();
    let read = noisy(31, |row| truth[row], truth.len());
    let random = &mut ChaCha8Rng::seed_from_u64(32);
    let with_noise = truth.iter().map(|value| value + 0.05 * Distribution::<f64>::sample(&StandardNormal, random)).collect();
    let said = said(&Given::fixed(), &Inputs { simulated: Some(with_noise), ..inputs }, &read);
    assert_eq!((said.verdict, said.findings.len()), (Verdict::Agrees, 0), "{}", said.says);
    assert!(said.says.contains("does not show what is quick in the simulated value"), "{}", said.says);
    let doubt = said.recording_issues.iter().find(|issue| issue.contains("to both sides"));
    assert!(
        doubt.is_some_and(|doubt| doubt.contains("may be noise of its own, so it is not claimed")),
        "{:?}",
        said.recording_issues
    );
    assert!(said.next_experiment.says.contains("stand still"), "{}", said.next_experiment.says);
}
