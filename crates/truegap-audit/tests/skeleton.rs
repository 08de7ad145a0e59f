//! The chain with pieces replaced, and what a study shares.

#![allow(clippy::unwrap_used)]

use truegap_audit::*;
use truegap_core::{Sensor, sensor::builtin_sensors};
use truegap_model::{CoefficientOptions, coefficients};

fn sensors() -> Vec<Sensor> {
    builtin_sensors().iter().map(|s| s.sensor().unwrap()).collect()
}

#[test]
fn coefficients_of_the_plain_chain_are_those_of_the_model() {
    for sensor in sensors() {
        let watch = Watch::default();
        let study = Study::new(&sensor, Options::default(), &watch).unwrap();
        let (ours, model) = (study.base(), coefficients(&sensor, CoefficientOptions::default()).unwrap());
        let close = |a: f64, b: f64, tolerance: f64| assert!((a - b).abs() <= tolerance * b.abs(), "{}: {a} {b}", sensor.name);
        close(ours.baseline_pf, model.baseline_pf, 1e-12);
        close(ours.span_pf, model.span_pf, 1e-11);
        close(ours.k_baseline_pf_per_k, model.k_baseline_pf_per_k, 1e-9);
        close(ours.k_sensitivity_pct_per_k, model.k_sensitivity_pct_per_k, 1e-9);
        // The parabola through three of forty steps against golden section.
        close(ours.linearity_pct, model.linearity_pct, 1e-4);
        assert!((ours.k_linearity_pct_per_k - model.k_linearity_pct_per_k).abs() < 1e-4 * model.linearity_pct / 30.0);
    }
}

#[test]
fn a_stray_capacitance_moves_the_baseline_and_nothing_else() {
    let sensor = builtin_sensors()[0].sensor().unwrap();
    let watch = Watch::default();
    let study = Study::new(&sensor, Options::default(), &watch).unwrap();
    let stray = |f: f64| {
        Swap::none().parts(move |_, _, parts| {
            parts.shares.tail += f;
            Ok(())
        })
    };
    let effect = study.effect(stray(1e-12)).unwrap();
    assert!((effect.baseline_pct.unwrap() - 100.0 / study.base().baseline_pf).abs() < 1e-9);
    let [_, span, k_baseline, k_sensitivity, k_linearity] = effect.values().map(Option::unwrap);
    for none in [span, k_baseline, k_sensitivity, k_linearity] {
        assert!(none.abs() < 1e-6, "{none}");
    }
    assert_eq!(study.effect(Swap::none()).unwrap().worst().1, 0.0);
}

#[test]
fn a_study_shares_one_result_of_a_type_and_hands_its_error_to_all() {
    let sensor = builtin_sensors()[0].sensor().unwrap();
    let watch = Watch::default();
    let study = Study::new(&sensor, Options::default(), &watch).unwrap();
    struct Costly(u32);
    assert_eq!(study.shared(|_| Ok(Costly(3))).unwrap().0, 3);
    assert_eq!(study.shared(|_| Ok(Costly(4))).unwrap().0, 3);
    struct Hopeless;
    assert!(matches!(study.shared(|_| Err::<Hopeless, _>(AuditError::Cancelled)), Err(AuditError::Cancelled)));
    assert!(matches!(study.shared(|_| Ok(Hopeless)), Err(AuditError::Cancelled)));
}
