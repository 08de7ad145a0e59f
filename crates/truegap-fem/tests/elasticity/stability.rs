//! Buckling: plates with closed forms, and the bimetal disc that stops being a bowl.

use super::bodies::*;
use truegap_fem::elasticity::*;
use truegap_fem::mesh::*;

/// Clamped disc of radius 0.1 m and thickness 1 mm with expansion 1e-5 /K, heated by 1 K; flat by order, or free to bend.
fn clamped(flat: bool) -> Problem {
    let columns: Vec<f64> = (0..=24).map(|i| 0.1 * f64::from(i) / 24.0).collect();
    let half = |name: &str| Layer { name: name.into(), thickness: 0.5e-3, rows: 1 };
    let mesh = layered_grid(&columns, 0.0, &[half("low"), half("high")]).unwrap();
    let mut p = problem(mesh, Material { law: LawKind::SaintVenantKirchhoff, expansion: 1e-5, ..steel() });
    p.materials.push(p.materials[0]);
    p.temperature = Temperature::uniform(1.0);
    p.conditions = vec![Condition::fix("right", First), Condition::fix("right", Second)];
    if flat {
        p.conditions.push(Condition::fix("low.top", Second));
    }
    p
}

#[test]
fn heated_clamped_plates_buckle_at_the_zeros_of_bessel_functions() {
    // Compressed evenly, mode n goes at N = k^2 D / R^2 with J_{n+1}(k) = 0. The state is kept flat, so that the path
    // can be followed beyond the first instability; the modes are free to bend.
    let free = Solver::new(clamped(false)).unwrap();
    for (n, zero) in [(0, 3.831706), (2, 6.380162), (3, 7.588342)] {
        let exact = zero * zero * 1e-6 / (12.0 * 1.3 * 1e-5 * 0.01);
        let mut state = Solver::new(clamped(true)).unwrap();
        let mut harmonic = Harmonic::new(free.body(), n).unwrap();
        let mut stiffness = |heat: f64| {
            state.advance(heat, &NewtonOptions::default()).unwrap();
            harmonic.softest(&state).unwrap().eigenvalue
        };
        assert!(stiffness(0.5 * exact) > 0.0);
        let (mut low, mut high) = (0.95 * exact, 1.05 * exact);
        for _ in 0..12 {
            let middle = 0.5 * (low + high);
            if stiffness(middle) > 0.0 { low = middle } else { high = middle }
        }
        println!("clamped plate n {n}: {low} K, plate theory {exact}");
        // Shear and the clamped edge's own stress: of the order k^2 (h / R)^2 = 0.2 ... 0.6 %.
        assert!((low / exact - 1.0).abs() < 0.01, "n {n}: {low} against {exact}");
    }
}

#[test]
fn the_bimetal_disc_turns_from_a_bowl_into_a_cylinder_at_11_kelvin() {
    let mut solver = Solver::new(bimetal(LawKind::SaintVenantKirchhoff)).unwrap();
    let found = solver.critical_load(2, [6.0, 15.0], 1e-7, &NewtonOptions::default()).unwrap();
    println!("bimetal n 2: {} K, {} equilibria, {} iterations", found.load, found.equilibria, found.mode.iterations);
    // Ritz: 11.1266 K, a plate theory; it leaves out shear and the edge layer.
    assert!((found.load / 11.1266 - 1.0).abs() < 1e-3, "{}", found.load);
    // There it is stable against three waves, and against none.
    assert!(solver.softest_mode(3).unwrap().eigenvalue > 0.0);
    assert!(solver.softest_mode(0).unwrap().eigenvalue > 0.0);
    // The mode is an ovalling: it grows outwards, mostly along z.
    let nodes = &solver.body().nodes.points;
    let rim = (0..nodes.len()).find(|&i| nodes[i] == [7.5e-3, 0.0]).unwrap();
    assert!(found.mode.amplitude[3 * rim + 1].abs() > 0.9);
}

#[test]
fn what_has_no_harmonics_is_refused() {
    let solver = Solver::new(clamped(false)).unwrap();
    assert!(matches!(solver.softest_mode(1), Err(ElasticityError::Harmonic { harmonic: 1, .. })));
    let planar = Solver::new(Problem { symmetry: truegap_fem::Symmetry::Planar, ..clamped(false) }).unwrap();
    assert!(matches!(planar.softest_mode(2), Err(ElasticityError::Harmonic { .. })));
    let mut solver = solver;
    let err = solver.critical_load(2, [1.0, 2.0], 1e-3, &NewtonOptions::default()).unwrap_err();
    assert!(matches!(err, ElasticityError::NoInstability { .. }), "{err}");
}
