//! Local error estimate: on every triangle the residual of a solution is lifted to bubbles of degree three and four (of degree two above
//! linear elements), with the flux through
//! its edges averaged between neighbours; the energy product of two lifted residuals estimates that of two errors.
//!
//! **Source:** Bank & Weiser (1985) for the local problems; the product of primal and dual lifts is the dual-weighted
//! residual of Becker & Rannacher (2001). An estimate, not a bound; its effectivity is measured in
//! `validation/verification`.

use super::flux::{flux, permittivity, slope_sum};
use super::form::dielectric;
use super::jumps::add_jumps;
use super::system::Solved;
use crate::algebra::for_each_element;
use crate::mesh::{NONE, Point};
use crate::space::{Bubble, bubbles_above_linear, bubbles_above_quadratic};
use crate::space::{Element, Order, P2, QuadraturePoint, Shape, edge_rule, triangle_rule};
use nalgebra::{SMatrix, SVector};

/// Two fields (indices into the list given) whose errors' energy product is wanted.
pub(super) type Pair = (usize, usize);

/// What drives a field besides the prescribed potentials: a functional at a point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct PointLoad {
    pub field: usize,
    pub triangle: usize,
    pub reference: [f64; 2],
    /// The functional is `weights . (value, d/dx, d/dy)` at the point.
    pub weights: [f64; 3],
}

/// Contributions of every triangle to the estimates a(error of one, error of the other), pair by pair.
///
/// `fields` are over all unknowns of `solved`; units of the result: F V² for potentials in V.
pub(super) fn estimate_pairs(solved: &Solved, fields: &[&[f64]], loads: &[PointLoad], pairs: &[Pair]) -> Vec<Vec<f64>> {
    match solved.order {
        Order::Quadratic => products(solved, fields, loads, pairs, bubbles_above_quadratic),
        Order::Linear => products(solved, fields, loads, pairs, bubbles_above_linear),
    }
}

fn products<const N: usize>(
    solved: &Solved,
    fields: &[&[f64]],
    loads: &[PointLoad],
    pairs: &[Pair],
    bubbles: Bubbles<N>,
) -> Vec<Vec<f64>> {
    let triangles = solved.mesh.triangles.len();
    // Enough for all but the highest terms of the quartic bubbles; the estimate does not need them exactly.
    let rules = Rules::new(6, bubbles);
    let open = open_edges(solved);
    let mut out = vec![Vec::with_capacity(triangles); pairs.len()];
    let local = |t: usize| {
        let lifted = Local { solved, rules: &rules, open: &open, t }.lift(fields, loads);
        pairs.iter().map(|&(a, b)| lifted[a].1.dot(&lifted[b].0)).collect::<Vec<f64>>()
    };
    for_each_element(triangles, local, |_, products| {
        out.iter_mut().zip(products).for_each(|(list, p)| list.push(p));
    });
    for (list, &pair) in out.iter_mut().zip(pairs) {
        add_jumps(solved, fields, pair, list);
    }
    out
}

/// For edges on the open boundary, the infinite element behind them.
fn open_edges(solved: &Solved) -> Vec<u32> {
    let mut behind = vec![NONE; solved.topology.edges.len()];
    if let Some(exterior) = &solved.exterior {
        for (k, e) in exterior.edges.iter().enumerate() {
            if let Some(edge) = solved.topology.edge(e[0], e[1]) {
                behind[edge] = k as u32;
            }
        }
    }
    behind
}

/// Values and slopes of all bubbles at a reference point: those of the three edges first, once or twice, then the inner ones.
type Bubbles<const N: usize> = fn([f64; 2]) -> [Bubble; N];
type Lift<const N: usize> = SVector<f64, N>;
type Stiffness<const N: usize> = SMatrix<f64, N, N>;
type Tabulated<const N: usize> = (QuadraturePoint, [[f64; 2]; 6], [Bubble; N]);

/// Bubbles that live on edges.
const ON_EDGES: usize = 6;

struct Rules<const N: usize> {
    bubbles: Bubbles<N>,
    inside: Vec<Tabulated<N>>,
    edge: Vec<(f64, f64)>,
}

impl<const N: usize> Rules<N> {
    fn new(degree: usize, bubbles: Bubbles<N>) -> Rules<N> {
        let inside = triangle_rule(degree).into_iter().map(|q| (q, P2::at(q.at).1, bubbles(q.at))).collect();
        Rules { bubbles, inside, edge: edge_rule(6) }
    }
}

struct Local<'a, const N: usize> {
    solved: &'a Solved<'a>,
    rules: &'a Rules<N>,
    open: &'a [u32],
    t: usize,
}

impl<const N: usize> Local<'_, N> {
    /// For each field, the coefficients of the lifted residual and the residual itself.
    fn lift(&self, fields: &[&[f64]], loads: &[PointLoad]) -> Vec<(Lift<N>, Lift<N>)> {
        let element = self.solved.nodes.element(self.t);
        let mut residuals = vec![Lift::zeros(); fields.len()];
        let mut stiffness = self.interior(&element, fields, &mut residuals);
        for k in 0..3 {
            self.edge(&element, k, fields, &mut residuals);
        }
        for load in loads.iter().filter(|l| l.triangle == self.t) {
            let map = element.map_at(load.reference);
            for (i, (value, slope)) in (self.rules.bubbles)(load.reference).into_iter().enumerate() {
                let g = map.gradient(slope);
                residuals[load.field][i] += load.weights[0] * value + load.weights[1] * g[0] + load.weights[2] * g[1];
            }
        }
        for k in (0..N.min(ON_EDGES)).filter(|&k| self.prescribed(k % 3)) {
            stiffness.row_mut(k).fill(0.0);
            stiffness.column_mut(k).fill(0.0);
            stiffness[(k, k)] = 1.0;
            residuals.iter_mut().for_each(|r| r[k] = 0.0);
        }
        let Some(factor) = stiffness.cholesky() else {
            // Only a triangle without area has a singular bubble matrix, and the mesh check excludes those.
            return residuals.iter().map(|r| (Lift::zeros(), *r)).collect();
        };
        residuals.into_iter().map(|r| (factor.solve(&r), r)).collect()
    }

    fn interior(&self, element: &Element, fields: &[&[f64]], residuals: &mut [Lift<N>]) -> Stiffness<N> {
        let permittivity = permittivity(self.solved, self.t);
        let symmetry = self.solved.problem.symmetry;
        let mut stiffness = Stiffness::zeros();
        for (q, slopes, bubbles) in &self.rules.inside {
            let map = element.map_at(q.at);
            let weight = q.weight * map.jacobian * symmetry.weight(map.at[0]);
            let shapes = bubbles.map(|(value, slope)| Shape { value, gradient: map.gradient(slope) });
            // The factorisation reads the lower triangle only.
            for i in 0..N {
                for j in 0..=i {
                    stiffness[(i, j)] += weight * dielectric(permittivity, shapes[i], shapes[j]);
                }
            }
            for (u, r) in fields.iter().zip(residuals.iter_mut()) {
                let g = slope_sum(self.solved, self.t, slopes, u);
                let trial = Shape { value: 0.0, gradient: map.gradient(g) };
                for i in 0..N {
                    r[i] -= weight * dielectric(permittivity, shapes[i], trial);
                }
            }
        }
        stiffness
    }

    fn prescribed(&self, k: usize) -> bool {
        let middle = self.solved.nodes.triangles[self.t][3 + k];
        self.solved.owner[middle as usize] != u16::MAX
    }

    /// Adds the averaged flux through the local edge `k`; only the bubbles of that edge are not zero there.
    fn edge(&self, element: &Element, k: usize, fields: &[&[f64]], residuals: &mut [Lift<N>]) {
        if self.prescribed(k) {
            return;
        }
        let edge = self.solved.topology.triangle_edges[self.t][k] as usize;
        let [a, b] = self.solved.topology.edge_triangles[edge];
        let other = if a as usize == self.t { b } else { a };
        if other == NONE && self.open[edge] == NONE {
            return;
        }
        for &(t, w) in &self.rules.edge {
            let p = element.edge_point(k, t);
            let weight = w * p.speed * self.solved.problem.symmetry.weight(p.at[0]);
            if weight == 0.0 {
                continue;
            }
            let bubbles = (self.rules.bubbles)(Element::edge_reference(k, t));
            for (u, r) in fields.iter().zip(residuals.iter_mut()) {
                let here = flux(self.solved, self.t, element, Element::edge_reference(k, t), p.normal, u);
                let there = match other {
                    NONE => self.flux_behind(self.open[edge] as usize, t, p.normal, u),
                    other => self.flux_beside(other as usize, edge, t, p.normal, u),
                };
                for i in (k..N.min(ON_EDGES)).step_by(3) {
                    r[i] += weight * bubbles[i].0 * 0.5 * (here + there);
                }
            }
        }
    }

    fn flux_beside(&self, other: usize, edge: usize, t: f64, normal: Point, u: &[f64]) -> f64 {
        let k = self.solved.topology.triangle_edges[other].iter().position(|&e| e as usize == edge).unwrap_or(0);
        // The neighbour runs along the edge the other way.
        flux(self.solved, other, &self.solved.nodes.element(other), Element::edge_reference(k, 1.0 - t), normal, u)
    }

    fn flux_behind(&self, k: usize, t: f64, normal: Point, u: &[f64]) -> f64 {
        let Some(infinite) = self.solved.infinite(k) else { return 0.0 };
        let dofs = self.solved.dofs.of(self.solved.mesh.triangles.len() + k);
        let values: Vec<f64> = dofs.iter().map(|&d| u[d as usize]).collect();
        let g = infinite.edge_gradient(t, &values);
        infinite.permittivity * (g[0] * normal[0] + g[1] * normal[1])
    }
}
