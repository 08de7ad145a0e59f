//! Linear elasticity by the hp version: forces of supports and stored energy of bodies that are driven by displacements.

use super::body::Body;
use super::goals::{Goal, Quantity};
use super::material::LawKind;
use super::problem::{Component, Condition, Place, Problem, Temperature};
use crate::error::FemError;
use crate::hp::{
    AffineElement, Edge, Functional, Gram, HpError, HpOutcome, Level, Local, Physics, Reference, Side, Space, Williams,
    check_straight, gram, refine,
};
use crate::mesh::{Mesh, NONE, Topology};
use crate::space::ElementDofs;
use crate::symmetry::Symmetry;
use nalgebra::DMatrix;

/// Poisson's ratio up to which displacements of high degree alone take a nearly incompressible body.
const LARGEST_POISSON: f64 = 0.499;

/// Solves by the hp version to a relative error of `target` in every output.
///
/// For energies and reactions of bodies with straight edges, linear laws and Poisson's ratios up to 0.499, driven by displacements of
/// boundaries alone. The formulation of the materials and the order of the problem are those of the other method.
///
/// # Errors
/// [`HpError`], before anything is solved, where something else is asked for, and after the last space where the target is not reached:
/// [`super::solve_goals_adaptive`] takes all. Those of [`super::solve_goals_adaptive`] for problems that have no solution.
pub fn solve_hp(problem: &Problem, quantities: &[Quantity], target: f64) -> Result<HpOutcome, FemError> {
    check_materials(problem)?;
    check_straight(&problem.mesh)?;
    let supports = supports(problem)?;
    Body::new(problem.clone())?;
    let poisson = problem.materials.iter().map(|m| m.poisson).collect();
    let physics = Elasticity { problem, quantities, poisson, supports, fields: Vec::new() };
    let fields = physics.fields(&problem.mesh)?;
    refine(&Elasticity { fields, ..physics }, &problem.mesh, target)
}

/// Refuses what is neither linear nor compressible nor cold.
fn check_materials(problem: &Problem) -> Result<(), HpError> {
    let cold = matches!(problem.temperature, Temperature::Linear { base: 0.0, gradient: [0.0, 0.0] });
    for (m, region) in problem.materials.iter().zip(&problem.mesh.region_names) {
        let region = region.clone();
        if m.law != LawKind::Linear {
            return Err(HpError::Law { region });
        }
        if m.poisson > LARGEST_POISSON {
            return Err(HpError::Poisson { region, poisson: m.poisson, most: LARGEST_POISSON });
        }
        if m.expansion != 0.0 && !cold {
            return Err(HpError::Expansion { region });
        }
    }
    Ok(())
}

/// Displacements of boundaries, and a refusal of any other condition.
fn supports(problem: &Problem) -> Result<Vec<Support>, FemError> {
    let load = |place: String, load| FemError::from(HpError::Load { place, load });
    if problem.body_force.is_some() {
        return Err(load("the body".into(), "a force per volume"));
    }
    let one = |c: &Condition| match c {
        Condition::Displacement { place: Place::Boundary(name), component, value } => {
            Ok(Support { boundary: problem.mesh.boundary(name)?, component: component.index(), value: *value })
        }
        Condition::Displacement { place: Place::Point([a, b]), .. } => Err(load(format!("the point ({a}, {b}) m"), "a pin")),
        Condition::Pressure { boundary, .. } => Err(load(format!("boundary `{boundary}`"), "a pressure")),
        Condition::Obstacle { boundary, .. } => Err(load(format!("boundary `{boundary}`"), "a plate")),
    };
    problem.conditions.iter().map(one).collect()
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

impl Elasticity<'_> {
    /// The fields whose products the outputs are.
    fn fields(&self, mesh: &Mesh) -> Result<Vec<Vec<Support>>, FemError> {
        let mut out = vec![self.supports.clone()];
        for q in self.quantities {
            match &q.goal {
                Goal::Energy => {}
                Goal::Reaction { boundary, component } => out.push(self.moved(mesh, &q.name, boundary, *component)?),
                _ => return Err(HpError::Output { output: q.name.clone(), integral: "reaction" }.into()),
            }
        }
        Ok(out)
    }

    /// Supports with one boundary moved by one; refused where it is not held, or where that would have infinite energy.
    fn moved(&self, mesh: &Mesh, output: &str, boundary: &str, component: Component) -> Result<Vec<Support>, FemError> {
        let (moved, k) = (mesh.boundary(boundary)?, component.index());
        let refused =
            |reason: &str| HpError::Reaction { output: output.into(), boundary: boundary.into(), reason: reason.into() };
        let mut nodes: Vec<u32> = mesh.edges_of(moved).flatten().collect();
        nodes.sort_unstable();
        let touches = |b: u16| mesh.edges_of(b).flatten().any(|n| nodes.binary_search(&n).is_ok());
        let torn = |s: &&Support| s.component == k && s.boundary != moved && touches(s.boundary);
        let on_axis =
            k == 0 && self.problem.symmetry == Symmetry::Axisymmetric && nodes.iter().any(|&n| mesh.points[n as usize][0] == 0.0);
        if !self.supports.iter().any(|s| s.boundary == moved && s.component == k) {
            return Err(refused("no displacement in this component is given on it").into());
        }
        if on_axis {
            return Err(refused("it meets the axis, from which this component would tear it").into());
        }
        if let Some(other) = self.supports.iter().find(torn) {
            let name = &mesh.boundary_names[other.boundary as usize];
            return Err(refused(&format!("it touches boundary `{name}`, which is held in the same component")).into());
        }
        let value = |s: &Support| f64::from(u8::from(s.boundary == moved && s.component == k));
        Ok(self.supports.iter().map(|s| Support { value: value(s), ..*s }).collect())
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
