//! Batches against closed forms, and the same answer for any number of threads.

#![allow(clippy::unwrap_used)]

use truegap_core::{Sensor, sensor::builtin_sensors, units::Measure};
use truegap_design::sensitivity::{PAPER_QUANTITIES, SobolOptions, one_at_a_time, tolerance_indices};
use truegap_design::tolerance::{BATCH, BatchOptions, Limit, Specification, Summary, batch, join, part, tighten};
use truegap_design::{DesignError, Metric, MetricOptions, QUANTITIES, Quantity, metrics};

fn default() -> Sensor {
    builtin_sensors()[0].sensor().unwrap()
}

/// Only the stray capacitance is uncertain: the baseline is then exactly normal.
fn stray_only() -> Sensor {
    let mut sensor = default();
    QUANTITIES.iter().for_each(|q| q.set_spread(&mut sensor, 0.0));
    sensor.stray = Measure { value: 0.0, sd: 0.5e-12 };
    sensor
}

#[test]
fn the_yield_of_a_normal_metric_is_that_of_the_normal_distribution() {
    let sensor = stray_only();
    let centre = metrics(&sensor, MetricOptions::default()).unwrap().of(Metric::Baseline);
    let limit = Limit::new(Metric::Baseline, centre - 0.5, centre + 1.0).unwrap();
    let specification = Specification::new(vec![limit]).unwrap();
    let made = batch(&sensor, BatchOptions { samples: 131_072, ..Default::default() }).unwrap();
    let yielded = made.yield_of(&specification);
    // Phi(2) - Phi(-1); a stratified sample of 65 536 misses an end by at most one stratum
    let known = 0.977_249_868_051_820_8 - 0.158_655_253_931_457_05;
    approx::assert_abs_diff_eq!(yielded.share, known, epsilon = 2.0 / 65_536.0);
    assert!(yielded.standard_error.unwrap() < 1e-4 && yielded.touching == 0.0);
    approx::assert_abs_diff_eq!(yielded.excluded[0], 1.0 - yielded.share, epsilon = 1e-12);
    let scatter = &made.scatter()[0];
    approx::assert_relative_eq!(scatter.sd, 0.5, max_relative = 1e-3);
    approx::assert_relative_eq!(scatter.mean, centre, max_relative = 1e-6);
}

#[test]
fn the_only_tolerance_is_the_one_to_tighten() {
    let sensor = stray_only();
    let centre = metrics(&sensor, MetricOptions::default()).unwrap().of(Metric::Baseline);
    let specification = Specification::new(vec![Limit::new(Metric::Baseline, centre - 0.5, centre + 0.5).unwrap()]).unwrap();
    let rows = tighten(&sensor, &specification, BatchOptions { samples: 65_536, ..Default::default() }).unwrap();
    assert_eq!((rows.len(), rows[0].quantity), (1, Quantity::Stray));
    // 1 sigma becomes 2 sigma: 95.45 % - 68.27 %
    approx::assert_abs_diff_eq!(rows[0].gain, 0.954_499_736 - 0.682_689_492, epsilon = 1e-4);
    approx::assert_relative_eq!(rows[0].scatter_falls_pct[0], 50.0, max_relative = 1e-3);
}

#[test]
fn the_number_of_threads_changes_no_sensor() {
    let sensor = default();
    let run = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| batch(&sensor, BatchOptions { samples: 5000, ..Default::default() }).unwrap().sensors().to_vec())
    };
    assert_eq!(run(1), run(3));
    assert!(run(1).iter().all(Option::is_some));
}

#[test]
fn another_seed_is_another_batch_with_the_same_scatter() {
    let sensor = default();
    let scatter = |seed| batch(&sensor, BatchOptions { samples: 16_384, seed, ..Default::default() }).unwrap().scatter();
    for (a, b) in scatter(1).iter().zip(scatter(2)) {
        assert_ne!(a.mean, b.mean);
        approx::assert_relative_eq!(a.sd, b.sd, max_relative = 0.02);
    }
}

#[test]
fn sobol_indices_of_the_tolerances_add_up_to_the_variance() {
    let options = SobolOptions { rows: 2048, resamples: 20, seed: 3 };
    let rows = tolerance_indices(&default(), MetricOptions::default(), options, |_| true).unwrap().quantities;
    // tolerances of a few per cent: almost linear, so the first-order indices share out nearly all
    let sum: f64 = rows.iter().map(|r| r.first[Metric::Baseline as usize].value).sum();
    approx::assert_abs_diff_eq!(sum, 1.0, epsilon = 0.05);
    // other route: squares of the linear contributions
    let of = |q: Quantity| rows.iter().find(|r| r.quantity == q).unwrap().total[0].value;
    assert!(of(Quantity::Softening) < 1e-9, "softening does nothing at the reference temperature");
    let local =
        truegap_design::sensitivity::local(&default(), &[Quantity::Insulator, Quantity::Height], MetricOptions::default());
    let part = |i: usize, q: Quantity| {
        let m = q.of(&default()).unwrap();
        (local.as_ref().unwrap()[i].per_percent[0] * 100.0 * m.sd / m.value).powi(2)
    };
    let ratio = part(0, Quantity::Insulator) / part(1, Quantity::Height);
    approx::assert_relative_eq!(of(Quantity::Insulator) / of(Quantity::Height), ratio, max_relative = 0.1);
}

#[test]
fn one_at_a_time_is_the_difference_of_two_sensors() {
    let sensor = default();
    let rows = one_at_a_time(&sensor, &PAPER_QUANTITIES, 0.1, MetricOptions::default()).unwrap();
    let mut thick = sensor.clone();
    thick.insulator.thickness.value *= 1.1;
    let known =
        metrics(&thick, MetricOptions::default()).unwrap().0[0] - metrics(&sensor, MetricOptions::default()).unwrap().0[0];
    let found = rows.iter().find(|r| r.quantity == Quantity::Insulator).unwrap().up[0];
    approx::assert_relative_eq!(found, known, max_relative = 1e-12);
    assert!(found < -1.0);
}

#[test]
fn studies_that_mean_nothing_are_refused() {
    let mut exact = stray_only();
    exact.stray.sd = 0.0;
    assert!(matches!(batch(&exact, BatchOptions::default()), Err(DesignError::NoTolerance { .. })));
    assert!(matches!(Limit::new(Metric::Span, 2.0, 1.0), Err(DesignError::EmptyLimit { .. })));
    let limits = [(0.0, 1.0), (2.0, 3.0)].map(|(a, b)| Limit::new(Metric::Span, a, b).unwrap()).to_vec();
    assert!(matches!(Specification::new(limits), Err(DesignError::EmptyLimit { low: 2.0, high: 1.0, .. })));
    let few = batch(&default(), BatchOptions { samples: 3, ..Default::default() });
    assert!(matches!(few, Err(DesignError::TooFewSamples { .. })));
}

#[test]
fn parts_join_to_the_whole() {
    let sensor = default();
    let options = BatchOptions { samples: 2 * BATCH + 1000, ..Default::default() };
    let specification = Specification::new(vec![Limit::new(Metric::Span, 2.3, 2.6).unwrap()]).unwrap();
    let whole = batch(&sensor, options).unwrap();
    let ranges = [0..BATCH, BATCH..2 * BATCH, 2 * BATCH..options.samples];
    let parts = ranges.map(|r| Summary::of(&part(&sensor, options, r).unwrap(), &specification));
    let (scatter, good) = join(&parts);
    assert_eq!(good, whole.yield_of(&specification), "counts are exact");
    assert!(good.share > 0.5 && good.share < 0.9);
    for (joined, whole) in scatter.iter().zip(whole.scatter()) {
        approx::assert_relative_eq!(joined.mean, whole.mean, max_relative = 1e-10);
        approx::assert_relative_eq!(joined.sd, whole.sd, max_relative = 1e-10);
        // means of three quantiles against the quantile of all: a thousandth of the scatter in the middle, more in the thin tails
        let tolerance = |p: f64| whole.sd * if (0.05..0.95).contains(&p) { 2e-2 } else { 0.2 };
        for (&p, quantile) in truegap_design::tolerance::PROBABILITIES.iter().zip(&joined.quantiles) {
            approx::assert_abs_diff_eq!(*quantile, whole.quantile(p).unwrap(), epsilon = tolerance(p));
        }
    }
}
