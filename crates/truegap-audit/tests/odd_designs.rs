//! Rows about the electrode at the corners of the paper's design space: every one answers, or says that the plates touch.

#![allow(clippy::unwrap_used)]

use truegap_audit::{Assumption, Options, Study, Watch, register};
use truegap_core::Sensor;
use truegap_core::sensor::{Filling, builtin_sensor};
use truegap_core::units::Measure;

/// The register's part about the plate, which comes last.
fn of_plates() -> Vec<&'static dyn Assumption> {
    register().into_iter().skip_while(|a| a.id() != "BIMETAL-STRIP").collect()
}

/// Copper, tin, insulator (um), diameter (mm), height (um), beads and their diameter (um), modulus (MPa).
const CORNERS: [[f64; 8]; 2] =
    [[10.0, 9.0, 10.0, 6.0, 150.0, 50.0, 300.0, 0.7], [10.0, 3.0, 25.0, 15.0, 210.0, 97.0, 760.0, 1.5]];

fn design([copper, tin, film, diameter, height, count, bead, young]: [f64; 8]) -> Sensor {
    let mut s = builtin_sensor("singletact-s15-4.5n").unwrap().unwrap();
    s.conductor.thickness = Measure::exact(1e-6 * copper);
    s.plating.as_mut().unwrap().thickness = Measure::exact(1e-6 * tin);
    s.insulator.thickness = Measure::exact(1e-6 * film);
    s.diameter = Measure::exact(1e-3 * diameter);
    s.dielectric.layer.thickness = Measure::exact(1e-6 * height);
    s.dielectric.layer.material.young = Measure::exact(1e6 * young);
    s.dielectric.filling = Filling::Beads { count: count as u32, diameter: Measure::exact(1e-6 * bead) };
    s.full_scale = 2.0;
    s
}

#[test]
fn every_row_answers_at_the_corners_of_the_design_space() {
    let mut answered = 0;
    for corner in CORNERS {
        let sensor = design(corner);
        let watch = Watch::default();
        let study = Study::new(&sensor, Options::default(), &watch).unwrap();
        for a in of_plates() {
            let row = a.examine(&study).unwrap_or_else(|e| panic!("{corner:?} {}: {e}", a.id()));
            println!("{corner:?} {} {:.4} {:.4} {:?} {}", row.id, row.analytic.value, row.fem.value, row.verdict, row.reason);
            assert!(row.fem.value.is_finite() && row.fem.error_estimate.is_finite());
            answered += 1;
        }
    }
    assert_eq!(answered, 2 * of_plates().len());
}

#[test]
fn a_bent_gap_whose_arc_ends_beside_the_axis_by_rounding_has_a_field() {
    let mut sensor =
        design([10.0, 9.0, 10.0, 7.279435845777327, 194.58829552355088, 54.0, 337.82485084669634, 1.246346172642802]);
    sensor.full_scale = 4.5;
    let watch = Watch::default();
    let study = Study::new(&sensor, Options::default(), &watch).unwrap();
    let row = truegap_audit::chosen(&["SERIES-OF-INTEGRALS".into()]).unwrap()[0].examine(&study).unwrap();
    // integrating in series is a fraction of a per cent off on any sensor whose plates do not touch
    assert!(row.relative_error.abs() < 0.05 && row.fem.value > 0.0, "{row:?}");
}
