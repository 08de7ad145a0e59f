//! One calibration of 7 000 rows: nine parameters with priors, white noise, from the centre of the prior.
//!
//! Run: `cargo bench -p truegap-benches --bench calibration`. Inputs are those of the model's tests (`truegap_model::cases::staircase`).

use criterion::{Criterion, criterion_group, criterion_main};
use std::hint::black_box;
use truegap_core::Simulator;
use truegap_diagnose::{
    Problem,
    calibration::{FitOptions, InputError, Model, Noise, Whitener, fit},
};
use truegap_model::{
    Stack, StackOptions,
    cases::{default_sensor, staircase},
};

/// Noise of the response, pF.
const NOISE_PF: f64 = 0.004;

fn calibration(c: &mut Criterion) {
    let Ok(sensor) = default_sensor() else { return eprintln!("the built-in sensor cannot be read") };
    let stack = Stack::new(&sensor, StackOptions::default());
    let inputs = staircase(7_000, sensor.full_scale);
    // a sensor one standard deviation off in every parameter
    let truth: Vec<f64> = stack.parameters().iter().map(|p| p.prior.at(1.0)).collect();
    let Ok(mut response) = stack.respond(&truth, &inputs, &[]) else { return eprintln!("the staircase closes the gap") };
    response.iter_mut().enumerate().for_each(|(row, value)| *value += NOISE_PF * (row as f64 * 12.9898).sin() * 1.414);
    let problem = Problem { inputs: &inputs, response: &response, simulator: &stack };
    let context = problem.context(2.4, NOISE_PF);
    let model = Model::new(&problem, &context, Vec::new());
    let noise = Noise { white_sd: NOISE_PF, ar_sd: 0.0, ar_correlation: 0.0 };
    let whitener = Whitener::new(&noise, &InputError::white(vec![0.0; response.len()]), None, &problem.runs(), None);
    let start = vec![0.0; model.parameters.len()];
    c.bench_function("calibration of 7 000 rows", |b| {
        b.iter(|| fit(&model, &whitener, black_box(&start), &FitOptions::default()))
    });
}

criterion_group!(benches, calibration);
criterion_main!(benches);
