//! Large deformation: closed forms, two formulations against each other, and the heated bimetal disc.

use super::bodies::*;
use truegap_fem::elasticity::*;
use truegap_fem::mesh::*;

fn neo(poisson: f64, formulation: Formulation) -> Material {
    Material { law: LawKind::NeoHookean, ..rubber(poisson, formulation) }
}

fn smooth_compression(material: Material, stretch: f64) -> Solution {
    let mut p = problem(rectangle([0.0, 0.0], [1.0, 1.0], SizeField::uniform(0.4)), material);
    p.conditions = vec![Condition::fix("bottom", Second), Condition::displace("top", Second, stretch - 1.0)];
    Solver::new(p).unwrap().solve().unwrap()
}

/// Nominal stress and lateral stretch of a bar stretched by `axial`, by bisection on the lateral equilibrium.
fn uniaxial(material: Material, axial: f64) -> (f64, f64) {
    let lame = material.lame();
    let (mu, la) = (lame.mu, lame.lambda());
    if material.poisson == 0.5 {
        return (mu * (axial - 1.0 / (axial * axial)), axial.powf(-0.5));
    }
    let side = |s: f64| mu * (s - 1.0 / s) + la * (s * s * axial - 1.0) * s * axial;
    let (mut low, mut high) = (0.2, 5.0);
    for _ in 0..200 {
        let middle = 0.5 * (low + high);
        if side(middle) > 0.0 { high = middle } else { low = middle }
    }
    (mu * (axial - 1.0 / axial) + la * (low * low * axial - 1.0) * low * low, low)
}

#[test]
fn smooth_uniaxial_stretch_follows_the_closed_form() {
    for (nu, formulation) in
        [(0.3, Formulation::Displacement), (0.3, Formulation::Mixed), (0.4999, Formulation::Mixed), (0.5, Formulation::Mixed)]
    {
        for stretch in [0.6, 1.8] {
            let material = neo(nu, formulation);
            let s = smooth_compression(material, stretch);
            let (stress, side) = uniaxial(material, stretch);
            let force = s.reaction("top", Second).unwrap();
            assert!((force / (stress * std::f64::consts::PI) - 1.0).abs() < 1e-8, "nu {nu} stretch {stretch}: {force}");
            let u = s.displacement_at([1.0, 0.3]).unwrap()[0];
            assert!((u - (side - 1.0)).abs() < 1e-9);
            // Cauchy stress: force over the deformed area.
            let zz = s.stress_at([0.5, 0.5]).unwrap().zz;
            assert!((zz * side * side / stress - 1.0).abs() < 1e-7, "{zz}");
        }
    }
}

fn pressed_disc(material: Material, part: f64) -> Solution {
    let mut p = problem(rubber_disc(25e-6, 25e-6), material);
    let fixed = ["bottom", "top"].map(|b| Condition::fix(b, First));
    p.conditions = fixed.to_vec();
    p.conditions.extend([Condition::fix("bottom", Second), Condition::displace("top", Second, -part * 198e-6)]);
    Solver::new(p).unwrap().solve().unwrap()
}

#[test]
fn the_reaction_is_the_slope_of_the_energy_at_large_strain() {
    for material in [neo(0.49, Formulation::Displacement), neo(0.49, Formulation::Mixed), neo(0.5, Formulation::Mixed)] {
        let d = 1e-3;
        let e = |part: f64| pressed_disc(material, part).energy();
        let slope = (e(0.2 + d) - e(0.2 - d)) / (2.0 * d * -198e-6);
        let force = pressed_disc(material, 0.2).reaction("top", Second).unwrap();
        // Central difference: d^2 / 6 times the third derivative over the first, about 50.
        assert!((slope / force - 1.0).abs() < 3e-5, "{slope} {force}");
    }
}

#[test]
fn formulations_agree_at_large_strain_and_rubber_stiffens() {
    let force = |m: Material, part: f64| pressed_disc(m, part).reaction("top", Second).unwrap() / part;
    let (a, b) = (force(neo(0.3, Formulation::Displacement), 0.2), force(neo(0.3, Formulation::Mixed), 0.2));
    // Both meshes alike: displacements alone are stiffer by their share of the corner's error.
    assert!((a / b - 1.0).abs() < 0.01, "{a} {b}");
    let b = force(neo(0.49, Formulation::Mixed), 0.2);
    let linear = force(rubber(0.49, Formulation::Mixed), 0.2);
    let small = force(neo(0.49, Formulation::Mixed), 1e-5);
    assert!((small / linear - 1.0).abs() < 1e-4, "{small} {linear}");
    assert!(b / linear > 1.2 && b / linear < 2.0, "{b} {linear}");
}

#[test]
fn a_free_finite_body_expands_without_stress() {
    for law in [LawKind::NeoHookean, LawKind::SaintVenantKirchhoff] {
        let mut p = problem(
            rectangle([0.0, 0.0], [1.0, 1.0], SizeField::uniform(0.4)),
            Material { law, ..rubber(0.3, Formulation::Displacement) },
        );
        p.temperature = Temperature::uniform(500.0);
        p.conditions = vec![Condition::fix("bottom", Second)];
        let s = Solver::new(p).unwrap().solve().unwrap();
        let u = s.displacement_at([1.0, 1.0]).unwrap();
        assert!((u[0] - 0.1).abs() < 1e-10 && (u[1] - 0.1).abs() < 1e-10, "{u:?}");
        assert!(s.stress_at([0.5, 0.5]).unwrap().rr.abs() < 1e-3);
        let moved = s.deformed_mesh();
        assert!(moved.points.iter().any(|p| (p[0] - 1.1).abs() < 1e-9 && (p[1] - 1.1).abs() < 1e-9));
    }
}

/// Rim deflections of the heated disc without ripples (um), from independent finite elements and a Ritz calculation.
const AXISYMMETRIC: [(f64, f64); 6] =
    [(3.0, 12.870), (6.0, 21.792), (9.0, 28.216), (12.0, 33.248), (15.0, 37.413), (30.0, 51.856)];

#[test]
fn the_linear_bimetal_disc_bends_as_the_plate_theory_says() {
    let mut solver = Solver::new(bimetal(LawKind::Linear)).unwrap();
    let s = solver.advance(30.0, &NewtonOptions::default()).unwrap();
    println!("bimetal linear: {} um, correction {:.1e}, {} unknowns", rim_um(&s), s.correction, s.body().numbering.free.len());
    // Six digits published; a solver that loses four digits to the condition number of 1e14 fails.
    assert!((rim_um(&s) / 142.70609 - 1.0).abs() < 2e-6, "{}", rim_um(&s));
    assert!(s.correction < 1e-10);
}

#[test]
fn the_bimetal_disc_stiffens_as_it_bends() {
    let mut solver = Solver::new(bimetal(LawKind::SaintVenantKirchhoff)).unwrap();
    for (heat, exact) in AXISYMMETRIC {
        let s = solver.advance(heat, &NewtonOptions::default()).unwrap();
        println!("bimetal {heat} K: {} um (published {exact}), counters {:?}", rim_um(&s), solver.counters());
        // Published to five digits by routes in which the disc itself does not grow: that is a dT = 2.24e-5 a kelvin.
        assert!((rim_um(&s) / exact - 1.0).abs() < 5e-5 + 2.24e-5 * heat, "{heat} K: {} against {exact}", rim_um(&s));
    }
    assert_eq!(solver.counters().analyses, 1);
}
