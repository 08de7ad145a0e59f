//! The coupled disc at its limits: the bead cell without load, the shape integral for a small warp, work against force.

#![allow(clippy::unwrap_used)]

use truegap_audit::cell::{Cell, Filled, Profile as Side, cell_capacitance};
use truegap_audit::disc::{Beads, CoupledOptions, Fineness, Laminate, Loading, Press, Profile, Whole};
use truegap_audit::{Options, Study, Watch};
use truegap_core::sensor::builtin_sensor;
use truegap_core::units::Measure;
use truegap_core::{Sensor, VACUUM_PERMITTIVITY};
use truegap_model::StackOptions;
use truegap_model::stack::{Device, Warm};

const QUICK: CoupledOptions =
    CoupledOptions { press: Press::RigidPlate, fineness: Fineness { columns: 32, rows: 1 }, target: 1e-4 };

fn sensor(name: &str) -> Sensor {
    builtin_sensor(name).unwrap().unwrap()
}

fn device(sensor: &Sensor) -> Device {
    Device::new(sensor, StackOptions::default())
}

#[test]
fn at_rest_the_disc_is_its_beads_side_by_side() {
    for name in ["singletact-s15-4.5n", "singletact-s8-optimised"] {
        let sensor = sensor(name);
        let device = device(&sensor);
        let whole = Whole::new(&sensor, &device, Beads::free(&sensor, &device), CoupledOptions::default()).unwrap();
        let found = whole.solve(0.0, 20.0).unwrap();
        let cell = Cell::of(&sensor).unwrap();
        let filled = Filled { bead: 3.4, air: 1.0, film: 3.4 };
        let one = cell_capacitance(&cell, &Side::cylinder(0.0, 0.49), filled, 1e-4).unwrap();
        let count = (0.5 * sensor.diameter.value / cell.outer).powi(2);
        println!("{name}: disc {} F, {count} cells {} F", found.charged.main, count * one.capacitance);
        // A ring bends the field one way only, a bead two; the two mixing bounds of the cell are 2 % apart.
        assert!((found.charged.main / (count * one.capacitance) - 1.0).abs() < 2e-3);
        let moved = found
            .deformed
            .points
            .iter()
            .zip(&found.carried.solution.body().problem.mesh.points)
            .map(|(a, b)| (a[0] - b[0]).hypot(a[1] - b[1]));
        assert!(moved.fold(0.0, f64::max) < 1e-15);
        // Backing: (1), exact for flat layers but for their rim.
        let area = std::f64::consts::PI * 0.25 * sensor.diameter.value.powi(2);
        let backing = VACUUM_PERMITTIVITY * 3.4 * area / sensor.insulator.thickness.value;
        assert!((found.charged.backing / backing - 1.0).abs() < 1e-9, "{} {backing}", found.charged.backing);
    }
}

/// The S15 with beads that neither hold nor are seen by the field.
fn without_beads() -> Sensor {
    let mut s = sensor("singletact-s15-4.5n");
    s.dielectric.layer.material.young = Measure::exact(10.0);
    s.dielectric.layer.material.softening = Measure::exact(0.0);
    s.dielectric.layer.material.permittivity = 1.0;
    s
}

#[test]
fn a_small_warp_has_the_capacitance_of_the_integral_over_its_shape() {
    let sensor = without_beads();
    let device = device(&sensor);
    let strain = Box::new(|warm: &Warm, force: f64| Ok(force / (warm.areas.solid * warm.young)));
    let whole = Whole::new(&sensor, &device, Beads { strain, expansion: 0.0 }, QUICK).unwrap();
    let kelvin = 12.0;
    let (cold, hot) = (whole.solve(0.0, 20.0).unwrap(), whole.solve(0.0, 20.0 + kelvin).unwrap());
    let plate = Laminate::backed(&sensor);
    let shape = hot.disc.profile(&hot.carried.solution).unwrap();
    // Mechanics: the free laminate; large deflection takes (10.6 um / 64 um)^2 of some tenths.
    assert!((shape.sag() / plate.free_sag(kelvin) - 1.0).abs() < 0.03, "{} {}", shape.sag(), plate.free_sag(kelvin));
    // Field: (19) with the film added point by point. The film spreads with the shield only, so what is left of its volume
    // goes into its thickness.
    let m = &sensor.insulator.material;
    let shield = sensor.conductor.material.expansion;
    let growth = kelvin * (m.expansion * (1.0 + m.poisson) - 2.0 * m.poisson * shield) / (1.0 - m.poisson);
    let (film, gap) = (sensor.insulator.thickness.value, sensor.dielectric.layer.thickness.value);
    let rim = hot.carried.solution.displacement_at([plate.radius, hot.disc.section.face]).unwrap()[0];
    let over = |shape: &Profile, radius: f64, growth: f64| {
        let area = shape.integral(|_, w| 1.0 / (gap + w - film * growth + film * (1.0 + growth) / 3.4));
        VACUUM_PERMITTIVITY * radius * radius * area
    };
    let flat = Profile::from_fn(1, |_| 0.0);
    let (before, after) = (over(&flat, plate.radius, 0.0), over(&shape, plate.radius + rim, growth));
    let bent = after - over(&Profile::from_fn(1, |_| shape.mean()), plate.radius + rim, growth);
    let found = hot.charged.main - cold.charged.main;
    println!("change {found:e} F against {:e} F, of which the warp {bent:e} F", after - before);
    assert!((cold.charged.main / before - 1.0).abs() < 1e-6);
    // Straight edges between the columns, the tilted rim: some hundredths of the warp's part.
    assert!((found - (after - before)).abs() < 0.04 * bent, "{found:e} {:e}", after - before);
    assert!(bent > 2e-15);
}

#[test]
fn the_force_of_the_load_plate_is_the_slope_of_the_stored_energy() {
    let sensor = sensor("singletact-s8-optimised");
    let device = device(&sensor);
    let whole = Whole::new(&sensor, &device, Beads::free(&sensor, &device), QUICK).unwrap();
    let disc = whole.disc(4.5, 20.0).unwrap();
    let at = disc.beads.map(|b| 4.5 / (std::f64::consts::PI * 16e-6 * b.stiffness())).unwrap();
    let all: Vec<bool> = vec![true; disc.section.rings.len()];
    let energy = |travel: f64| {
        let touched = disc.section.level(disc.section.top);
        disc.solve(0.0, &Loading::Plate { travel, touched }, &all).unwrap().energy()
    };
    let d = 1e-3 * at;
    let slope = (energy(at + d) - energy(at - d)) / (2.0 * d);
    let force = disc.flattened(0.0, at).unwrap();
    // Central difference, and rings matched to 4.5 N at this travel.
    assert!((slope / force - 1.0).abs() < 1e-4, "{slope} {force}");
    assert!((force / 4.5 - 1.0).abs() < 1e-3, "{force}");
}

#[test]
fn a_loaded_hot_disc_carries_its_load_and_gains_capacitance() {
    let sensor = sensor("singletact-s15-4.5n");
    let watch = Watch::default();
    let study = Study::new(&sensor, Options::default(), &watch).unwrap();
    let whole = Whole::bonded(&study, QUICK).unwrap();
    let (rest, loaded) = (whole.solve(0.0, 50.0).unwrap(), whole.solve(4.5, 50.0).unwrap());
    assert!((loaded.carried.plate_force / 4.5 - 1.0).abs() < 2e-4);
    assert!(loaded.charged.main > 1.03 * rest.charged.main, "{:?} {:?}", rest.charged, loaded.charged);
    // Flat plates at the strain of the bonded bead, its area spread: ring and bead agree to the difference of their fields.
    let law = truegap_audit::cell::bonded_law(&study).unwrap();
    let warm = study.device.at(50.0);
    let strain = law.strain(4.5 / (warm.areas.solid * warm.young)).unwrap();
    let profile = loaded.disc.profile(&loaded.carried.solution).unwrap();
    let down = -(profile.mean() - rest.disc.profile(&rest.carried.solution).unwrap().mean());
    assert!((down / (strain * warm.layers.beads) - 1.0).abs() < 0.05, "{down} {strain}");
}
