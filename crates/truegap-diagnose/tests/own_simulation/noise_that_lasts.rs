//! Slow noise of an instrument that is never at rest.

use crate::given::{Given, said, said_by};
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;
use rand_distr::{Distribution, StandardNormal};
use std::f64::consts::TAU;
use truegap_core::{Driver, Inputs};
use truegap_diagnose::Verdict;

const ROWS: usize = 1500;
/// Memories of noise with a spectrum like 1/f, rows.
const LIKE_ONE_OVER_F: &[f64] = &[2.0, 8.0, 32.0, 128.0];

/// A flow that begins to move after `rest` rows, and its reading: white noise of this size beside slow noise while it moves, whose parts have these `memories` in rows, and what is `beside` it at a row
/// with this flow.
struct Read<'a> {
    rest: usize,
    white: f64,
    memories: &'a [f64],
    seed: u64,
}

impl Read<'_> {
    fn inputs_and_response(&self, beside: impl Fn(usize, f64) -> f64) -> (Inputs, Vec<f64>) {
        let random = &mut ChaCha8Rng::seed_from_u64(self.seed);
        let mut unit = || -> f64 { StandardNormal.sample(random) };
        let time_s: Vec<f64> = (0..1500).map(f64::from).collect();
        let moves = |t: f64| 0.5 + 0.3 * (t / 40.0).sin() + 0.18 * (t / 17.0 + 1.0).sin();
        let start = self.rest as f64;
        let flow: Vec<f64> = time_s.iter().map(|t| moves(t.max(start))).collect();
        let keeps: Vec<f64> = self.memories.iter().map(|memory| (-1.0 / memory).exp()).collect();
        let mut parts = vec![0.0; keeps.len()];
        let mut read = |(row, x): (usize, &f64)| {
            for (part, keeps) in parts.iter_mut().zip(&keeps).filter(|_| row >= self.rest) {
                *part = keeps * *part + (1.0 - keeps * keeps).sqrt() * unit();
            }
            3.0 + x + beside(row, *x) + 0.006 * (parts.iter().sum::<f64>() + self.white * unit())
        };
        let response = flow.iter().enumerate().map(&mut read).collect();
        let drivers = vec![Driver { name: "flow".into(), unit: "l/s".into(), values: flow }];
        (Inputs { time_s: Some(time_s), run: vec![1; ROWS], drivers, ..Inputs::default() }, response)
    }
}

fn model() -> Given {
    Given { follows_driver: true, ..Given::with_level() }
}

/// White noise, the memories of slow noise beside it, and seeds with which something was said to be missing while short stretches alone told the noise: "cause cannot be decided", a relaxation, nothing in the library,
/// a change of regime that rows left out contradict.
const READ: [(f64, &[f64], u64); 4] = [(0.3, &[8.0], 3), (1.0, &[30.0], 0), (0.3, LIKE_ONE_OVER_F, 0), (0.3, LIKE_ONE_OVER_F, 1)];

#[test]
fn slow_noise_is_no_mismatch_where_nothing_foretells_it() {
    for (white, memories, seed) in READ {
        let (inputs, response) = Read { rest: 0, white, memories, seed }.inputs_and_response(|_, _| 0.0);
        let said = said(&model(), &inputs, &response);
        assert_eq!(
            (said.verdict, said.findings.len(), said.discovered.len()),
            (Verdict::Agrees, 0, 0),
            "seed {seed}: {}",
            said.says
        );
    }
}

/// A curve of 50 mV beside noise of 6 to 12 mV.
#[test]
fn a_curve_beside_slow_noise_is_still_found() {
    for (white, memories, seed) in [READ[1], READ[2]] {
        let curve = |_, x: f64| 0.2 * x * (1.0 - x);
        let (inputs, response) = Read { rest: 0, white, memories, seed }.inputs_and_response(curve);
        let said = said(&model(), &inputs, &response);
        let named: Vec<&str> = said.findings.iter().map(|f| f.effect.as_str()).collect();
        assert!(named.contains(&"nonlinearity"), "seed {seed}: {:?} {}", said.verdict, said.says);
        // where nothing may be named that follows it, a curve through the flow says that it is there
        let said = said_by(&["friction"], &model(), &inputs, &response);
        assert_ne!(said.verdict, Verdict::Agrees, "seed {seed}: {}", said.says);
    }
}

/// Noise that was measured at rest, and a reading that wanders as soon as the flow moves.
#[test]
fn what_wanders_at_work_alone_is_more_than_a_noise_that_was_measured() {
    let (inputs, response) = Read { rest: 500, white: 0.3, memories: LIKE_ONE_OVER_F, seed: 0 }.inputs_and_response(|_, _| 0.0);
    let said = said(&model(), &inputs, &response);
    assert!(said.noise.measured, "{}", said.noise.says);
    assert_ne!(said.verdict, Verdict::Agrees, "{}", said.says);
}

/// Tones of 0.4 and of 2 times the noise, where no words are asked.
#[test]
fn a_faint_tone_is_told_and_a_loud_one_is_the_matter() {
    let read = Read { rest: 0, white: 1.0, memories: &[], seed: 2 };
    let with_tone = |loud: f64| {
        let (inputs, response) = read.inputs_and_response(|row, _| 0.006 * loud * (TAU * 0.137 * row as f64).sin());
        said_by(&["friction"], &model(), &inputs, &response)
    };
    let faint = with_tone(0.4);
    assert_eq!(faint.verdict, Verdict::Agrees, "{}", faint.says);
    assert!(faint.says.contains("the reading holds a tone at 0.1370 Hz"), "{}", faint.says);
    let loud = with_tone(2.0);
    assert_eq!(loud.verdict, Verdict::Unexplained, "{}", loud.says);
}

/// A cell that fails in a twelfth of the rows, by 0.3 V one way or the other: nothing foretells it, and it is no noise.
#[test]
fn what_is_louder_than_slow_noise_is_there() {
    let fails = |row: usize, _: f64| if (700..825).contains(&row) { 0.3 * (row as f64).powi(2).sin().signum() } else { 0.0 };
    let (inputs, response) = Read { rest: 0, white: 1.0, memories: &[8.0], seed: 1 }.inputs_and_response(fails);
    let said = said(&model(), &inputs, &response);
    assert_ne!(said.verdict, Verdict::Agrees, "{}", said.says);
}

/// A clock beside a better one goes at another rate, and its phase wanders from row to row: a drift and a change of regime take that apart and are less likely than the walk alone, a drift beside the walk is much likelier.
#[test]
fn a_clock_that_wanders_and_goes_at_another_rate_drifts() {
    const CLOCK: usize = 900;
    let random = &mut ChaCha8Rng::seed_from_u64(7);
    let mut unit = || -> f64 { StandardNormal.sample(random) };
    let mut wandered = 0.0;
    let mut read = |row: usize| {
        let share = row as f64 / CLOCK as f64;
        wandered += 0.7 / (CLOCK as f64).sqrt() * unit();
        3.0 + 3.5 * share + wandered + 0.03 * unit()
    };
    let response: Vec<f64> = (0..CLOCK).map(&mut read).collect();
    let time_s = (0..CLOCK).map(|row| 300.0 * row as f64).collect();
    let inputs = Inputs { time_s: Some(time_s), run: vec![1; CLOCK], ..Inputs::default() };
    let said = said(&Given::with_level(), &inputs, &response);
    let named: Vec<&str> = said.findings.iter().map(|f| f.effect.as_str()).collect();
    assert_eq!(named, ["offset_drift"], "{}", said.says);
    // the walk goes 0.7 over the recording, and a sixth of it is left out: 0.3 as its root mean square there
    let held = &said.fit.held_out;
    assert!(held.rmse_after.unwrap() < 0.35 && held.rmse_before.unwrap() > 0.8, "{held:?}");
}
