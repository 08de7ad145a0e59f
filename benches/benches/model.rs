//! The analytic model: the capacitance integral two ways, one evaluation of the sensor, one set of coefficients, one pass over 7 000 rows.
//!
//! Run: `cargo bench -p truegap-benches --bench model`. The problems are those of the tests (`truegap_model::cases`).

use criterion::{Criterion, criterion_group, criterion_main};
use std::hint::black_box;
use truegap_core::Simulator;
use truegap_model::{
    CoefficientOptions, Stack, StackOptions,
    cases::{bent_plates, default_sensor, staircase},
    coefficients,
    equations::quadrature::plate_integral_by_quadrature,
};

/// Asked of the quadrature: what it needs to match the closed form to 1e-13.
const SAME_ACCURACY: f64 = 1e-12;

fn integral(c: &mut Criterion) {
    let mut group = c.benchmark_group("capacitance integral");
    for (name, plates) in bent_plates() {
        group.bench_function(format!("closed form, {name}"), |b| b.iter(|| black_box(plates).integral()));
    }
    group.sample_size(10);
    for (name, plates) in bent_plates() {
        group.bench_function(format!("double integral, {name}"), |b| {
            b.iter(|| plate_integral_by_quadrature(black_box(plates), SAME_ACCURACY))
        });
    }
    group.finish();
}

fn sensor(c: &mut Criterion) {
    let Ok(sensor) = default_sensor() else { return eprintln!("the built-in sensor cannot be read") };
    let stack = Stack::new(&sensor, StackOptions::default());
    let values: Vec<f64> = stack.parameters().iter().map(|p| p.centre()).collect();
    let device = stack.device(&values);
    c.bench_function("one evaluation of the sensor", |b| {
        b.iter(|| {
            let warm = device.at(black_box(50.0));
            let strain = device.strain(&warm, black_box(4.5), 1.0, [0.0; 2])?;
            device.capacitances(&warm, &device.plain(&warm, 4.5, strain)).map(|parts| device.total(parts.shares))
        });
    });
    c.bench_function("one set of coefficients", |b| b.iter(|| coefficients(black_box(&sensor), CoefficientOptions::default())));
    let inputs = staircase(7_000, sensor.full_scale);
    c.bench_function("7 000 rows", |b| b.iter(|| stack.respond(black_box(&values), &inputs, &[])));
    let stage = Identity;
    c.bench_function("7 000 rows, a stage plugged in", |b| b.iter(|| stack.respond(black_box(&values), &inputs, &[&stage])));
}

/// A stage that changes nothing: what the chain itself costs.
struct Identity;

impl truegap_core::Stage for Identity {}

criterion_group!(benches, integral, sensor);
criterion_main!(benches);
