//! The hp version against closed forms, other programs and the refinement of quadratic elements, which shares neither mesh nor estimate.

#![allow(clippy::unwrap_used)]

use truegap_fem::elasticity::{self, Component, Condition, Formulation, LawKind, Material, Order, Temperature};
use truegap_fem::electrostatics::{
    self, Accuracy, Conductor, Goal, HpError, Problem, Quantity, VACUUM_PERMITTIVITY, solve_adaptive,
};
use truegap_fem::mesh::{Geometry, MeshOptions, Outline, mesh_geometry};
use truegap_fem::problems::{
    DISC_CAPACITOR, RUBBER_DISC, RUBBER_SIZE, disc_capacitor_geometry, disc_capacitor_problem, rubber_disc_geometry,
    rubber_disc_problem,
};
use truegap_fem::{FemError, Symmetry};

/// The estimate over the true error, where the reference has the digits to tell.
fn honest(name: &str, target: f64, value: f64, estimate: f64, exact: f64) {
    let (error, estimate) = ((value / exact - 1.0).abs(), estimate / exact.abs());
    println!("{name}, {target:.0e}: off {error:.1e}, estimated {estimate:.1e}");
    assert!(error <= target && estimate <= target, "{name}: off {error:.1e}, estimated {estimate:.1e}, wanted {target:.0e}");
    // Changes between spaces shrink by ratios that rise slowly, so that a sum of them is near the error; the bounds are those of the reference cases.
    assert!((0.9..=3.0).contains(&(estimate / error)), "{name}, {target:.0e}: effectivity {:.2}", estimate / error);
}

#[test]
fn the_disc_capacitor_has_the_capacitance_of_love() {
    let (problem, goals) = disc_capacitor_problem();
    let mesh = mesh_geometry(&disc_capacitor_geometry(), &MeshOptions::default()).unwrap();
    for target in [1e-3, 1e-4, 1e-5, 1e-6] {
        let found = electrostatics::solve_hp(&problem, &goals, &mesh, target).unwrap();
        let c = &found.answers[0];
        honest("disc capacitor", target, c.value, c.error_estimate, DISC_CAPACITOR * VACUUM_PERMITTIVITY);
    }
}

#[test]
fn the_bonded_rubber_disc_is_as_stiff_as_another_program_finds_it() {
    let mesh = mesh_geometry(&rubber_disc_geometry(), &MeshOptions::default()).unwrap();
    let (problem, goals) = rubber_disc_problem(mesh, Formulation::suited(0.49));
    let exact = -RUBBER_DISC * std::f64::consts::PI * RUBBER_SIZE[0] * RUBBER_SIZE[0] * 1e-3 * 1e6;
    for target in [1e-3, 1e-4, 1e-5, 1e-6] {
        let found = elasticity::solve_hp(&problem, &goals, target).unwrap();
        honest("rubber disc", target, found.answers[0].value, found.answers[0].error_estimate, exact);
    }
}

/// Two strips on a board in a grounded can, planar: corners of two dielectrics with and without a conductor, and a matrix of capacitances.
#[test]
fn dielectrics_and_several_conductors_agree_with_the_refinement_of_quadratic_elements() {
    let box_ = [[-4.0, -4.0], [4.0, -4.0], [4.0, 4.0], [-4.0, 4.0], [-4.0, -4.0]];
    let drawing = Geometry::default()
        .region("air", Outline::rectangle([-4.0, -4.0], [4.0, 4.0]))
        .region("board", Outline::rectangle([-2.0, -0.5], [2.0, 0.0]))
        .boundary("left", &[[-1.5, 0.0], [-0.5, 0.0]])
        .boundary("right", &[[0.5, 0.0], [1.5, 0.0]])
        .boundary("can", &box_);
    let at = |boundary: &str, potential| Conductor { boundary: boundary.into(), potential };
    let problem = Problem {
        symmetry: Symmetry::Planar,
        permittivity: vec![("air".into(), VACUUM_PERMITTIVITY), ("board".into(), 4.5 * VACUUM_PERMITTIVITY)],
        conductors: vec![at("left", 1.0), at("right", 0.0), at("can", 0.0)],
        open: vec![],
    };
    let goals = [Quantity { name: "C".into(), goal: Goal::CapacitanceMatrix }, Quantity { name: "W".into(), goal: Goal::Energy }];
    let mut mesh = mesh_geometry(&drawing, &MeshOptions::default()).unwrap();
    let found = electrostatics::solve_hp(&problem, &goals, &mesh, 1e-4).unwrap();
    let other = solve_adaptive(&problem, &goals, &mut mesh, &Accuracy { target: 1e-4, ..Accuracy::default() }).unwrap();
    assert_eq!(found.answers.len(), 10);
    for (a, b) in found.answers.iter().zip(&other.answers) {
        assert_eq!((&a.name, a.unit), (&b.name, b.unit));
        assert!((a.value - b.value).abs() <= a.error_estimate + b.error_estimate, "{a:?} against {b:?}");
        assert!(a.error_estimate <= 1e-4 * a.scale && a.value != 0.0);
    }
}

#[test]
fn a_field_that_is_a_polynomial_is_exact_in_the_first_spaces() {
    let drawing = Geometry::default()
        .region("gap", Outline::rectangle([0.0, 0.0], [4e-3, 2e-3]))
        .boundary("top", &[[0.0, 2e-3], [4e-3, 2e-3]])
        .boundary("bottom", &[[0.0, 0.0], [4e-3, 0.0]]);
    let mesh = mesh_geometry(&drawing, &MeshOptions::default()).unwrap();
    let at = |boundary: &str, potential| Conductor { boundary: boundary.into(), potential };
    for (symmetry, area_over_gap) in
        [(Symmetry::Planar, 2.0), (Symmetry::Axisymmetric, std::f64::consts::PI * 4e-3 * 4e-3 / 2e-3)]
    {
        let problem = Problem {
            symmetry,
            permittivity: vec![("gap".into(), VACUUM_PERMITTIVITY)],
            conductors: vec![at("top", 1.0), at("bottom", 0.0)],
            open: vec![],
        };
        let goals = [Quantity { name: "C".into(), goal: Goal::Capacitance { boundary: "top".into() } }];
        let found = electrostatics::solve_hp(&problem, &goals, &mesh, 1e-4).unwrap();
        assert!((found.answers[0].value / (area_over_gap * VACUUM_PERMITTIVITY) - 1.0).abs() < 1e-11);
        assert_eq!(found.levels, 2);
    }
}

/// A bar pressed between smooth plates: stress E / (1 - nu^2) times strain in plane strain, E times strain with a free mantle.
#[test]
fn a_uniform_stress_is_exact_in_both_symmetries() {
    let drawing = Geometry::default()
        .region("bar", Outline::rectangle([0.0, 0.0], [1e-3, 2e-3]))
        .boundary("bottom", &[[0.0, 0.0], [1e-3, 0.0]])
        .boundary("top", &[[0.0, 2e-3], [1e-3, 2e-3]])
        .boundary("side", &[[0.0, 0.0], [0.0, 2e-3]]);
    let (young, poisson) = (1e6, 0.3);
    for (symmetry, force) in [
        (Symmetry::Planar, young / (1.0 - poisson * poisson) * 1e-3),
        (Symmetry::Axisymmetric, young * std::f64::consts::PI * 1e-6),
    ] {
        let problem = elasticity::Problem {
            mesh: mesh_geometry(&drawing, &MeshOptions::default()).unwrap(),
            symmetry,
            materials: vec![Material {
                young,
                poisson,
                expansion: 0.0,
                law: LawKind::Linear,
                formulation: Formulation::Displacement,
            }],
            conditions: vec![
                Condition::fix("bottom", Component::Second),
                Condition::fix("side", Component::First),
                Condition::displace("top", Component::Second, 2e-6),
            ],
            temperature: Temperature::uniform(0.0),
            body_force: None,
            order: Order::Quadratic,
        };
        let goal = |name: &str, goal| elasticity::Quantity { name: name.into(), goal };
        let reaction = elasticity::Goal::Reaction { boundary: "top".into(), component: Component::Second };
        let goals = [goal("F", reaction), goal("W", elasticity::Goal::Energy)];
        let found = elasticity::solve_hp(&problem, &goals, 1e-4).unwrap();
        assert!((found.answers[0].value / (force * 1e-3) - 1.0).abs() < 1e-9, "{found:?}");
        assert!((found.answers[1].value / (0.5 * force * 1e-3 * 2e-6) - 1.0).abs() < 1e-9, "{found:?}");
    }
}

#[test]
fn what_is_not_of_its_kind_is_left_to_the_other_way() {
    let (problem, _) = disc_capacitor_problem();
    let mesh = mesh_geometry(&disc_capacitor_geometry(), &MeshOptions::default()).unwrap();
    let goals = [Quantity { name: "V".into(), goal: Goal::Potential { at: [0.5, 0.0] } }];
    let refused = electrostatics::solve_hp(&problem, &goals, &mesh, 1e-3).unwrap_err();
    assert!(matches!(&refused, FemError::Hp(HpError::Output { output, .. }) if output == "V"), "{refused}");
    let (mut problem, goals) =
        rubber_disc_problem(mesh_geometry(&rubber_disc_geometry(), &MeshOptions::default()).unwrap(), Formulation::Mixed);
    problem.materials[0].poisson = 0.5;
    let refused = elasticity::solve_hp(&problem, &goals, 1e-3).unwrap_err();
    assert!(matches!(refused, FemError::Hp(HpError::Poisson { poisson: 0.5, .. })), "{refused}");
    problem.materials[0] = Material { poisson: 0.3, law: LawKind::NeoHookean, ..problem.materials[0] };
    let refused = elasticity::solve_hp(&problem, &goals, 1e-3).unwrap_err();
    assert!(matches!(refused, FemError::Hp(HpError::Law { .. })), "{refused}");
}

#[test]
fn a_body_that_nothing_holds_is_refused_with_the_reason() {
    let (mut problem, goals) =
        rubber_disc_problem(mesh_geometry(&rubber_disc_geometry(), &MeshOptions::default()).unwrap(), Formulation::Mixed);
    problem.conditions.retain(|c| !matches!(c, Condition::Displacement { component: Component::Second, .. }));
    let goals = [elasticity::Quantity { name: "W".into(), goal: elasticity::Goal::Energy }, goals[0].clone()];
    assert!(elasticity::solve_hp(&problem, &goals[..1], 1e-3).is_err());
}
