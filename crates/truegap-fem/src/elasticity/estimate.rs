//! Local error estimate: on every triangle the out-of-balance forces of a solution are lifted to bubbles of degree
//! three and four, with tractions averaged between neighbours; products of lifted residuals estimate those of errors.
//!
//! **Source:** Bank & Weiser (1985) for the local problems; the product of primal and dual lifts is the dual-weighted
//! residual of Becker & Rannacher (2001). In the mixed formulation the lift has a pressure too. An estimate, not a
//! bound. Quadratic elements only.

use super::body::Body;
use super::element::{Tables, evaluate_at, evaluate_points, material};
use super::following::{EdgeShape, OnEdge, add_tangent_of, field_on, push, push_change, surface};
use super::kinematics::{R, Z, displacement_gradient, work};
use super::laws::{Law, Tensor};
use super::material::Formulation;
use super::point::{At, Visitor};
use super::quadrature_point::MappedQuadraturePoint;
use super::solver::Solver;
use crate::algebra::for_each_element;
use crate::mesh::NONE;
use crate::space::{ABOVE_QUADRATIC, bubbles_above_quadratic};
use crate::space::{EdgePoint, Element, Shape, edge_rule};
use nalgebra::{DMatrix, DVector};

/// A field over all unknowns whose error is wanted.
#[derive(Clone, Copy)]
pub(crate) enum FieldRef<'a> {
    /// The equilibrium itself, with its loads.
    Equilibrium,
    /// A solution of the linearised problem without inner loads.
    Dual(&'a [f64]),
    /// The dual field of the stored energy, whose inner load is the stress of the equilibrium.
    EnergyDual(&'a [f64]),
}

/// Displacement unknowns of a local problem.
const INNER: usize = 2 * ABOVE_QUADRATIC;

/// Contributions of every triangle to the energy products of the errors of pairs of fields.
pub(crate) fn estimate_pairs(solver: &Solver, fields: &[FieldRef], pairs: &[(usize, usize)]) -> Vec<Vec<f64>> {
    let local = Local {
        solver,
        body: solver.body(),
        tables: Tables::of_degree(8),
        pressure: edge_pressures(solver.body()),
        held: solver.held(),
        fields,
    };
    let mut out = vec![Vec::new(); pairs.len()];
    let products = |t: usize| {
        let lifted = local.lift(t);
        pairs.iter().map(|&(a, b)| lifted[a].1.dot(&lifted[b].0)).collect::<Vec<f64>>()
    };
    for_each_element(solver.body().dofs.elements(), products, |_, p| {
        out.iter_mut().zip(p).for_each(|(list, p)| list.push(p));
    });
    out
}

/// Dead pressure on every edge at load factor 1 (Pa).
fn edge_pressures(body: &Body) -> Vec<f64> {
    let mut out = vec![0.0; body.topology.edges.len()];
    for edge in body.pressures.iter().filter(|e| !e.follows) {
        out[body.topology.triangle_edges[edge.element][edge.side] as usize] += edge.pressure;
    }
    out
}

struct Local<'a> {
    solver: &'a Solver,
    body: &'a Body,
    tables: Tables,
    pressure: Vec<f64>,
    held: Vec<bool>,
    fields: &'a [FieldRef<'a>],
}

impl Local<'_> {
    /// For each field, the coefficients of the lifted residual and the residual itself.
    fn lift(&self, t: usize) -> Vec<(DVector<f64>, DVector<f64>)> {
        let mixed = material(self.body, t).formulation == Formulation::Mixed;
        let m = INNER + if mixed { 3 } else { 0 };
        let mut inside = Inside { local: self, t, matrix: vec![0.0; m * m], residuals: vec![vec![0.0; m]; self.fields.len()] };
        let (state, load) = (self.solver.state(), self.solver.load());
        evaluate_points(self.body, &self.tables, t, state, load, true, &mut inside);
        let Inside { mut matrix, mut residuals, .. } = inside;
        add_tangent_of(self.body, t, state, load, 8, bubbles_on, (m, &mut matrix));
        for k in 0..3 {
            self.add_edge(t, k, &mut residuals);
        }
        let mut matrix = DMatrix::from_fn(m, m, |i, j| matrix[i.min(j) * m + i.max(j)]);
        for (k, c) in (0..6).flat_map(|k| [(k, 0), (k, 1)]).filter(|&(k, c)| self.prescribed(t, k % 3, c)) {
            let i = 2 * k + c;
            let diagonal = matrix[(i, i)];
            matrix.row_mut(i).fill(0.0);
            matrix.column_mut(i).fill(0.0);
            matrix[(i, i)] = diagonal;
            residuals.iter_mut().for_each(|r| r[i] = 0.0);
        }
        let factor = matrix.lu();
        let solve = |r: Vec<f64>| {
            let r = DVector::from_vec(r);
            // Only a triangle without area has a singular local problem, and the mesh check excludes those.
            (factor.solve(&r).unwrap_or(DVector::zeros(m)), r)
        };
        residuals.into_iter().map(solve).collect()
    }

    fn prescribed(&self, t: usize, k: usize, component: usize) -> bool {
        self.held[2 * self.body.nodes.triangles[t][3 + k] as usize + component]
    }

    /// Adds the averaged tractions on the local edge `k`; only the bubbles of that edge are not zero there.
    fn add_edge(&self, t: usize, k: usize, residuals: &mut [Vec<f64>]) {
        let topology = &self.body.topology;
        let edge = topology.triangle_edges[t][k] as usize;
        let [a, b] = topology.edge_triangles[edge];
        let other = if a as usize == t { b } else { a };
        let element = self.body.nodes.element(t);
        for (s, w) in edge_rule(7) {
            let p = element.edge_point(k, s);
            let weight = w * p.speed * self.body.problem.symmetry.weight(p.at[0]);
            if weight == 0.0 {
                continue;
            }
            let reference = Element::edge_reference(k, s);
            let tractions = match other {
                NONE => self.outer(edge, (t, k, s), &p),
                other => {
                    let there = topology.triangle_edges[other as usize].iter().position(|&e| e as usize == edge).unwrap_or(0);
                    let here = self.tractions(t, reference, p.normal);
                    // The neighbour runs along the edge the other way.
                    let beyond = self.tractions(other as usize, Element::edge_reference(there, 1.0 - s), p.normal);
                    here.iter().zip(beyond).map(|(a, b)| [0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1])]).collect()
                }
            };
            let bubbles = bubbles_above_quadratic(reference);
            for (r, f) in residuals.iter_mut().zip(&tractions) {
                for i in [k, k + 3] {
                    r[2 * i] += weight * bubbles[i].0 * f[0];
                    r[2 * i + 1] += weight * bubbles[i].0 * f[1];
                }
            }
        }
    }

    /// Given tractions per undeformed area; of a dual field, what the load stiffness makes of it.
    fn outer(&self, edge: usize, (t, k, s): (usize, usize, f64), p: &EdgePoint) -> Vec<[f64; 2]> {
        let (symmetry, load) = (self.body.problem.symmetry, self.solver.load());
        let dead = -self.pressure[edge] * load;
        let following = self.body.following.get(&t).map_or(0.0, |sides| sides[k]) * load;
        let per_area = following / (p.speed * symmetry.weight(p.at[0]));
        let x = if following == 0.0 { OnEdge::default() } else { surface(self.body, t, k, s, self.solver.state()) };
        let loaded = |f: &FieldRef| match f {
            FieldRef::Equilibrium => {
                let moved = push(symmetry, x);
                [0, 1].map(|c| dead * p.normal[c] + per_area * moved[c])
            }
            _ if following == 0.0 => [0.0; 2],
            FieldRef::Dual(z) | FieldRef::EnergyDual(z) => {
                push_change(symmetry, x, field_on(self.body, t, k, s, z)).map(|f| per_area * f)
            }
        };
        self.fields.iter().map(loaded).collect()
    }

    fn tractions(&self, t: usize, reference: [f64; 2], normal: [f64; 2]) -> Vec<[f64; 2]> {
        let mut traction = Traction { local: self, t, normal, out: Vec::with_capacity(self.fields.len()) };
        evaluate_at(self.body, t, reference, self.solver.state(), self.solver.load(), true, &mut traction);
        traction.out
    }

    /// Nominal stress and volume gap of a field at a point.
    fn stress<L: Law>(&self, t: usize, field: FieldRef, at: &At<L>, s: &MappedQuadraturePoint) -> (Tensor, f64) {
        let (z, inner) = match field {
            FieldRef::Equilibrium => return (at.stress(), at.gap()),
            FieldRef::Dual(z) => (z, 0.0),
            FieldRef::EnergyDual(z) => (z, 1.0),
        };
        let of = self.body.dofs.of(t);
        let local: Vec<f64> = of.iter().map(|&d| z[d as usize]).collect();
        let (u, p) = local.split_at(2 * s.shapes.len());
        let h = displacement_gradient(self.body.problem.symmetry, s.at[0], s.shapes, u);
        let p: f64 = s.pressures.iter().zip(p).map(|(n, p)| n * p).sum();
        let (stress, gap) = (at.tangent(&h) + at.volume_slope() * p, at.volume_slope().dot(&h) - at.pressure_compliance() * p);
        // The slope of the energy is the work of the inner forces: on the bubbles too, where they are not in balance.
        (stress - at.stress() * inner, gap - at.gap() * inner)
    }
}

/// The bubbles of a side, with their slopes along it.
fn bubbles_on(side: usize, s: f64) -> Vec<EdgeShape> {
    let (bubbles, along) =
        (bubbles_above_quadratic(Element::edge_reference(side, s)), [[1.0, 0.0], [-1.0, 1.0], [0.0, -1.0]][side]);
    [side, side + 3].map(|i| (i, bubbles[i].0, bubbles[i].1[0] * along[0] + bubbles[i].1[1] * along[1])).to_vec()
}

/// Gathers the local matrix and the residuals inside a triangle.
struct Inside<'a> {
    local: &'a Local<'a>,
    t: usize,
    matrix: Vec<f64>,
    residuals: Vec<Vec<f64>>,
}

impl Visitor for Inside<'_> {
    fn visit<L: Law>(&mut self, at: &At<L>, s: &MappedQuadraturePoint) {
        let [a, b, c] = s.barycentric;
        let shapes = bubbles_above_quadratic([b, c]).map(|(value, slope)| Shape { value, gradient: s.map.gradient(slope) });
        let edges = [4.0 * a * b, 4.0 * b * c, 4.0 * c * a];
        let pressures: &[f64] = if s.pressures.is_empty() { &[] } else { &edges };
        let bubble = MappedQuadraturePoint { shapes: &shapes, pressures, ..*s };
        at.add_tangent(&bubble, &mut self.matrix);
        let problem = &self.local.body.problem;
        for (field, r) in self.local.fields.iter().zip(&mut self.residuals) {
            let (stress, gap) = self.local.stress(self.t, *field, at, s);
            let force = match (field, &problem.body_force) {
                (FieldRef::Equilibrium, Some(f)) => f(s.at).map(|f| f * self.local.solver.load()),
                _ => [0.0; 2],
            };
            for (i, shape) in shapes.iter().enumerate() {
                let inner = work(problem.symmetry, s.at[0], &stress, *shape);
                for c in [R, Z] {
                    r[2 * i + c] += s.weight * (force[c] * shape.value - inner[c]);
                }
            }
            for (q, n) in pressures.iter().enumerate() {
                r[INNER + q] -= s.weight * n * gap;
            }
        }
    }
}

/// Tractions of all fields at a point of an edge.
struct Traction<'a> {
    local: &'a Local<'a>,
    t: usize,
    normal: [f64; 2],
    out: Vec<[f64; 2]>,
}

impl Visitor for Traction<'_> {
    fn visit<L: Law>(&mut self, at: &At<L>, s: &MappedQuadraturePoint) {
        let n = self.normal;
        for field in self.local.fields {
            let (p, _) = self.local.stress(self.t, *field, at, s);
            self.out.push([p[(R, R)] * n[0] + p[(R, Z)] * n[1], p[(Z, R)] * n[0] + p[(Z, Z)] * n[1]]);
        }
    }
}
