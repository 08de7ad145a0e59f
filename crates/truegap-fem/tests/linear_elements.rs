//! Linear elements of electrostatics (`order = 1`): exact where the field is, of second order where it is not, honest in their
//! estimates, and worse than quadratic ones.

#![allow(clippy::unwrap_used)]

use std::path::Path;
use truegap_fem::Symmetry;
use truegap_fem::case::{read_case, solve_case};
use truegap_fem::electrostatics::*;
use truegap_fem::mesh::*;

const EPS: f64 = VACUUM_PERMITTIVITY;

fn problem(symmetry: Symmetry) -> Problem {
    let conductor = |boundary: &str, potential| Conductor { boundary: boundary.into(), potential };
    Problem {
        symmetry,
        permittivity: vec![("space".into(), EPS)],
        conductors: vec![conductor("one", 1.0), conductor("two", -2.0)],
        open: Vec::new(),
    }
}

/// A rectangle of height 1 between two conductors at r = `low` and r = `high`.
fn between(low: f64, high: f64, edge: f64) -> Mesh {
    let g = Geometry::default()
        .region("space", Outline::rectangle([low, 0.0], [high, 1.0]))
        .boundary("one", &[[low, 0.0], [low, 1.0]])
        .boundary("two", &[[high, 0.0], [high, 1.0]]);
    mesh_geometry(&g, &MeshOptions { size: SizeField::uniform(edge), ..Default::default() }).unwrap()
}

fn capacitance(symmetry: Symmetry, mesh: &Mesh, order: Order) -> f64 {
    Solved::of_order(&problem(symmetry), mesh, order).unwrap().capacitance_matrix()[0][0]
}

#[test]
fn a_uniform_field_is_exact() {
    // Planar plates 2 m apart, 1 m high: eps / 2 per metre; rounding of a few hundred unknowns.
    let mesh = between(1.0, 3.0, 0.2);
    assert!((capacitance(Symmetry::Planar, &mesh, Order::Linear) / (EPS / 2.0) - 1.0).abs() < 1e-12);
}

#[test]
fn a_logarithm_converges_with_the_order_of_the_elements() {
    // Coaxial cylinders 1 and 2: 2 pi eps / ln 2 per metre. Capacitances converge twice as fast as fields: h^2, and h^4.
    let exact = std::f64::consts::TAU * EPS / 2f64.ln();
    let error = |edge: f64, order| capacitance(Symmetry::Axisymmetric, &between(1.0, 2.0, edge), order) / exact - 1.0;
    let [coarse, fine] = [0.1, 0.05].map(|h| error(h, Order::Linear));
    let [coarse_2, fine_2] = [0.1, 0.05].map(|h| error(h, Order::Quadratic));
    // Galerkin energies lie above the exact one; meshes of the generator do not halve exactly.
    assert!(fine > 0.0 && (3.0..5.5).contains(&(coarse / fine)), "{coarse:.2e} {fine:.2e}");
    assert!(fine_2 > 0.0 && (10.0..25.0).contains(&(coarse_2 / fine_2)), "{coarse_2:.2e} {fine_2:.2e}");
    // The curve: a field of curvature u'' = 1 / r^2 / ln 2 leaves about h^2 / 12 of it on edges of length h.
    assert!((1e-4..1e-3).contains(&coarse), "{coarse:.2e}");
    assert!(fine > 100.0 * fine_2);
}

#[test]
fn charge_is_the_slope_of_energy_and_reciprocity_holds() {
    let problem = problem(Symmetry::Axisymmetric);
    let mesh = between(1.0, 2.0, 0.15);
    let solved = Solved::of_order(&problem, &mesh, Order::Linear).unwrap();
    let c = solved.capacitance_matrix();
    // No field leaves the box: rows sum to zero. Rounding of sums of a few hundred terms.
    assert!((c[0][0] + c[0][1]).abs() < 1e-12 * c[0][0] && (c[0][1] - c[1][0]).abs() < 1e-12 * c[0][0]);
    assert!((solved.energy() / (0.5 * c[0][0] * 9.0) - 1.0).abs() < 1e-12);
    assert!((solved.charges()[0] / (c[0][0] * 3.0) - 1.0).abs() < 1e-12);
}

#[test]
fn the_unknowns_are_the_corners() {
    let mesh = between(1.0, 2.0, 0.15);
    let problem = problem(Symmetry::Planar);
    let on_plates = mesh.points.iter().filter(|p| p[0] == 1.0 || p[0] == 2.0).count();
    let solved = Solved::of_order(&problem, &mesh, Order::Linear).unwrap();
    assert_eq!(solved.unknowns(), mesh.points.len() - on_plates);
    // Every potential at the middle of an edge is the mean of its ends.
    let v = &solved.potential;
    for (edge, [a, b]) in solved.topology.edges.iter().enumerate() {
        assert!((v[mesh.points.len() + edge] - 0.5 * (v[*a as usize] + v[*b as usize])).abs() < 1e-12);
    }
}

/// A case of `meshes/cases` with linear elements: relative error, effectivity, unknowns.
fn linear_case(name: &str, output: &str, exact: f64, target: f64) -> (f64, f64, usize) {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("../../meshes/cases/{name}.toml"));
    let text = std::fs::read_to_string(file).unwrap();
    let from = text.find("target_error").unwrap();
    let line = text[from..].lines().next().unwrap();
    let text = text.replace(line, &format!("target_error = {target}\norder = 1"));
    let result = solve_case(&read_case(&text, name).unwrap()).unwrap();
    let q = result.quantity(output).unwrap();
    assert!(q.error_over_scale <= target);
    (q.value / exact - 1.0, q.error_estimate / (q.value - exact).abs(), result.mesh.unknowns)
}

#[test]
fn linear_elements_meet_their_target_with_an_honest_estimate() {
    let cases = [
        ("coaxial_cable", "C", std::f64::consts::TAU * EPS / 2f64.ln()),
        ("isolated_disc", "C", 8.0 * EPS * 1e-3),
        ("sphere_two_layers", "C", 47.472955654246 * EPS * 1e-3),
    ];
    for (name, output, exact) in cases {
        let (error, effectivity, unknowns) = linear_case(name, output, exact, 2e-3);
        println!("{name}: off {error:.1e}, effectivity {effectivity:.2}, {unknowns} unknowns");
        assert!(error.abs() <= 2e-3 && error != 0.0, "{name}: off {error:.1e}");
        // Linear fields on open space and on arcs: the range asked of all estimates.
        assert!((0.5..=3.0).contains(&effectivity), "{name}: effectivity {effectivity}");
    }
}
