//! The load stiffness against differences of the forces, and forces against the geometry of the surface they act on.

use super::*;
use crate::algebra::assemble_vector;
use crate::elasticity::ends::{add_product, ends};
use crate::elasticity::{Component, Condition, Formulation, LawKind, Material, Problem, Temperature};
use crate::mesh::{Layer, layered_grid};

/// A strip of two elements by one, held below, with a pressure on the named sides.
fn body(symmetry: Symmetry, order: Order, sides: &[&str]) -> Body {
    let layers = [Layer { name: "body".into(), thickness: 0.8, rows: 1 }];
    let mut mesh = layered_grid(&[0.7, 1.1, 1.5], 0.2, &layers).unwrap();
    mesh.points[1] = [1.2, 0.1];
    let law = LawKind::NeoHookean;
    let mut conditions = vec![Condition::fix("bottom", Component::First), Condition::fix("bottom", Component::Second)];
    conditions.extend(sides.iter().map(|s| Condition::pressure(s, 3.0)));
    Body::new(Problem {
        mesh,
        symmetry,
        materials: vec![Material { young: 2.0, poisson: 0.35, expansion: 0.0, law, formulation: Formulation::Displacement }],
        conditions,
        temperature: Temperature::uniform(0.0),
        body_force: None,
        order,
    })
    .unwrap()
}

fn state(body: &Body, seed: f64) -> Vec<f64> {
    (0..body.dofs.count).map(|i| ((i as f64 + 1.0) * seed).sin()).collect()
}

const LOAD: f64 = 0.8;

fn forces(body: &Body, state: &[f64]) -> Vec<f64> {
    assemble_vector(&body.dofs, |e, out| add_residual(body, e, state, LOAD, out))
}

#[test]
fn the_load_stiffness_is_the_slope_of_the_forces() {
    for symmetry in [Symmetry::Axisymmetric, Symmetry::Planar] {
        for order in [Order::Linear, Order::Quadratic] {
            for sides in [&["top"][..], &["right"], &["top", "right"]] {
                let body = body(symmetry, order, sides);
                let (base, along) = (state(&body, 0.7), state(&body, 1.3));
                let at = |t: f64| -> Vec<f64> { base.iter().zip(&along).map(|(b, a)| 0.1 * b + t * a).collect() };
                let mut analytic =
                    crate::algebra::element_residual(&body.dofs, &along, |e, out| add_tangent(&body, e, &at(0.0), LOAD, out));
                let symmetric = analytic.clone();
                add_product(&ends(&body, &at(0.0), LOAD), &along, 1.0, &mut analytic);
                // The forces are cubic in the displacement: fourth-order differences are exact but for rounding / step.
                let step = 0.1;
                let [a, b, c, d] = [-2.0, -1.0, 1.0, 2.0].map(|k| forces(&body, &at(k * step)));
                let size = analytic.iter().fold(0.0f64, |m, f| m.max(f.abs()));
                let mut skew: f64 = 0.0;
                for i in 0..analytic.len() {
                    let numeric = (a[i] - 8.0 * b[i] + 8.0 * c[i] - d[i]) / (12.0 * step);
                    assert!((analytic[i] - numeric).abs() < 1e-12 * size, "{symmetry:?} {order:?} {sides:?} {i}");
                    skew = skew.max((symmetric[i] - numeric).abs());
                }
                // Free ends make it unsymmetric: without them the slope is another one.
                assert!(skew > 1e-2 * size, "{symmetry:?} {order:?} {sides:?}: {skew}");
            }
        }
    }
}

#[test]
fn a_closed_surface_bears_no_force_and_no_end() {
    for symmetry in [Symmetry::Axisymmetric, Symmetry::Planar] {
        for order in [Order::Linear, Order::Quadratic] {
            let body = body(symmetry, order, &["top", "right", "bottom", "left"]);
            assert!(body.jumps.is_empty());
            let u: Vec<f64> = state(&body, 0.7).iter().map(|u| 0.2 * u).collect();
            let f = forces(&body, &u);
            let size: f64 = f.iter().map(|f| f.abs()).sum();
            let sum = |c: usize| f.iter().skip(c).step_by(2).sum::<f64>();
            assert!(size > 1.0);
            assert!(sum(1).abs() < 1e-14 * size, "{symmetry:?} {order:?}: {}", sum(1));
            if symmetry == Symmetry::Planar {
                assert!(sum(0).abs() < 1e-14 * size, "{order:?}: {}", sum(0));
                // Nor a moment: quadratic nodes stand for quadratic positions, so that nodal forces have lever arms.
                let place = |n: usize, c: usize| body.nodes.points[n][c] + u[2 * n + c];
                let moment: f64 = (0..f.len() / 2).map(|n| place(n, 0) * f[2 * n + 1] - place(n, 1) * f[2 * n]).sum();
                if order == Order::Quadratic {
                    assert!(moment.abs() < 1e-14 * size, "{moment}");
                }
            }
        }
    }
}

#[test]
fn an_open_surface_bears_the_force_of_the_area_between_its_ends() {
    // Planar: p times the chord, turned by a right angle; axisymmetric: p pi (difference of squared radii) along the axis.
    for order in [Order::Linear, Order::Quadratic] {
        for symmetry in [Symmetry::Axisymmetric, Symmetry::Planar] {
            let body = body(symmetry, order, &["top"]);
            let u: Vec<f64> = state(&body, 0.9).iter().map(|u| 0.2 * u).collect();
            let f = forces(&body, &u);
            let corner = |at: [f64; 2]| {
                let n = body.nodes.points.iter().position(|p| (p[0] - at[0]).hypot(p[1] - at[1]) < 1e-12).unwrap();
                [at[0] + u[2 * n], at[1] + u[2 * n + 1]]
            };
            let (inner, outer) = (corner([0.7, 1.0]), corner([1.5, 1.0]));
            // Residual: inner less outer forces, so the pressure from above comes with a plus.
            let down: f64 = f.iter().skip(1).step_by(2).sum();
            let area = match symmetry {
                Symmetry::Axisymmetric => std::f64::consts::PI * (outer[0].powi(2) - inner[0].powi(2)),
                Symmetry::Planar => outer[0] - inner[0],
            };
            assert!((down / (LOAD * 3.0 * area) - 1.0).abs() < 1e-13, "{order:?} {symmetry:?}: {down}");
        }
    }
}
