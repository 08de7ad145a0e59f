//! The corrected analytic model against the coupled finite elements that it stands for, one reading each.
//!
//! Run: `cargo bench -p truegap-benches --bench corrected`. The ratio of the two is the figure to quote, from one run.

use criterion::{Criterion, criterion_group, criterion_main};
use std::hint::black_box;
use truegap_audit::AuditError;
use truegap_audit::corrections::Corrected;
use truegap_audit::reference::FlatCells;
use truegap_core::sensor::builtin_sensor;

/// Load and temperature of the reading: half the full load of the built-in sensor, hot.
const READING: (f64, f64) = (2.25, 50.0);
/// Relative error asked of the finite elements.
const TARGET: f64 = 1e-5;

fn reading(c: &mut Criterion) {
    if let Err(error) = both(c) {
        eprintln!("no figure: {error}");
    }
}

fn both(c: &mut Criterion) -> Result<(), AuditError> {
    let Some(Ok(sensor)) = builtin_sensor("singletact-s15-4.5n") else { return Ok(()) };
    let (force, temperature) = READING;
    let mut group = c.benchmark_group("one reading");
    let corrected = Corrected::new(&sensor)?;
    group.bench_function("corrected model", |b| b.iter(|| corrected.capacitance_pf(black_box(force), black_box(temperature))));
    let coupled = FlatCells::new(&sensor, TARGET)?;
    group.sample_size(10);
    group.bench_function("coupled finite elements", |b| b.iter(|| coupled.at(black_box(force), black_box(temperature))));
    group.finish();
    Ok(())
}

criterion_group!(benches, reading);
criterion_main!(benches);
