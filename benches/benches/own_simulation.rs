//! One diagnosis of 1 000 rows beside a simulation of one's own, which the recording follows late, by a power of what is left: what takes longest of recordings by other people, since rows left out choose there.
//!
//! Run: `cargo bench -p truegap-benches --bench own_simulation`; on a machine that others use, count instructions instead: `valgrind --tool=callgrind` on the built bench with `--test`,
//! which diagnoses once. Limits: one cause, one base model, white noise.

use criterion::{Criterion, criterion_group, criterion_main};
use std::hint::black_box;
use std::sync::atomic::AtomicBool;
use truegap_core::Inputs;
use truegap_diagnose::{Known, Options, Problem, diagnose};
use truegap_model::{External, ExternalOptions, ResponseScale};

/// Rows, one a minute.
const ROWS: usize = 1_000;
/// Time constant where the difference is [`AT`], s, and the power of the difference in the speed, less 1: a tank that empties through a hole.
const LAG: (f64, f64) = (900.0, -0.5);
/// Difference at which the time constant is that of [`LAG`], m.
const AT: f64 = 0.5;
/// Noise of the response, m.
const NOISE_M: f64 = 0.01;
/// Parts of a step of the generator, explicit and so small that they need no rule.
const PARTS: usize = 200;

/// What the simulation says, m: two tides, one much quicker.
fn simulated(row: usize) -> f64 {
    (0.01 * row as f64).sin() + 0.4 * (0.13 * row as f64).cos()
}

/// The reading, m.
fn recorded() -> Vec<f64> {
    let mut level = simulated(0);
    let mut row_by_row = |row: usize| {
        for part in 0..PARTS {
            let share = part as f64 / PARTS as f64;
            let left = simulated(row) + share * (simulated(row + 1) - simulated(row)) - level;
            level += 60.0 / (PARTS as f64 * LAG.0) * left * (left.abs() / AT).max(1e-3).powf(LAG.1);
        }
        // a scrambled counter: white enough, and the same in each run
        level + 3.46 * NOISE_M * (((row * row * 7919 + row * 104_729) % 1009) as f64 / 1009.0 - 0.5)
    };
    (0..ROWS).map(&mut row_by_row).collect()
}

fn own_simulation(c: &mut Criterion) {
    let response = recorded();
    let inputs = Inputs {
        time_s: Some((0..ROWS).map(|row| 60.0 * row as f64).collect()),
        simulated: Some((0..ROWS).map(simulated).collect()),
        run: vec![1; ROWS],
        ..Inputs::default()
    };
    let scale = ResponseScale { unit: "m".into(), range: 2.8, ..ResponseScale::default() };
    let free = ExternalOptions { gain_sd: Some(0.3), offset: true, own_unit: None };
    let base = External::new(&scale, 20.0, free);
    let problem = Problem { inputs: &inputs, response: &response, simulator: &base };
    let options = Options::default();
    let mut group = c.benchmark_group("diagnosis beside a simulation");
    group.sample_size(10);
    group.bench_function("1 000 rows that follow late by a power", |b| {
        b.iter(|| diagnose(black_box(&problem), Known::default(), &options, &|_| (), &AtomicBool::new(false)).is_ok())
    });
    group.finish();
}

criterion_group!(benches, own_simulation);
criterion_main!(benches);
