//! The rows about the electrode for the built-in sensors: what must be broken, what must hold, and errors far below what they judge.

#![allow(clippy::unwrap_used)]

use truegap_audit::{Assumption, Finding, Options, Study, Verdict, Watch, register};
use truegap_core::Sensor;
use truegap_core::sensor::builtin_sensor;

/// The register's part about the plate, which comes last.
fn of_plates() -> Vec<&'static dyn Assumption> {
    register().into_iter().skip_while(|a| a.id() != "BIMETAL-STRIP").collect()
}

fn findings(sensor: &Sensor) -> Vec<Finding> {
    let watch = Watch::default();
    let study = Study::new(sensor, Options::default(), &watch).unwrap();
    let applicable = of_plates().into_iter().filter(|a| a.applies(sensor).is_ok());
    applicable.map(|a| a.examine(&study).unwrap_or_else(|e| panic!("{}: {e}", a.id()))).collect()
}

fn sensor(name: &str) -> Sensor {
    builtin_sensor(name).unwrap().unwrap()
}

fn find<'a>(all: &'a [Finding], id: &str) -> &'a Finding {
    all.iter().find(|f| f.id == id).unwrap_or_else(|| panic!("no {id}"))
}

#[test]
fn every_row_of_every_built_in_sensor_has_a_value_and_an_error_below_what_it_judges() {
    for name in ["singletact-s15-4.5n", "singletact-s15-4.5n-stiffening", "singletact-s8-optimised"] {
        let all = findings(&sensor(name));
        assert_eq!(all.len(), of_plates().len());
        for f in &all {
            println!(
                "{name} {} {:.5} {:.5} +- {:.1e} {} {:?}: {}",
                f.id, f.analytic.value, f.fem.value, f.fem.error_estimate, f.fem.unit, f.verdict, f.reason
            );
            let judged = (f.fem.value - f.analytic.value).abs();
            assert!(f.fem.value.is_finite() && f.fem.error_estimate < 0.02 * judged, "{name} {}", f.id);
            assert!(f.effect_on.values().iter().all(|v| v.is_none_or(f64::is_finite)), "{name} {}", f.id);
            // Warp does not touch the cold sensor.
            if f.id != "RIGID-PLATES" {
                assert!(f.effect_on.values()[..2].iter().all(|v| v.unwrap().abs() < 1e-9), "{name} {}", f.id);
            }
        }
        assert_eq!(find(&all, "BEADS-DO-NOT-HOLD").verdict, Verdict::Broken);
        assert_eq!(find(&all, "LAYERS-OUTSIDE-IGNORED").verdict, Verdict::Broken);
        assert_eq!(find(&all, "BIMETAL-STRIP").verdict, Verdict::Strained);
    }
}

#[test]
fn the_thick_electrode_stays_a_bowl_and_the_thin_one_buckles() {
    let thick = findings(&sensor("singletact-s15-4.5n"));
    let thin = findings(&sensor("singletact-s8-optimised"));
    assert_eq!(find(&thick, "SPHERICAL-STABLE").verdict, Verdict::Holds);
    assert!(find(&thick, "SPHERICAL-STABLE").fem.value > 30.0);
    assert_ne!(find(&thin, "SPHERICAL-STABLE").verdict, Verdict::Holds);
    assert!(find(&thin, "SPHERICAL-STABLE").fem.value < 15.0);
}

#[test]
fn the_published_disc_buckles_at_its_published_temperature() {
    let mut s = sensor("singletact-s15-4.5n");
    s.conductor.thickness.value = 17e-6;
    // 140 um of warp would close the gap of 162 um; the chain is not what is tested.
    s.dielectric.layer.thickness.value = 400e-6;
    let watch = Watch::default();
    let study = Study::new(&s, Options::default(), &watch).unwrap();
    let row = of_plates().iter().find(|a| a.id() == "SPHERICAL-STABLE").unwrap().examine(&study).unwrap();
    // Ritz: 11.1266 K, a plate theory.
    assert!((row.fem.value / 11.1266 - 1.0).abs() < 1e-3, "{}", row.fem.value);
    assert!(row.fem.error_estimate < 0.01);
}

#[test]
fn a_film_on_metal_puts_what_it_may_not_spread_into_its_thickness() {
    let s = sensor("singletact-s15-4.5n");
    let all = findings(&s);
    let row = find(&all, "INSULATOR-EXPANDS-FREELY");
    // Plane stress with the metal's strain: 20 + 2 * 0.34 / 0.66 * (20 - 16.7) = 23.40 ppm/K.
    let bonded = 20.0 + 2.0 * 0.34 / 0.66 * (20.0 - 16.7);
    assert!((row.fem.value - bonded).abs() < 1e-3, "{}", row.fem.value);
    assert!(row.effect_on.k_baseline_pct.unwrap() < -10.0, "{:?}", row.effect_on);
}

#[test]
fn a_sensor_of_one_metal_has_no_warp_to_audit() {
    let s = sensor("single-metal-s15");
    let left: Vec<&str> = of_plates().iter().filter(|a| a.applies(&s).is_ok()).map(|a| a.id()).collect();
    assert_eq!(left, ["INSULATOR-EXPANDS-FREELY", "RIGID-PLATES"]);
}
