//! Mechanisms screened in a second: a diagnosis that composes them less the same diagnosis that does not, over the columns that were weighed.
//!
//! Run: `cargo bench -p truegap-benches --bench mechanisms`. The recording holds what no library lists, a disturbance by the root of the loading speed;
//! two effects only are tried beside it, so that most of the time is the search for words. Limits: fits of the most promising mechanisms and their
//! control count as well, so the screen alone is faster.

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use std::hint::black_box;
use std::sync::atomic::AtomicBool;
use std::time::{Duration, Instant};
use truegap_core::{Inputs, Simulator};
use truegap_diagnose::{Known, Options, Outcome, Problem, diagnose};
use truegap_model::{Stack, StackOptions, cases::default_sensor};

/// Noise of the response, pF.
const NOISE_PF: f64 = 0.004;
/// Disturbance at one newton a second, pF.
const PICKUP_PF: f64 = 0.02;
/// Rows, at ten a second.
const ROWS: usize = 3_000;

/// Presses of several speeds at a temperature that wanders.
fn presses(full_load_n: f64) -> Inputs {
    let seconds = |row: usize| 0.1 * row as f64;
    let load = |row: usize| {
        let (press, within) = (row / 150, (row % 150) as f64);
        let speed = [10.0, 25.0, 60.0][press % 3];
        full_load_n * (0.4 + 0.1 * (press % 7) as f64).min(1.0) * (within / speed).min(1.0).min((149.0 - within) / speed)
    };
    Inputs {
        time_s: Some((0..ROWS).map(seconds).collect()),
        run: vec![1; ROWS],
        force_n: Some((0..ROWS).map(load).collect()),
        temperature_c: Some((0..ROWS).map(|row| 24.0 + 4.0 * (seconds(row) / 40.0).sin()).collect()),
        ..Inputs::default()
    }
}

/// The reading of a stack with the disturbance, pF.
fn disturbed(stack: &Stack, inputs: &Inputs) -> Option<Vec<f64>> {
    let centre: Vec<f64> = stack.parameters().iter().map(|p| p.prior.at(0.0)).collect();
    let clean = stack.respond(&centre, inputs, &[]).ok()?;
    let load = inputs.force_n.as_ref()?;
    let speed = |row: usize| (load[row] - load[row.saturating_sub(1)]).abs() / 0.1;
    // two incommensurable tones and a scrambled counter: white enough, and the same in each run
    let noise = |row: usize| 3.46 * NOISE_PF * (((row * row * 7919 + row * 104_729) % 1009) as f64 / 1009.0 - 0.5);
    Some(clean.iter().enumerate().map(|(row, c)| c + PICKUP_PF * speed(row).sqrt() + noise(row)).collect())
}

fn mechanisms(c: &mut Criterion) {
    let Ok(sensor) = default_sensor() else { return eprintln!("the built-in sensor cannot be read") };
    let stack = Stack::new(&sensor, StackOptions::default());
    let inputs = presses(sensor.full_scale);
    let Some(response) = disturbed(&stack, &inputs) else { return eprintln!("the presses close the gap") };
    let problem = Problem { inputs: &inputs, response: &response, simulator: &stack };
    let effects = ["readout_lag", "offset_drift"].map(str::to_owned).to_vec();
    let run = |compose: bool| -> Option<Outcome> {
        let options = Options { compose, effects: effects.clone(), ..Options::default() };
        diagnose(black_box(&problem), Known::default(), &options, &|_| (), &AtomicBool::new(false)).ok()
    };
    let Some(weighed) = run(true).and_then(|found| Some(found.diagnosis.discovered.first()?.weighed)) else {
        return eprintln!("no mechanism was found, so nothing was screened");
    };
    let mut group = c.benchmark_group("mechanisms");
    group.sample_size(10).throughput(Throughput::Elements(weighed as u64));
    group.bench_function("found by words", |b| {
        b.iter_custom(|times| {
            (0..times)
                .map(|_| {
                    let timed = |compose: bool| {
                        let start = Instant::now();
                        black_box(run(compose));
                        start.elapsed()
                    };
                    let (with, without) = (timed(true), timed(false));
                    with.saturating_sub(without).max(Duration::from_micros(1))
                })
                .sum()
        });
    });
    group.finish();
}

criterion_group!(benches, mechanisms);
criterion_main!(benches);
