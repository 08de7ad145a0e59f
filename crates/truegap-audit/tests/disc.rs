//! The disc by finite elements against plate theory, published large-deflection values, springs in closed form and balances of force.

#![allow(clippy::unwrap_used)]

use truegap_audit::disc::{
    BeadSpring, Bond, Disc, Fineness, Foundation, Laminate, Loading, Profile, Sheet, Strains, buckled, critical_curvature,
};
use truegap_model::equations::curvature::{Bimetal, ExpansionPair, Lamina, bimetal_curvature, mismatch_strain};

fn sheet(name: &str, thickness: f64, young: f64, poisson: f64, expansion: f64) -> Sheet {
    Sheet { name: name.into(), thickness, young, poisson, expansion }
}

/// 5 um of tin at the gap, 17 um of copper, radius 7.5 mm.
fn bimetal() -> Laminate {
    let sheets = vec![sheet("tin", 5e-6, 41.6e9, 0.36, 22.4e-6), sheet("copper", 17e-6, 117e9, 0.34, 16.7e-6)];
    Laminate { sheets, radius: 7.5e-3 }
}

fn sag_um(disc: &Disc, kelvin: f64) -> f64 {
    1e6 * disc.profile(&disc.solve(kelvin, &Loading::None, &[]).unwrap()).unwrap().sag()
}

#[test]
fn the_free_disc_is_the_laminate_but_for_its_edge() {
    let plate = bimetal();
    // Reference: plate theory 142.708 um, finite elements 142.70609 um, strip 140.073 um at 30 K.
    assert!((1e6 * plate.free_sag(30.0) - 142.708).abs() < 1e-3, "{}", 1e6 * plate.free_sag(30.0));
    let lamina = |s: &Sheet| Lamina { young: s.young, thickness: s.thickness };
    let expansions = ExpansionPair { first: 22.4e-6, second: 16.7e-6 };
    let layers = Bimetal { first: lamina(&plate.sheets[0]), second: lamina(&plate.sheets[1]) };
    let strip = 0.5e6 * bimetal_curvature(layers, mismatch_strain(expansions, 30.0)) * plate.radius * plate.radius;
    assert!((strip - 140.073).abs() < 1e-3, "{strip}");
    let disc = Disc::free(plate, Strains::Small, Fineness::FINE).unwrap();
    // The reference was taken at the mid-plane, the face differs by the edge layer: nanometres.
    assert!((sag_um(&disc, 30.0) - 142.70609).abs() < 5e-3, "{}", sag_um(&disc, 30.0));
}

#[test]
fn the_free_disc_stiffens_as_published() {
    let disc = Disc::free(bimetal(), Strains::Large, Fineness::FINE).unwrap();
    for (kelvin, published) in [(3.0, 12.870), (9.0, 28.216), (30.0, 51.856)] {
        let found = sag_um(&disc, kelvin);
        // Published for a disc that does not itself grow: that is a dT = 2.24e-5 a kelvin.
        assert!((found / published - 1.0).abs() < 2e-4 + 2.24e-5 * kelvin, "{kelvin} K: {found} against {published}");
    }
}

#[test]
fn an_insulator_behind_the_metals_bends_as_a_laminate_of_three() {
    let mut plate = bimetal();
    plate.sheets.push(sheet("backing", 25e-6, 2.7e9, 0.34, 20e-6));
    let theory = 1e6 * plate.free_sag(30.0);
    let disc = Disc::free(plate, Strains::Small, Fineness::FINE).unwrap();
    let found = sag_um(&disc, 30.0);
    // Plate theory leaves out the edge layer, as wide as the stack is thick: (47 um / 7.5 mm)^2 of its order.
    assert!((found / theory - 1.0).abs() < 1e-3, "{found} against {theory}");
    assert!(theory < 0.8 * 142.7 && theory > 10.0);
}

#[test]
fn two_curvatures_buckle_near_where_refined_routes_do() {
    let plate = bimetal();
    let nu = plate.poisson();
    let critical = 2.0 * critical_curvature(&plate) / ((1.0 + nu) * plate.curvature_per_kelvin());
    // Refined Ritz: 11.1266 K; at 30 K 164.07 and 5.98 um. Constant curvatures know no edge layer.
    assert!((critical / 11.1266 - 1.0).abs() < 0.05, "{critical}");
    let hot = buckled(&plate, plate.curvature_per_kelvin() * 30.0);
    let [long, short] = [hot.first, hot.second].map(|c| 0.5e6 * c * plate.radius * plate.radius);
    println!("critical {critical} K, at 30 K {long} and {short} um");
    assert!((long / 164.07 - 1.0).abs() < 0.13 && (short - 5.98).abs() < 2.5, "{long} {short}");
    // Below the instability it is the bowl of large deflection: 12.870 um at 3 K.
    let cold = buckled(&plate, plate.curvature_per_kelvin() * 3.0);
    assert_eq!(cold.first, cold.second);
    assert!((0.5e6 * cold.first * plate.radius * plate.radius / 12.870 - 1.0).abs() < 0.05);
}

fn beads(young: f64) -> BeadSpring {
    BeadSpring { young, coverage: 0.15, height: 180e-6, expansion: 200e-6 }
}

#[test]
fn a_soft_layer_holds_the_plate_like_springs() {
    let plate = bimetal();
    let soft = beads(5e3);
    let springs = Foundation {
        bending: plate.bending_stiffness(),
        poisson: plate.poisson(),
        radius: plate.radius,
        stiffness: soft.stiffness(),
    };
    let held = springs.held(plate.curvature_per_kelvin() * 10.0).unwrap();
    let closed = 1e6 * (held.height(plate.radius) - held.height(0.0));
    let free = 1e6 * plate.free_sag(10.0);
    let disc = Disc::on_layer(plate, soft, Strains::Small, Fineness::FINE).unwrap();
    let found = sag_um(&disc, 10.0);
    // A layer also resists shear, springs do not: of the order of its height over the length of the springs, 180 um / 2.2 mm, squared.
    assert!((found / closed - 1.0).abs() < 0.02, "{found} against {closed}");
    assert!(closed < 0.7 * free, "{closed} of {free}");
}

fn on_rings(plate: Laminate) -> Disc {
    Disc::on_rings(plate, beads(1.2e6), 5, Strains::Small, Fineness { columns: 48, rows: 1 }).unwrap()
}

#[test]
fn a_cold_plate_presses_all_rings_alike() {
    let disc = on_rings(bimetal());
    let carried = disc.pressed(0.0, 4.5, Bond::Touching).unwrap();
    assert!((carried.plate_force / 4.5 - 1.0).abs() < 2e-4);
    assert!((carried.forces.iter().sum::<f64>() / 4.5 - 1.0).abs() < 2e-4, "{:?}", carried.forces);
    // Rings of zones 1, 3, 5, 7, 9 times as large as the first.
    for (j, force) in carried.forces.iter().enumerate() {
        let share = (2 * j + 1) as f64 / 25.0;
        assert!((force / (4.5 * share) - 1.0).abs() < 0.02, "{j}: {force}");
    }
    let shape = disc.profile(&carried.solution).unwrap();
    let area = std::f64::consts::PI * 7.5e-3 * 7.5e-3;
    let down = 4.5 / (area * beads(1.2e6).stiffness());
    assert!((-shape.mean() / down - 1.0).abs() < 0.01, "{} {down}", shape.mean());
}

#[test]
fn a_rigid_load_plate_of_a_fifth_of_a_newton_presses_the_warp_flat() {
    let disc = on_rings(bimetal());
    let at = |force: f64| {
        let carried = disc.pressed(30.0, force, Bond::Touching).unwrap();
        assert!((carried.plate_force / force - 1.0).abs() < 2e-4);
        assert!((carried.forces.iter().sum::<f64>() / force - 1.0).abs() < 1e-3, "{:?}", carried.forces);
        assert!(carried.forces.iter().all(|f| *f >= 0.0), "{:?}", carried.forces);
        disc.profile(&carried.solution).unwrap().sag()
    };
    let (light, heavy) = (at(0.2), at(4.5));
    let free = disc.plate.free_sag(30.0);
    // What remains is the edge layer of the face, nanometres; 142 um of free warp are gone.
    assert!(free > 1e-4 && light.abs() < 1e-4 * free && heavy.abs() < 1e-4 * free, "{light} {heavy} {free}");
}

#[test]
fn an_even_load_tilts_the_outermost_ring() {
    let disc = on_rings(bimetal());
    let carried = disc.carried(0.0, &Loading::Even(4.5), Bond::Bonded).unwrap();
    assert!((carried.forces.iter().sum::<f64>() / 4.5 - 1.0).abs() < 1e-6, "{:?}", carried.forces);
    let shape: Profile = disc.profile(&carried.solution).unwrap();
    // Beyond the last ring nothing carries: the rim hangs lowest.
    let lowest = shape.points.iter().map(|p| p[1]).fold(f64::INFINITY, f64::min);
    assert_eq!(lowest, shape.points.last().unwrap()[1]);
}
