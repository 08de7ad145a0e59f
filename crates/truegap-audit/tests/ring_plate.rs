//! The thin plate on rings against closed forms and balances.

#![allow(clippy::unwrap_used)]

use truegap_audit::disc::{Foundation, Ring, RingPlate};

fn plate(rings: Vec<Ring>) -> RingPlate {
    RingPlate { bending: 5e-4, poisson: 0.34, radius: 7.5e-3, stiffness: 1.2e9, tilt: 1.0, rings }
}

fn zones(count: usize, coverage: f64) -> Vec<Ring> {
    let pitch = 7.5e-3 / count as f64;
    let ring = |j: usize| {
        let margin = 0.5 * (1.0 - coverage) * pitch;
        Ring { inner: pitch * j as f64 + margin, outer: pitch * (j + 1) as f64 - margin }
    };
    (0..count).map(ring).collect()
}

#[test]
fn one_ring_that_covers_all_is_the_closed_form() {
    // many rings that touch each other, so that the elements are small
    let plate = plate(zones(12, 1.0));
    let bent = plate.bent(1.4, 0.0);
    let exact = Foundation { bending: 5e-4, poisson: 0.34, radius: 7.5e-3, stiffness: 1.2e9 }.held(1.4).unwrap();
    let rim = exact.height(7.5e-3);
    assert!((bent.rim() / rim - 1.0).abs() < 1e-4, "{} {rim}", bent.rim());
    for (r, v) in bent.radii.iter().zip(&bent.values) {
        assert!((v[0] - exact.height(*r)).abs() < 1e-4 * rim, "{r}: {} {}", v[0], exact.height(*r));
    }
    // springs push as much as they pull
    assert!(bent.mean_of(|_, w| w).abs() < 1e-4 * rim);
    assert!((bent.mean_of(|_, _| 1.0) - 1.0).abs() < 1e-12);
}

#[test]
fn without_springs_to_speak_of_the_plate_is_the_free_sphere() {
    let mut plate = plate(zones(4, 0.5));
    plate.stiffness = 10.0;
    let bent = plate.bent(1.4, 0.0);
    let sag = bent.rim() - bent.values[0][0];
    assert!((sag / (0.5 * 1.4 * 7.5e-3_f64.powi(2)) - 1.0).abs() < 1e-6, "{sag}");
}

#[test]
fn a_force_on_the_rim_is_carried_by_the_rings_and_does_what_the_curvature_does_to_the_rim() {
    let plate = plate(zones(5, 0.25));
    let (pushed, heated) = (plate.bent(0.0, 2.0), plate.bent(1.4, 0.0));
    let carried = -pushed.mean_of(|r, w| if plate.rings.iter().any(|q| q.inner <= r && r <= q.outer) { w } else { 0.0 });
    let area = std::f64::consts::PI * plate.radius * plate.radius;
    // cubics balance exactly; what is left is rounding in a matrix of stiff, short elements
    let share = carried * plate.stiffness * area / 2.0;
    assert!((share - 1.0).abs() < 1e-7, "{share}");
    // Betti: the rim's fall under the force times the force on it is the work of the thermal moment on the slope of the other.
    let work = plate.bending * (1.0 + plate.poisson) * 1.4 * pushed.mean_bending() * area;
    assert!((work / (-2.0 * heated.rim()) - 1.0).abs() < 1e-7, "{work} {}", heated.rim());
}

#[test]
fn rings_leave_an_overhang_that_curls_and_balance_their_forces() {
    let plate = plate(zones(5, 0.25));
    let bent = plate.bent(1.4, 0.0);
    let held: f64 = plate
        .rings
        .iter()
        .map(|ring| {
            let n = 400;
            let h = (ring.outer - ring.inner) / f64::from(n);
            (0..n).map(|i| ring.inner + h * (f64::from(i) + 0.5)).map(|r| r * h * bent.height(r)).sum::<f64>()
        })
        .sum();
    let total = bent.rim() * 7.5e-3 * 7.5e-3;
    assert!(held.abs() < 1e-4 * total, "{held} {total}");
    // more than the overhang alone would curl if the last ring held it like a wall, less than the even layer of as stiff springs and the free strip
    let overhang = 7.5e-3 - plate.rings[4].outer;
    let clamped = 0.5 * 1.4 * overhang * overhang;
    let even = Foundation { bending: 5e-4, poisson: 0.34, radius: 7.5e-3, stiffness: 0.25 * 1.2e9 }.held(1.4).unwrap();
    assert!(bent.rim() > clamped && bent.rim() < 2.0 * even.height(7.5e-3), "{} {clamped}", bent.rim());
    assert!(bent.mean_of(|_, w| w) > 0.0);
}
