//! Nearly incompressible bodies: locking of displacements alone, and its absence in the mixed formulation.

use super::bodies::*;
use truegap_fem::elasticity::*;
use truegap_fem::mesh::*;

/// Converged apparent moduli (Poisson's ratio, upper face bonded, E_a / E).
const DISC: [(f64, bool, f64); 5] = [
    (0.49, true, 1.96621337023),
    (0.4999, true, 2.08689811082),
    (0.5, true, 2.08823411873),
    (0.49, false, 1.31212227),
    (0.4999, false, 1.33343057),
];

#[test]
fn the_mixed_disc_is_accurate_up_to_incompressibility() {
    for (nu, bonded, exact) in DISC {
        let e = apparent_modulus(rubber_disc(12e-6, 0.08e-6), rubber(nu, Formulation::Mixed), Order::Quadratic, bonded);
        println!("mixed disc nu {nu} bonded {bonded}: {e} error {:.2e}", e / exact - 1.0);
        // The corner singularity leaves about (0.08 / 100)^1.4 of the mesh's grading.
        assert!((e / exact - 1.0).abs() < 1e-4, "nu {nu}: {e} against {exact}");
    }
}

#[test]
fn displacements_alone_lock_and_the_mixed_formulation_does_not() {
    let error = |nu: f64, exact: f64, formulation, order| {
        let mesh = rectangle([0.0, 0.0], [291.5e-6, 198e-6], SizeField::uniform(198e-6 / 5.0));
        apparent_modulus(mesh, rubber(nu, formulation), order, true) / exact - 1.0
    };
    let mut table = Vec::new();
    for &(nu, _, exact) in &DISC[..2] {
        let row = [
            error(nu, exact, Formulation::Displacement, Order::Linear),
            error(nu, exact, Formulation::Displacement, Order::Quadratic),
            error(nu, exact, Formulation::Mixed, Order::Quadratic),
        ];
        println!("5 layers, nu {nu}: P1 {:+.4} P2 {:+.4} mixed {:+.4}", row[0], row[1], row[2]);
        table.push(row);
    }
    // Peers on their own 5 layers: P1 +12.7 % and +974 %, P2 +0.67 % and +1.16 %, Taylor-Hood +0.50 % and +0.55 %.
    assert!(table[0][0] > 0.03 && table[0][0] < 0.3);
    assert!(table[1][0] > 2.0);
    for row in &table {
        assert!(row[1] > 0.0 && row[1] < 0.06);
        assert!(row[2].abs() < 0.03);
        assert!(row[2].abs() < row[1]);
    }
    // Quadratic displacements get worse towards 1/2, the mixed formulation hardly.
    assert!(table[1][1] > 1.2 * table[0][1]);
}

#[test]
fn both_formulations_agree_where_both_are_good() {
    let e = |formulation| apparent_modulus(rubber_disc(12e-6, 0.5e-6), rubber(0.3, formulation), Order::Quadratic, true);
    let (a, b) = (e(Formulation::Displacement), e(Formulation::Mixed));
    assert!((a / b - 1.0).abs() < 1e-4, "{a} {b}");
}

#[test]
fn pressure_may_jump_between_regions() {
    // A rubber layer between stiff ones, pressed evenly between smooth walls: every layer has its own pressure.
    let layer = |name: &str| Layer { name: name.into(), thickness: 1.0, rows: 2 };
    let mesh = layered_grid(&[0.0, 1.0, 2.0], 0.0, &[layer("a"), layer("b")]).unwrap();
    let soft = rubber(0.499, Formulation::Mixed);
    let hard = Material { young: 100e6, poisson: 0.46, ..soft };
    let mut p = problem(mesh, soft);
    p.materials.push(hard);
    p.conditions =
        vec![Condition::fix("bottom", Second), Condition::displace("top", Second, -1e-3), Condition::fix("right", First)];
    let s = Solver::new(p).unwrap().solve().unwrap();
    // Springs in series with the oedometric modulus of each layer.
    let oedometric = |m: Material| 2.0 * m.lame().mu + m.lame().lambda();
    let stress = -1e-3 / (1.0 / oedometric(soft) + 1.0 / oedometric(hard));
    for (region, z) in [("a", 0.5), ("b", 1.5)] {
        let zz = s.stress_in(region, [1.0, z]).unwrap().zz;
        assert!((zz / stress - 1.0).abs() < 1e-8, "{region}: {zz} against {stress}");
    }
}
