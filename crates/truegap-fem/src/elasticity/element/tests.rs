//! Energy, residual and tangent of whole elements against each other by differences.

use super::*;
use crate::elasticity::{Component, Condition, Problem, Temperature};
use crate::mesh::{Layer, layered_grid};
use crate::symmetry::Symmetry;

fn body(law: LawKind, formulation: Formulation, symmetry: Symmetry) -> Body {
    let layers = [Layer { name: "body".into(), thickness: 0.8, rows: 1 }];
    let mut mesh = layered_grid(&[0.7, 1.5], 0.2, &layers).unwrap();
    mesh.points[1] = [1.7, 0.1];
    Body::new(Problem {
        mesh,
        symmetry,
        materials: vec![Material { young: 2.0, poisson: 0.35, expansion: 0.01, law, formulation }],
        conditions: vec![Condition::fix("bottom", Component::First), Condition::fix("bottom", Component::Second)],
        temperature: Temperature::Linear { base: 3.0, gradient: [1.0, -2.0] },
        body_force: None,
        order: Order::Quadratic,
    })
    .unwrap()
}

fn state(body: &Body, seed: f64) -> Vec<f64> {
    (0..body.dofs.count).map(|i| ((i as f64 + 1.0) * seed).sin()).collect()
}

fn energy(body: &Body, tables: &Tables, u: &[f64]) -> f64 {
    let mut energy = Energy(0.0);
    evaluate_points(body, tables, 0, u, 0.8, false, &mut energy);
    energy.0
}

fn residual(body: &Body, tables: &Tables, u: &[f64]) -> Vec<f64> {
    let mut out = vec![0.0; body.dofs.of(0).len()];
    evaluate_points(body, tables, 0, u, 0.8, false, &mut Residual(&mut out));
    out
}

#[test]
fn residual_is_the_slope_of_energy_and_tangent_that_of_the_residual() {
    let tables = Tables::new();
    for symmetry in [Symmetry::Axisymmetric, Symmetry::Planar] {
        for law in [LawKind::Linear, LawKind::SaintVenantKirchhoff, LawKind::NeoHookean] {
            for formulation in [Formulation::Displacement, Formulation::Mixed] {
                let body = body(law, formulation, symmetry);
                let (base, along) = (state(&body, 0.7), state(&body, 1.3));
                let at = |t: f64| -> Vec<f64> { base.iter().zip(&along).map(|(b, a)| 0.02 * b + t * a).collect() };
                let of = body.dofs.of(0);
                let m = of.len();
                let step = 1e-3;
                // Fourth-order differences: truncation of order step^4 = 1e-12 times derivatives of order 1e3.
                let slope =
                    |f: &dyn Fn(f64) -> f64| (8.0 * (f(step) - f(-step)) - f(2.0 * step) + f(-2.0 * step)) / (12.0 * step);
                let analytic: f64 = residual(&body, &tables, &at(0.0)).iter().zip(of).map(|(r, &d)| r * along[d as usize]).sum();
                let numeric = slope(&|t| energy(&body, &tables, &at(t)));
                assert!(
                    (analytic - numeric).abs() < 1e-8 * (1.0 + analytic.abs()),
                    "{law:?} {formulation:?}: {analytic} {numeric}"
                );
                let mut matrix = vec![0.0; m * m];
                evaluate_points(&body, &tables, 0, &at(0.0), 0.8, true, &mut Tangent(&mut matrix));
                for i in 0..m {
                    let analytic: f64 = (0..m).map(|j| matrix[i.min(j) * m + i.max(j)] * along[of[j] as usize]).sum();
                    let numeric = slope(&|t| residual(&body, &tables, &at(t))[i]);
                    assert!(
                        (analytic - numeric).abs() < 1e-7 * (1.0 + analytic.abs()),
                        "{law:?} {formulation:?} row {i}: {analytic} {numeric}"
                    );
                }
            }
        }
    }
}
