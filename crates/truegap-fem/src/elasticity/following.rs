//! Pressure on the deformed surface: its forces, and how they change with the displacement (the load stiffness).
//!
//! On an edge `x(s)`, `s` from 0 to 1 with the body to the left, `w(r)` = 2 pi r (planar: 1):
//!
//! $$ f = -p \int N\, w(r)\, (z', -r')\, ds $$
//!
//! The change of `f` with the displacement is symmetric but for `p w [N_i N_j]` at both ends of every edge. Between edges
//! of equal pressure these terms cancel, so that the part that is not symmetric sits at single nodes (`ends`). The
//! element matrices here are the symmetric part.
//!
//! **Source:** Nanson's formula; for the symmetric part and its ends see Simo, Taylor & Wriggers, Commun. Appl. Numer.
//! Methods 7 (1991) 513. **Accuracy:** the tangent is that of the forces to 1e-9, `tests.rs`.

use super::body::Body;
use crate::space::{Order, edge_rule};
use crate::symmetry::Symmetry;

/// Degree that integrates shapes of degree 2 on surfaces of degree 2 exactly.
const DEGREE: usize = 6;

/// A field on an edge: value and slope by the parameter of the edge.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct OnEdge {
    pub value: [f64; 2],
    pub slope: [f64; 2],
}

/// A shape on an edge: local number of its node, value, slope by the parameter.
pub(crate) type EdgeShape = (usize, f64, f64);

/// Force of a pressure of 1 Pa per unit of the parameter, where the surface is at `x`.
pub(crate) fn push(symmetry: Symmetry, x: OnEdge) -> [f64; 2] {
    let w = symmetry.weight(x.value[0]);
    [-w * x.slope[1], w * x.slope[0]]
}

/// Its change where the surface moves by `u`.
pub(crate) fn push_change(symmetry: Symmetry, x: OnEdge, u: OnEdge) -> [f64; 2] {
    let (w, dw) = (symmetry.weight(x.value[0]), symmetry.weight_slope() * u.value[0]);
    [-dw * x.slope[1] - w * u.slope[1], dw * x.slope[0] + w * u.slope[0]]
}

/// Shapes of a side of an element that do not vanish on it.
fn shapes_on(body: &Body, side: usize, s: f64) -> Vec<EdgeShape> {
    match body.problem.order {
        Order::Linear => vec![(side, 1.0 - s, -1.0), ((side + 1) % 3, s, 1.0)],
        Order::Quadratic => {
            let (value, slope) = crate::space::edge_shape(s);
            [side, (side + 1) % 3, side + 3].into_iter().enumerate().map(|(i, n)| (n, value[i], slope[i])).collect()
        }
    }
}

/// A field of the whole body on a side of an element.
pub(crate) fn field_on(body: &Body, e: usize, side: usize, s: f64, field: &[f64]) -> OnEdge {
    let of = body.dofs.of(e);
    let mut out = OnEdge::default();
    for (n, value, slope) in shapes_on(body, side, s) {
        for c in 0..2 {
            let u = field[of[2 * n + c] as usize];
            out.value[c] += value * u;
            out.slope[c] += slope * u;
        }
    }
    out
}

/// The deformed surface on a side of an element.
pub(crate) fn surface(body: &Body, e: usize, side: usize, s: f64, state: &[f64]) -> OnEdge {
    let q = body.nodes.element(e).edge_point(side, s);
    let u = field_on(body, e, side, s, state);
    let tangent = [-q.normal[1] * q.speed, q.normal[0] * q.speed];
    OnEdge { value: [0, 1].map(|c| q.at[c] + u.value[c]), slope: [0, 1].map(|c| tangent[c] + u.slope[c]) }
}

/// Adds what following pressures take from the out-of-balance forces of an element.
pub(crate) fn add_residual(body: &Body, e: usize, state: &[f64], load: f64, out: &mut [f64]) {
    for_each_side(body, e, |side, pressure| {
        for (s, w) in edge_rule(DEGREE) {
            let f = push(body.problem.symmetry, surface(body, e, side, s, state));
            for (n, value, _) in shapes_on(body, side, s) {
                (0..2).for_each(|c| out[2 * n + c] -= load * pressure * w * value * f[c]);
            }
        }
    });
}

/// Adds the symmetric part of the load stiffness of an element (lower triangle, column by column).
pub(crate) fn add_tangent(body: &Body, e: usize, state: &[f64], load: f64, out: &mut [f64]) {
    let m = body.dofs.of(e).len();
    add_tangent_of(body, e, state, load, DEGREE, |side, s| shapes_on(body, side, s), (m, out));
}

/// The same for any shapes on the sides, as a matrix of `m` columns.
pub(crate) fn add_tangent_of(
    body: &Body,
    e: usize,
    state: &[f64],
    load: f64,
    degree: usize,
    shapes: impl Fn(usize, f64) -> Vec<EdgeShape>,
    (m, out): (usize, &mut [f64]),
) {
    for_each_side(body, e, |side, pressure| {
        for (s, w) in edge_rule(degree) {
            let x = surface(body, e, side, s, state);
            let shapes = shapes(side, s);
            add_symmetric(body.problem.symmetry, x, &shapes, load * pressure * w, (m, out));
        }
    });
}

fn add_symmetric(symmetry: Symmetry, x: OnEdge, shapes: &[EdgeShape], weight: f64, (m, out): (usize, &mut [f64])) {
    let entry = |i: &EdgeShape, c: usize, j: &EdgeShape, d: usize| {
        let mut u = OnEdge::default();
        (u.value[d], u.slope[d]) = (j.1, j.2);
        -i.1 * push_change(symmetry, x, u)[c]
    };
    for i in shapes {
        for j in shapes {
            for (c, d) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
                let (row, column) = (2 * i.0 + c, 2 * j.0 + d);
                if row >= column {
                    out[column * m + row] += 0.5 * weight * (entry(i, c, j, d) + entry(j, d, i, c));
                }
            }
        }
    }
}

fn for_each_side(body: &Body, e: usize, mut visit: impl FnMut(usize, f64)) {
    let Some(pressures) = body.following.get(&e) else { return };
    pressures.iter().enumerate().filter(|(_, p)| **p != 0.0).for_each(|(side, p)| visit(side, *p));
}

#[cfg(test)]
mod tests;
