//! One diagnosis of 7 000 rows with the whole library: thirty effects alone, pairs and triples of the best, evidence, rows left out.
//!
//! Run: `cargo bench -p truegap-benches --bench library`; on a machine that others use, count instructions instead: `valgrind --tool=callgrind` on the built bench with `--test`,
//! which diagnoses once. The recording is generated here: a stack whose dielectric goes on giving way for half a minute, on staircases of load while the temperature sweeps.
//! Limits: one cause, white noise.

use criterion::{Criterion, criterion_group, criterion_main};
use std::hint::black_box;
use std::sync::atomic::AtomicBool;
use truegap_core::{Drive, Inputs, Simulator, Stage};
use truegap_diagnose::{Known, Options, Problem, diagnose};
use truegap_model::{
    Stack, StackOptions,
    cases::{default_sensor, staircase},
};

/// Noise of the response, pF.
const NOISE_PF: f64 = 0.004;
/// Rows, at ten a second.
const ROWS: usize = 7_000;
/// Share of the elastic strain that is late, and its time constant, s.
const LATE: (f64, f64) = (0.04, 30.0);

/// Strain of which a share is late.
struct Late;

impl Stage for Late {
    fn strain(&self, drive: &Drive<'_>, strain: &mut [f64]) {
        let steps = drive.inputs.steps_s();
        let mut late = 0.0;
        for (strain, step) in strain.iter_mut().zip(steps) {
            late += (*strain - late) * (1.0 - (-step / LATE.1).exp());
            *strain += LATE.0 * late;
        }
    }
}

/// The reading of such a stack, every parameter a third of a standard deviation off, with noise, pF.
fn recorded(stack: &Stack, inputs: &Inputs) -> Option<Vec<f64>> {
    let truth: Vec<f64> = stack.parameters().iter().map(|p| p.prior.at(0.3)).collect();
    let clean = stack.respond(&truth, inputs, &[&Late]).ok()?;
    // a scrambled counter: white enough, and the same in each run
    let noise = |row: usize| 3.46 * NOISE_PF * (((row * row * 7919 + row * 104_729) % 1009) as f64 / 1009.0 - 0.5);
    Some(clean.iter().enumerate().map(|(row, c)| c + noise(row)).collect())
}

fn library(c: &mut Criterion) {
    let Ok(sensor) = default_sensor() else { return eprintln!("the built-in sensor cannot be read") };
    let stack = Stack::new(&sensor, StackOptions::default());
    let inputs = staircase(ROWS, sensor.full_scale);
    let Some(response) = recorded(&stack, &inputs) else { return eprintln!("the staircase closes the gap") };
    let problem = Problem { inputs: &inputs, response: &response, simulator: &stack };
    let options = Options::default();
    let mut group = c.benchmark_group("diagnosis");
    group.sample_size(10);
    group.bench_function("7 000 rows, the whole library", |b| {
        b.iter(|| diagnose(black_box(&problem), Known::default(), &options, &|_| (), &AtomicBool::new(false)).is_ok())
    });
    group.finish();
}

criterion_group!(benches, library);
criterion_main!(benches);
