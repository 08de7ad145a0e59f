//! The thin plate on rings against finite elements of the disc: below a load plate, and on rings of rubber.

#![allow(clippy::unwrap_used)]

use std::f64::consts::TAU;
use truegap_audit::disc::{
    BeadSpring, Bond, Disc, Facing, Fineness, Gap, Laminate, Loading, Pressed, Profile, Ring, RingPlate, Rings, Section, Sheet,
    Strains,
};

const FINE: Fineness = Fineness { columns: 40, rows: 1 };
const KELVIN: f64 = 25.0;

/// Tin at the gap, copper, polyimide: thicknesses in um, radius in mm. None of these plates is a sensor that a formula was chosen for.
fn plate(tin: f64, copper: f64, film: f64, radius: f64) -> Laminate {
    let sheet = |name: &str, thickness: f64, young: f64, poisson: f64, expansion: f64| Sheet {
        name: name.into(),
        thickness: 1e-6 * thickness,
        young,
        poisson,
        expansion,
    };
    let sheets = vec![
        sheet("plating", tin, 41.6e9, 0.36, 22.4e-6),
        sheet("conductor", copper, 117e9, 0.34, 16.7e-6),
        sheet("backing", film, 2.5e9, 0.34, 20e-6),
    ];
    Laminate { sheets, radius: 1e-3 * radius }
}

/// The plate on rings of springs, over an insulator on a shield that grows like the copper.
fn on_rings(plate: &Laminate, coverage: f64, zones: usize) -> Disc {
    let (height, expansion) = (170e-6, 16.7e-6);
    let facing = Facing { sheet: Sheet { name: "facing".into(), ..plate.sheets[2].clone() }, shield_expansion: expansion };
    let section = Section::new(plate, &Gap::Rings { height, coverage, zones }, Some(facing.sheet.thickness), FINE).unwrap();
    Disc {
        plate: plate.clone(),
        section,
        beads: Some(BeadSpring { young: 3e6, coverage, height, expansion }),
        rings: Rings::Springs,
        facing: Some(facing),
        air: false,
        strains: Strains::Small,
    }
}

fn thin(disc: &Disc, stiffness: f64, tilt: f64) -> RingPlate {
    let plate = &disc.plate;
    let (bending, poisson, radius) = (plate.bending_stiffness(), plate.poisson(), plate.radius);
    RingPlate { bending, poisson, radius, stiffness, tilt, rings: disc.section.rings.clone() }
}

/// Mean height between and beyond the rings above their own mean, m.
fn lift(disc: &Disc, height: impl Fn(f64) -> f64) -> f64 {
    let on = |r: f64| disc.section.rings.iter().any(|ring| ring.inner <= r && r <= ring.outer);
    let mut sums = [[0.0; 2]; 2];
    let n = 4000;
    for i in 0..n {
        let share = (f64::from(i) + 0.5) / f64::from(n);
        let sum = &mut sums[usize::from(on(share * disc.plate.radius))];
        *sum = [sum[0] + share * height(share), sum[1] + share];
    }
    let [air, rings] = sums.map(|[total, weight]| total / weight);
    air - rings
}

#[test]
fn a_load_plate_on_the_thin_plate_is_that_on_the_disc() {
    // a rim that curls up, and one that curls down; thin plates leave out shear and the edge, which matter more where the plate is 77 um thick
    for (plate, coverage, tolerance) in [(plate(7.0, 20.0, 25.0, 6.0), 0.3, 0.02), (plate(3.0, 14.0, 60.0, 5.0), 0.25, 0.07)] {
        let disc = on_rings(&plate, coverage, 4);
        let stiffness = disc.beads.unwrap().young / disc.beads.unwrap().height;
        let (curvature, thin) = (plate.curvature_per_kelvin() * KELVIN, thin(&disc, stiffness, 1.0));
        let of_disc = |profile: &Profile| lift(&disc, |share| profile.height(share));
        let free = of_disc(&disc.profile(&disc.carried(KELVIN, &Loading::None, Bond::Bonded).unwrap().solution).unwrap());
        for force in [0.1, 0.5, 2.0] {
            let carried = disc.pressed(KELVIN, force, Bond::Bonded).unwrap();
            // what the load alone does is not the warp's
            let cold = disc.pressed(0.0, force, Bond::Bonded).unwrap();
            let [hot, cold] = [carried, cold].map(|c| of_disc(&disc.profile(&c.solution).unwrap()));
            let pressed = thin.pressed(curvature, force, None).unwrap();
            let shape = pressed.shape;
            let found = lift(&disc, |share| shape.height(share * plate.radius));
            println!("{force} N: disc {:e} m, thin plate {found:e} m, of {free:e} m", hot - cold);
            assert!((found - (hot - cold)).abs() < tolerance * free.abs(), "{force} N: {found:e} {:e} of {free:e}", hot - cold);
        }
    }
}

#[test]
fn rings_of_rubber_give_way_to_tilting_as_a_strip_does() {
    // wide rings, a thin plate: tilting matters
    let plate = plate(9.0, 10.0, 10.0, 4.145);
    let rubber =
        Disc { rings: Rings::Rubber { young: 1e6, poisson: 0.499 }, strains: Strains::Large, ..on_rings(&plate, 0.46, 4) };
    let travel = 1e-4 * rubber.beads.unwrap().height;
    let area: f64 = rubber.section.rings.iter().map(|r| std::f64::consts::PI * (r.outer * r.outer - r.inner * r.inner)).sum();
    let stiffness = |disc: &Disc| disc.flattened(0.0, travel).unwrap() / (travel * area);
    let mut springs = Disc { rings: Rings::Springs, ..rubber.clone() };
    let beads = springs.beads.unwrap();
    springs.beads = Some(BeadSpring { young: beads.young * stiffness(&rubber) / stiffness(&springs), ..beads });
    let rim = |disc: &Disc| {
        let [bent, flat] = [disc.carried(KELVIN, &Loading::None, Bond::Bonded), disc.held_flat(KELVIN, 0.0)]
            .map(|found| disc.profile(&found.unwrap().solution).unwrap());
        bent.points.last().unwrap()[1] - flat.mean()
    };
    let by_disc = rim(&rubber) / rim(&springs);
    // Incompressible strip: tilting 4/3 (1 + S² / 5), shortening 4/3 (1 + S²) times Young's modulus (Gent & Meinecke 1970).
    let shape = 0.5 * (rubber.section.rings[0].outer - rubber.section.rings[0].inner) / beads.height;
    let tilt = (1.0 + shape * shape / 5.0) / (1.0 + shape * shape);
    let height = |tilt| thin(&rubber, stiffness(&rubber), tilt).bent(plate.curvature_per_kelvin() * KELVIN, 0.0).rim();
    let by_plate = height(tilt) / height(1.0);
    println!("rim on rubber over rim on springs: disc {by_disc}, thin plate {by_plate} (tilt {tilt})");
    // parabolic pressures below a foot that tilts rigidly: 3 %
    assert!(by_disc > 1.15 && (by_plate / by_disc - 1.0).abs() < 0.03, "{by_disc} {by_plate}");
}

fn clamp(outer: f64, stiffness: f64) -> RingPlate {
    let rings = vec![Ring { inner: 0.0, outer: 0.5 * outer }, Ring { inner: 0.5 * outer, outer }];
    RingPlate { bending: 5e-4, poisson: 0.34, radius: 7.5e-3, stiffness, tilt: 1.0, rings }
}

#[test]
fn a_large_load_leaves_the_overhang_on_a_prop() {
    let (curvature, overhang) = (1.4, 0.4e-3);
    // rings so stiff that they hold the plate like a wall
    let plate = clamp(7.5e-3 - overhang, 1e15);
    let pressed = plate.pressed(curvature, 50.0, None).unwrap();
    // Strip held at one end and propped at the other, its hoop straight: free curvature (1 + nu) k, slope at the prop a quarter of that times its length,
    // force on the prop 3/2 D (1 + nu) k over its length. It is part of a ring 5 % of its radius wide.
    let bent = (1.0 + plate.poisson) * curvature;
    let slope = 0.5 * pressed.shape.mean_bending() * plate.radius;
    assert!((slope / (0.25 * bent * overhang) - 1.0).abs() < 0.05, "{slope}");
    let prop = pressed.forces.last().unwrap() / (TAU * plate.radius);
    assert!((prop / (1.5 * plate.bending * bent / overhang) - 1.0).abs() < 0.05, "{prop}");
    assert!((pressed.forces.iter().sum::<f64>() / 50.0 - 1.0).abs() < 1e-6);
}

#[test]
fn a_load_plate_pushes_only_and_nothing_is_above_it() {
    for (curvature, force) in [(1.4, 1e-3), (1.4, 0.05), (1.4, 2.0), (-1.4, 1e-3), (-1.4, 0.05), (-1.4, 2.0)] {
        let mut plate = clamp(6.9e-3, 1e10);
        plate.rings[0].inner = 2.5e-3;
        let Pressed { shape, level, touching, forces } = plate.pressed(curvature, force, None).unwrap();
        assert!((forces.iter().sum::<f64>() / force - 1.0).abs() < 1e-6);
        assert!(forces.iter().all(|f| *f >= 0.0) && touching.contains(&true));
        let highest = shape.values.iter().map(|v| v[0]).fold(f64::NEG_INFINITY, f64::max);
        assert!((highest - level).abs() < 1e-12, "{highest} {level}");
    }
}

#[test]
fn a_load_plate_without_load_leaves_the_plate_as_it_is() {
    let plate = clamp(6.9e-3, 1e10);
    let (free, pressed) = (plate.bent(1.4, 0.0), plate.pressed(1.4, 1e-9, None).unwrap());
    assert!((pressed.shape.rim() / free.rim() - 1.0).abs() < 1e-6);
    assert_eq!(pressed.touching.iter().filter(|on| **on).count(), 1);
}
