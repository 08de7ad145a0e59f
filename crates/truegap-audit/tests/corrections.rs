//! The tables and the corrected model against what they condense.

#![allow(clippy::unwrap_used)]

use truegap_audit::AuditError;
use truegap_audit::corrections::{Corrected, curves, held_out, library};
use truegap_audit::disc::Fineness;
use truegap_audit::reference::{CellDisc, FlatCells};
use truegap_core::{Corrections, Dielectric, Drive, FieldView, Inputs, Sensor, Simulator, Stage, sensor::builtin_sensors};
use truegap_model::equations::load::{BeadLaw, compressive_strain, reduced_load};
use truegap_model::{Stack, StackOptions};

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
    let fields = [&tables.cell_field, &tables.heated_field, &tables.rim_field, &tables.tail_edge];
    for table in [&tables.bead_load, &tables.held_expansion].into_iter().chain(fields) {
        assert!(table.accuracy > 0.0 && table.accuracy < 1e-2 && table.checked_at >= 8, "{}: {}", table.id, table.accuracy);
    }
}

#[test]
fn the_corrected_model_is_the_disc_of_bead_cells() {
    let sensor = sensor(0);
    let cells = FlatCells::new(&sensor, 1e-5).unwrap();
    let (disc, corrected) = (CellDisc::with(cells, Fineness { columns: 32, rows: 1 }).unwrap(), Corrected::new(&sensor).unwrap());
    let exact = |f, t| disc.at(f, t).unwrap();
    let (rest, full) = (exact(0.0, 20.0).capacitance_pf, exact(4.5, 20.0).capacitance_pf);
    let span = full - rest;
    assert!(span > 0.5);
    assert!(exact(0.0, 50.0).bending().abs() > 5e-3 * span);
    for (force, celsius) in [(0.0, 50.0), (0.05, 50.0), (2.0, 50.0), (4.5, 20.0)] {
        let off = corrected.capacitance_pf(force, celsius).unwrap() - exact(force, celsius).capacitance_pf;
        println!("{force} N, {celsius} degC: {off:+e} pF of {span}");
        // Asked for: 0.2 % of the span.
        assert!(off.abs() < 2e-3 * span, "{force} N, {celsius} degC: {off} pF of {span}");
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

/// The curves as a stage of the chain, the way an effect would use them.
struct AsStage(Corrections, [f64; 3]);

impl Stage for AsStage {
    fn strain(&self, drive: &Drive<'_>, strain: &mut [f64]) {
        for (row, strain) in strain.iter_mut().enumerate() {
            let kelvin = drive.temperature_c[row] - drive.reference_c;
            *strain = self.0.bonded_strain(*strain) - self.0.held_growth() * kelvin;
        }
    }
    fn dielectric(&self, drive: &Drive<'_>, factors: &mut Dielectric) {
        for (row, factor) in factors.insulator.iter_mut().enumerate() {
            *factor /= 1.0 + self.0.insulator_growth() * (drive.temperature_c[row] - drive.reference_c);
        }
    }
    fn field(&self, drive: &Drive<'_>, view: &FieldView<'_>, extra: &mut [f64]) {
        for (row, extra) in extra.iter_mut().enumerate() {
            let [radius, film, height] = self.1;
            let (kelvin, load) = (drive.temperature_c[row] - drive.reference_c, drive.load[row]);
            // strain by the load alone, from the separation
            let free = 200e-6 * kelvin;
            let strain = 1.0 + free - (view.aspect[row] * radius - film) / height + self.0.held_growth() * kelvin;
            let factor = self.0.mixing(strain) * self.0.warp(kelvin, load) + self.0.fringing(view.aspect[row]);
            *extra += view.plates[row] * (factor - 1.0) + self.0.tail_edge_pf;
        }
    }
}

#[test]
fn the_curves_in_the_chain_are_the_corrected_model() {
    let sensor = sensor(0);
    let sizes = [0.5 * sensor.diameter.value, sensor.insulator.thickness.value, sensor.dielectric.layer.thickness.value];
    let stage = AsStage(curves(&sensor).unwrap(), sizes);
    stage.0.check().unwrap();
    let stack = Stack::new(&sensor, StackOptions { warp: false, ..StackOptions::default() });
    let (force, temperature) = (vec![0.0, 1.0, 4.5, 0.0, 1.0, 4.5], vec![20.0, 20.0, 20.0, 50.0, 50.0, 50.0]);
    let inputs =
        Inputs { run: vec![1; 6], force_n: Some(force.clone()), temperature_c: Some(temperature.clone()), ..Inputs::default() };
    let centre: Vec<f64> = stack.parameters().iter().map(truegap_core::Parameter::centre).collect();
    let plain = stack.respond(&centre, &inputs, &[]).unwrap();
    let with = stack.respond(&centre, &inputs, &[&stage]).unwrap();
    let model = Corrected::new(&sensor).unwrap();
    let exact: Vec<f64> = force.iter().zip(&temperature).map(|(&f, &t)| model.capacitance_pf(f, t).unwrap()).collect();
    let span = exact[2] - exact[0];
    for row in 0..6 {
        let off = (with[row] - exact[row]) / span;
        println!(
            "{} N, {} degC: {:+.5} of the span; without the curves {:+.3}",
            force[row],
            temperature[row],
            off,
            (plain[row] - exact[row]) / span
        );
    }
    // Without heat only the sampling is left, and the modulus with which the insulator yields (0.1 % of the span).
    assert!((0..3).all(|row| ((with[row] - exact[row]) / span).abs() < 2e-3));
    // With heat: the area of held beads is not among the curves, nor is what heat does to the field around them.
    assert!((3..6).all(|row| ((with[row] - exact[row]) / span).abs() < 1.5e-2));
    assert!(((plain[2] - plain[0]) / span - 1.0).abs() > 1.0);
    // The way through a file.
    let text = toml::to_string(&stage.0).unwrap();
    let back: Corrections = toml::from_str(&text).unwrap();
    assert_eq!(back, stage.0);
}

#[test]
fn stiffening_and_bonded_strain_are_one_law() {
    let curves = curves(&sensor(0)).unwrap();
    let law = BeadLaw { poisson: 0.49, stiffening: [0.0; 2] };
    for strain in [0.01, 0.077, 0.15, 0.25] {
        let free = compressive_strain(curves.stiffening(strain) * reduced_load(law, strain), law).unwrap();
        assert!((curves.bonded_strain(free) / strain - 1.0).abs() < 1e-4, "{strain}: {}", curves.bonded_strain(free));
    }
    assert!(curves.stiffening(0.0) > 1.5 && curves.stiffening(0.2) > curves.stiffening(0.0));
    assert!(!curves.stiffening.covers(0.31));
}
