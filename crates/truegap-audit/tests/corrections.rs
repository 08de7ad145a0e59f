//! The tables and the corrected model against what they condense.

#![allow(clippy::unwrap_used)]

use truegap_audit::AuditError;
use truegap_audit::corrections::{Corrected, coupled::Coupled, designs::held_out, library};
use truegap_core::{Inputs, Sensor, Simulator, sensor::builtin_sensors};

fn sensor(number: usize) -> Sensor {
    builtin_sensors()[number].sensor().unwrap()
}

#[test]
fn the_tables_say_what_other_programs_say() {
    let tables = library().unwrap();
    // Bonded disc, diameter 583 um, height 198 um, nu = 0.49.
    let stiffness = tables.bead_load.at(&[583.0 / (4.0 * 198.0), 0.02, 0.0]).unwrap();
    assert!((stiffness / 1.96621337023 - 1.0).abs() < 2e-3, "{stiffness}");
    // Trace 100 um wide and 17 um thick, 25 um from each shield.
    let edge = tables.tail_edge.at(&[4.0, 17.0 / 25.0]).unwrap();
    assert!((8.0 * edge / 10.999940878 - 1.0).abs() < 1e-4, "{edge}");
    for table in [&tables.bead_load, &tables.held_expansion, &tables.cell_field, &tables.rim_field, &tables.tail_edge] {
        assert!(table.accuracy > 0.0 && table.accuracy < 1e-2 && table.checked_at >= 8, "{}: {}", table.id, table.accuracy);
    }
}

#[test]
fn the_corrected_model_is_the_coupled_one() {
    let sensor = sensor(0);
    let (coupled, corrected) = (Coupled::new(&sensor, 1e-5).unwrap(), Corrected::new(&sensor).unwrap());
    let exact = |f, t| coupled.at(f, t).unwrap().capacitance_pf;
    let span = exact(4.5, 20.0) - exact(0.0, 20.0);
    assert!(span > 0.5);
    for (force, temperature) in [(0.0, 50.0), (4.5, 20.0), (2.0, 50.0)] {
        let off = corrected.capacitance_pf(force, temperature).unwrap() - exact(force, temperature);
        // Asked for: 0.2 % of the span.
        assert!(off.abs() < 2e-3 * span, "{force} N, {temperature} degC: {off} pF of {span}");
    }
}

#[test]
fn the_corrected_model_answers_as_a_simulator() {
    let sensor = sensor(0);
    let model = Corrected::new(&sensor).unwrap();
    let inputs = Inputs {
        run: vec![1; 3],
        force_n: Some(vec![0.0, 2.0, 4.5]),
        temperature_c: Some(vec![20.0, 35.0, 50.0]),
        ..Inputs::default()
    };
    let centre: Vec<f64> = model.parameters().iter().map(truegap_core::Parameter::centre).collect();
    let response = model.respond(&centre, &inputs, &[]).unwrap();
    for (row, (force, temperature)) in [(0.0, 20.0), (2.0, 35.0), (4.5, 50.0)].into_iter().enumerate() {
        assert!((response[row] - model.capacitance_pf(force, temperature).unwrap()).abs() < 1e-9);
    }
    assert!(response[2] > response[1] && response[1] > response[0] + 0.1);
}

#[test]
fn what_the_tables_do_not_cover_is_refused() {
    let refused = |sensor: &Sensor| Corrected::new(sensor).unwrap_err();
    assert!(matches!(refused(&sensor(3)), AuditError::Lacks { .. }));
    assert!(matches!(refused(&sensor(5)), AuditError::Lacks { .. }));
    let mut wet = sensor(0);
    wet.insulator.material.permittivity = 3.6;
    assert!(matches!(refused(&wet), AuditError::Uncovered { .. }));
    let mut thick = sensor(0);
    thick.dielectric.layer.thickness.value = 2e-3;
    assert!(matches!(refused(&thick), AuditError::Uncovered { .. }));
    assert!(Corrected::new(&sensor(0)).unwrap().capacitance_pf(100.0, 20.0).is_err());
}

#[test]
fn held_out_designs_are_the_same_every_time_and_all_different() {
    let (first, again) = (held_out(&sensor(0), 5), held_out(&sensor(0), 5));
    assert_eq!(first.len(), 5);
    assert_eq!(first, again);
    assert!((1..5).all(|i| first[i] != first[i - 1]));
}
