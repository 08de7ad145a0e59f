//! Dual problems under a following pressure: what a small force does to a displacement, foretold by the dual and found by
//! solving again.

use super::*;
use crate::elasticity::{Component, Condition, Formulation, Material, NewtonOptions, Order, Temperature};
use crate::mesh::{Layer, layered_grid};
use crate::symmetry::Symmetry;

/// A beam held on the left, a following pressure on top, which ends at a free corner, and a small dead one on the right.
fn beam(symmetry: Symmetry, dead: f64) -> Solver {
    let layers = [Layer { name: "body".into(), thickness: 0.5, rows: 1 }];
    let columns: Vec<f64> = (0..=4).map(|i| 1.0 + 0.5 * f64::from(i)).collect();
    let mesh = layered_grid(&columns, 0.0, &layers).unwrap();
    let fixed = [Component::First, Component::Second].map(|c| Condition::fix("left", c));
    let mut conditions = fixed.to_vec();
    conditions.extend([Condition::pressure("top", 0.02), Condition::dead_pressure("right", dead)]);
    let problem = Problem {
        mesh,
        symmetry,
        materials: vec![Material {
            young: 1.0,
            poisson: 0.3,
            expansion: 0.0,
            law: LawKind::NeoHookean,
            formulation: Formulation::Displacement,
        }],
        conditions,
        temperature: Temperature::uniform(0.0),
        body_force: None,
        order: Order::Quadratic,
    };
    let mut solver = Solver::new(problem).unwrap();
    solver.advance(1.0, &NewtonOptions { tolerance: 1e-13, ..NewtonOptions::default() }).unwrap();
    solver
}

#[test]
fn the_dual_foretells_what_a_small_force_does() {
    for symmetry in [Symmetry::Planar, Symmetry::Axisymmetric] {
        let mut solver = beam(symmetry, 0.0);
        assert!(!solver.body.jumps.is_empty());
        let step = 1e-5;
        let [more, less] = [step, -step].map(|p| beam(symmetry, p));
        let count = solver.state.len();
        let corner = solver.body.nodes.points.iter().position(|p| (p[0] - 3.0).hypot(p[1]) < 1e-12).unwrap();
        for dof in [2 * corner, 2 * corner + 1] {
            let mut wanted = vec![0.0; count];
            wanted[dof] = 1.0;
            solver.factorise(1.0).unwrap();
            let dual = solver.dual(&wanted, vec![0.0; count]).unwrap();
            let foretold: f64 = dual.iter().zip(&more.body.external).map(|(z, f)| z * f / step).sum();
            let found = (more.state[dof] - less.state[dof]) / (2.0 * step);
            // Central differences: squares of 1e-5, and 1e-13 / 1e-5 of rounding.
            assert!((foretold / found - 1.0).abs() < 1e-6, "{symmetry:?} {dof}: {foretold} {found}");
        }
    }
}
