//! An iteration that ends without an answer says what it sought, where, and how far it came.

#![allow(clippy::unwrap_used)]

use truegap_audit::AuditError;
use truegap_audit::disc::{BeadSpring, Bond, Disc, Fineness, Laminate, Loading, Ring, RingPlate, Sheet, Strains};

/// 5 um of tin on 17 um of copper, radius 7.5 mm.
fn plate() -> Laminate {
    let sheet = |name: &str, thickness: f64, young: f64, poisson: f64, expansion: f64| Sheet {
        name: name.into(),
        thickness,
        young,
        poisson,
        expansion,
    };
    let sheets = vec![sheet("tin", 5e-6, 41.6e9, 0.36, 22.4e-6), sheet("copper", 17e-6, 117e9, 0.34, 16.7e-6)];
    Laminate { sheets, radius: 7.5e-3 }
}

fn on_rings() -> Disc {
    let beads = BeadSpring { young: 1.2e6, coverage: 0.15, height: 180e-6, expansion: 200e-6 };
    Disc::on_rings(plate(), beads, 2, Strains::Small, Fineness { columns: 12, rows: 1 }).unwrap()
}

/// What an error says of how far an iteration came: steps, what is left, target.
fn told(error: &AuditError, sought: &str) -> (usize, f64, f64) {
    let AuditError::NotConverged { what, at, steps, left, target, .. } = error else { panic!("{error:?}") };
    assert!(what.contains(sought), "{what}");
    assert!(error.to_string().contains(at) && error.to_string().contains("did not converge"), "{error}");
    (*steps, *left, *target)
}

#[test]
fn a_disc_pulled_off_its_rings_has_no_set_of_touching_rings() {
    let lifted = on_rings().carried(0.0, &Loading::Even(-1.0), Bond::Touching).unwrap_err();
    // both rings pull in the first solution already
    assert_eq!(told(&lifted, "rings"), (1, 2.0, 1.0));
}

#[test]
fn no_travel_makes_a_load_plate_pull() {
    let pulled = on_rings().pressed(0.0, -1.0, Bond::Bonded).unwrap_err();
    let (steps, left, _) = told(&pulled, "travel of the load plate");
    // a plate that has let go carries nothing, which is 1 N off
    assert_eq!((steps, left), (40, 1.0));
    assert!(pulled.to_string().contains("-1 N"), "{pulled}");
}

#[test]
fn no_set_of_nodes_makes_a_load_plate_pull_at_a_thin_plate() {
    let rings = vec![Ring { inner: 0.0, outer: 3.5e-3 }, Ring { inner: 3.5e-3, outer: 7e-3 }];
    let plate = RingPlate { bending: 5e-4, poisson: 0.34, radius: 7.5e-3, stiffness: 1e10, tilt: 1.0, rings };
    let (steps, left, target) = told(&plate.pressed(1.4, -1.0, None).unwrap_err(), "nodes");
    assert_eq!(steps, 440);
    assert!(left >= 1.0 && target == 0.0);
}

#[test]
fn a_load_plate_on_a_disc_without_beads_is_told_so() {
    let free = Disc::free(plate(), Strains::Small, Fineness { columns: 12, rows: 1 }).unwrap();
    for refused in [free.pressed(0.0, 1.0, Bond::Bonded).unwrap_err(), free.held_flat(30.0, 1.0).unwrap_err()] {
        assert!(matches!(refused, AuditError::NoBeads { .. }), "{refused:?}");
    }
}
