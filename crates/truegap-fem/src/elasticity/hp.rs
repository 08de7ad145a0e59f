//! Linear elasticity by the hp version: forces of supports and stored energy of bodies that are driven by displacements.

use super::body::Body;
use super::goals::{Goal, Quantity};
use super::material::LawKind;
use super::problem::{Component, Condition, Place, Problem};
use crate::error::FemError;
use crate::hp::{
    AffineElement, Edge, Functional, Gram, HpOutcome, Level, Local, Physics, Reference, Side, Space, Williams, gram, refine,
};
use crate::mesh::{Mesh, NONE, Topology};
use crate::space::{ElementDofs, Order};
use crate::symmetry::Symmetry;
use nalgebra::DMatrix;

/// Poisson's ratio up to which displacements of high degree alone take a nearly incompressible body.
const LARGEST_POISSON: f64 = 0.499;

/// Solves by the hp version to a relative error of `target` in every output.
///
/// For energies and reactions of bodies with straight edges, linear laws and Poisson's ratios up to 0.499, driven by displacements of
/// boundaries alone. `None` where something else is asked for, or the target is not reached: [`super::solve_goals_adaptive`] takes all.
///
/// # Errors
/// Those of [`super::solve_goals_adaptive`] for problems that have no solution.
pub fn solve_hp(problem: &Problem, quantities: &[Quantity], target: f64) -> Result<Option<HpOutcome>, FemError> {
    let Some(physics) = Elasticity::of(problem, quantities) else { return Ok(None) };
    Body::new(problem.clone())?;
    let Some(fields) = physics.fields(&problem.mesh) else { return Ok(None) };
    refine(&Elasticity { fields, ..physics }, &problem.mesh, target)
}

/// Values of a component on a boundary (m).
#[derive(Debug, Clone, Copy, PartialEq)]
struct Support {
    boundary: u16,
    component: usize,
    value: f64,
}

struct Elasticity<'a> {
    problem: &'a Problem,
    quantities: &'a [Quantity],
    poisson: Vec<f64>,
    /// What is held, with the values of the equilibrium.
    supports: Vec<Support>,
    /// The equilibrium, then one field a reaction: what is moved by one there.
    fields: Vec<Vec<Support>>,
}

impl<'a> Elasticity<'a> {
    /// The problem, where it is of this kind.
    fn of(problem: &'a Problem, quantities: &'a [Quantity]) -> Option<Elasticity<'a>> {
        let linear =
            problem.materials.iter().all(|m| m.law == LawKind::Linear && m.poisson <= LARGEST_POISSON && m.expansion == 0.0);
        if !linear || !problem.mesh.curved_edges.is_empty() || problem.body_force.is_some() || problem.order != Order::Quadratic {
            return None;
        }
        let support = |c: &Condition| match c {
            Condition::Displacement { place: Place::Boundary(name), component, value } => {
                Some(Support { boundary: problem.mesh.boundary(name).ok()?, component: component.index(), value: *value })
            }
            _ => None,
        };
        let supports = problem.conditions.iter().map(support).collect::<Option<Vec<_>>>()?;
        let poisson = problem.materials.iter().map(|m| m.poisson).collect();
        Some(Elasticity { problem, quantities, poisson, supports, fields: Vec::new() })
    }

    /// The fields whose products the outputs are, or `None` where one of them would have infinite energy.
    fn fields(&self, mesh: &Mesh) -> Option<Vec<Vec<Support>>> {
        let mut out = vec![self.supports.clone()];
        for q in self.quantities {
            match &q.goal {
                Goal::Energy => {}
                Goal::Reaction { boundary, component } => out.push(self.moved(mesh, boundary, *component)?),
                _ => return None,
            }
        }
        Some(out)
    }

    /// Supports with one boundary moved by one; `None` where it is not held, or where the next support would be torn from it.
    fn moved(&self, mesh: &Mesh, boundary: &str, component: Component) -> Option<Vec<Support>> {
        let (moved, k) = (mesh.boundary(boundary).ok()?, component.index());
        let mut nodes: Vec<u32> = mesh.edges_of(moved).flatten().collect();
        nodes.sort_unstable();
        let touches = |b: u16| mesh.edges_of(b).flatten().any(|n| nodes.binary_search(&n).is_ok());
        let torn = |s: &Support| s.component == k && s.boundary != moved && touches(s.boundary);
        let on_axis =
            k == 0 && self.problem.symmetry == Symmetry::Axisymmetric && nodes.iter().any(|&n| mesh.points[n as usize][0] == 0.0);
        let held = self.supports.iter().any(|s| s.boundary == moved && s.component == k);
        if !held || on_axis || self.supports.iter().any(torn) {
            return None;
        }
        let value = |s: &Support| f64::from(u8::from(s.boundary == moved && s.component == k));
        Some(self.supports.iter().map(|s| Support { value: value(s), ..*s }).collect())
    }

    /// Values of all unknowns under supports; marks those that are held.
    fn prescribed(&self, space: &Space, supports: &[Support], fixed: &mut [bool]) -> Vec<f64> {
        let mut out = vec![0.0; fixed.len()];
        for s in supports {
            for edge in space.mesh.edges_of(s.boundary) {
                space.on_edge(edge).iter().for_each(|(u, _)| fixed[2 * *u as usize + s.component] = true);
                edge.iter().for_each(|&n| out[2 * n as usize + s.component] = s.value);
            }
        }
        out
    }
}

impl Physics for Elasticity<'_> {
    fn edges(&self, mesh: &Mesh, topology: &Topology) -> Vec<Option<Edge>> {
        let mut held = vec![[false; 2]; topology.edges.len()];
        for s in &self.supports {
            for [a, b] in mesh.edges_of(s.boundary) {
                topology.edge(a, b).into_iter().for_each(|e| held[e][s.component] = true);
            }
        }
        let on_axis = on_axis(self.problem.symmetry, mesh, topology);
        let kind = |e: usize| {
            let [a, b] = topology.edges[e].map(|n| mesh.points[n as usize]);
            match held[e] {
                [true, true] => Some(Edge::Held),
                [false, false] => on_axis[e].then_some(Edge::Mirror),
                [true, false] if a[0] == b[0] => Some(Edge::Mirror),
                [false, true] if a[1] == b[1] => Some(Edge::Mirror),
                _ => Some(Edge::Other),
            }
        };
        (0..topology.edges.len()).map(kind).collect()
    }

    fn side(&self) -> impl Side {
        Williams(&self.poisson)
    }

    fn solve(&self, level: &Level) -> Result<Gram, FemError> {
        let space = Space::new(level.mesh, level.topology, level.degrees);
        let symmetry = self.problem.symmetry;
        let reference = Reference::new(space.degree, symmetry == Symmetry::Axisymmetric);
        let locals: Vec<Vec<Local>> = (0..level.mesh.triangles.len()).map(|t| space.of(t)).collect();
        let mut dofs = ElementDofs::empty(2 * space.count);
        locals.iter().for_each(|l| dofs.push(&l.iter().flat_map(|l| [2 * l.unknown, 2 * l.unknown + 1]).collect::<Vec<_>>()));
        let mut fixed = vec![false; dofs.count];
        for (e, _) in on_axis(symmetry, level.mesh, level.topology).iter().enumerate().filter(|(_, on)| **on) {
            space.on_edge(level.topology.edges[e]).iter().for_each(|(u, _)| fixed[2 * *u as usize] = true);
        }
        if symmetry == Symmetry::Axisymmetric {
            (0..level.mesh.points.len()).filter(|&n| level.mesh.points[n][0] == 0.0).for_each(|n| fixed[2 * n] = true);
        }
        let prescribed: Vec<Vec<f64>> = self.fields.iter().map(|f| self.prescribed(&space, f, &mut fixed)).collect();
        let element = |t: usize| {
            let material = &self.problem.materials[level.mesh.triangle_regions[t] as usize];
            let lame = material.lame();
            stiffness(&reference.element(level.mesh.corners(t), symmetry), &locals[t], [lame.lambda(), lame.mu])
        };
        Ok(gram(&dofs, &fixed, &prescribed, element)?)
    }

    fn functionals(&self, products: &DMatrix<f64>) -> Vec<Functional> {
        let body = self.problem.symmetry == Symmetry::Axisymmetric;
        let weights = |field: usize| (0..self.fields.len()).map(|f| f64::from(u8::from(f == field))).collect::<Vec<_>>();
        let mut field = 0;
        let one = |q: &Quantity| {
            let (unit, right, factor) = match q.goal {
                Goal::Reaction { .. } => {
                    field += 1;
                    (if body { "N" } else { "N/m" }, field, 1.0)
                }
                _ => (if body { "J" } else { "J/m" }, 0, 0.5),
            };
            let value = factor * products[(0, right)];
            Functional { name: q.name.clone(), value, unit, scale: value.abs(), left: weights(0), right: weights(right), factor }
        };
        self.quantities.iter().map(one).collect()
    }
}

/// Edges on the axis of an axisymmetric body.
fn on_axis(symmetry: Symmetry, mesh: &Mesh, topology: &Topology) -> Vec<bool> {
    let at = |n: &u32| mesh.points[*n as usize][0] == 0.0;
    let outer = topology.edges.iter().zip(&topology.edge_triangles);
    outer.map(|(e, t)| symmetry == Symmetry::Axisymmetric && t[1] == NONE && e.iter().all(at)).collect()
}

/// Matrix of a straight triangle, full, its unknowns shape by shape.
///
/// `a(u, v) = int w [lambda div u div v + 2 mu e(u) : e(v)]` with `e_tt = u_r / r` in axisymmetric bodies.
fn stiffness(triangle: &AffineElement, locals: &[Local], [lambda, mu]: [f64; 2]) -> Vec<f64> {
    let m = 2 * locals.len();
    let numbers: Vec<usize> = locals.iter().map(|l| l.shape as usize).collect();
    let divided = triangle.divided(&numbers);
    let mut out = vec![0.0; m * m];
    for (j, v) in locals.iter().enumerate() {
        for (i, u) in locals.iter().enumerate().skip(j) {
            let s = triangle.slopes(numbers[i], numbers[j]);
            let (ij, ji) = (triangle.mixed(numbers[i], numbers[j]), triangle.mixed(numbers[j], numbers[i]));
            let hoop = divided.get(i * locals.len() + j).copied().unwrap_or(0.0);
            let whole = lambda + 2.0 * mu;
            let block = [
                [whole * (s[0][0] + hoop) + mu * s[1][1] + lambda * (ij[0] + ji[0]), lambda * (s[0][1] + ji[1]) + mu * s[1][0]],
                [lambda * (s[1][0] + ij[1]) + mu * s[0][1], whole * s[1][1] + mu * s[0][0]],
            ];
            for (a, row) in block.iter().enumerate() {
                for (b, k) in row.iter().enumerate() {
                    let k = k * u.sign * v.sign;
                    (out[(2 * j + b) * m + 2 * i + a], out[(2 * i + a) * m + 2 * j + b]) = (k, k);
                }
            }
        }
    }
    out
}
