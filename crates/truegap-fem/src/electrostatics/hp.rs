//! Electrostatics by the hp version: outputs that are energy products of the conductors' fields.

use super::error::ElectrostaticsError;
use super::exterior::Exterior;
use super::floating::check_held;
use super::goals::{Goal, Quantity, charges};
use super::infinite_hp::InfiniteEdges;
use super::problem::Problem;
use super::unknowns::permittivities;
use crate::error::FemError;
use crate::hp::{
    Edge, Functional, Gram, HpError, HpOutcome, Laplace, Level, Physics, Reference, Side, Space, check_straight, gram, refine,
};
use crate::mesh::{Mesh, Topology};
use crate::space::ElementDofs;
use crate::symmetry::Symmetry;
use nalgebra::DMatrix;

/// Solves by the hp version to a relative error of `target` in every output.
///
/// For capacitances, capacitance matrices and energies on meshes with straight edges, of conductors that touch neither one another nor
/// the open boundary.
///
/// # Errors
/// [`HpError`], before anything is solved, where something else is asked for, and after the last space where the target is not reached:
/// [`super::solve_adaptive`] takes all. Those of [`super::solve_adaptive`] for problems that have no solution.
pub fn solve_hp(problem: &Problem, quantities: &[Quantity], mesh: &Mesh, target: f64) -> Result<HpOutcome, FemError> {
    let n = problem.conductors.len();
    if n == 0 {
        return Err(ElectrostaticsError::NoConductor.into());
    }
    if let Some(c) = problem.conductors.iter().find(|c| !c.potential.is_finite()) {
        return Err(ElectrostaticsError::BadPotential { boundary: c.boundary.clone(), potential: c.potential }.into());
    }
    if let Some(q) = quantities.iter().find(|q| matches!(q.goal, Goal::Potential { .. } | Goal::Field { .. })) {
        return Err(HpError::Output { output: q.name.clone(), integral: "capacitance" }.into());
    }
    check_straight(mesh)?;
    if problem.symmetry == Symmetry::Axisymmetric {
        mesh.check_axis()?;
    }
    let of = |names: Vec<&String>| names.into_iter().map(|name| mesh.boundary(name)).collect::<Result<Vec<u16>, _>>();
    let physics = Electrostatics {
        problem,
        quantities,
        permittivity: permittivities(problem, mesh)?,
        held: of(problem.conductors.iter().map(|c| &c.boundary).collect())?,
        open: of(problem.open.iter().collect())?,
    };
    check_held(problem, mesh)?;
    physics.check_apart(mesh)?;
    charges(problem, quantities, &vec![vec![1.0; n]; n])?; // names of boundaries
    refine(&physics, mesh, target)
}

struct Electrostatics<'a> {
    problem: &'a Problem,
    quantities: &'a [Quantity],
    permittivity: Vec<f64>,
    /// Boundary of every conductor.
    held: Vec<u16>,
    /// Open boundaries.
    open: Vec<u16>,
}

impl Electrostatics<'_> {
    /// Refuses conductors that touch one another or the open boundary.
    fn check_apart(&self, mesh: &Mesh) -> Result<(), HpError> {
        let mut owner: Vec<Option<u16>> = vec![None; mesh.points.len()];
        let name = |b: u16| mesh.boundary_names[b as usize].clone();
        for &b in self.held.iter().chain(&self.open) {
            let other = |a: u16| a != b && !(self.open.contains(&a) && self.open.contains(&b));
            for node in mesh.edges_of(b).flatten().map(|n| n as usize) {
                if let Some(a) = owner[node].replace(b).filter(|&a| other(a)) {
                    return Err(HpError::Touching { a: name(a), b: name(b), at: mesh.points[node] });
                }
            }
        }
        Ok(())
    }

    /// Potential fields of all conductors, each at 1 V with the others at 0 V, and which unknowns they fix.
    fn prescribed(&self, space: &Space, count: usize) -> (Vec<bool>, Vec<Vec<f64>>) {
        let mut fixed = vec![false; count];
        let units = self.held.iter().map(|&boundary| {
            let mut unit = vec![0.0; count];
            for edge in space.mesh.edges_of(boundary) {
                space.on_edge(edge).iter().for_each(|(u, _)| fixed[*u as usize] = true);
                edge.iter().for_each(|&n| unit[n as usize] = 1.0);
            }
            unit
        });
        let units = units.collect();
        (fixed, units)
    }
}

impl Physics for Electrostatics<'_> {
    fn edges(&self, mesh: &Mesh, topology: &Topology) -> Vec<Option<Edge>> {
        let mut out = vec![None; topology.edges.len()];
        for e in &mesh.boundary_edges {
            let Some(edge) = topology.edge(e.nodes[0], e.nodes[1]) else { continue };
            if self.held.contains(&e.boundary) {
                out[edge] = Some(Edge::Held);
            } else if self.open.contains(&e.boundary) {
                out[edge] = Some(Edge::Continued);
            }
        }
        out
    }

    fn side(&self) -> impl Side {
        Laplace(&self.permittivity)
    }

    fn solve(&self, level: &Level) -> Result<Gram, FemError> {
        let space = Space::new(level.mesh, level.topology, level.degrees);
        let reference = Reference::new(space.degree, false);
        let exterior = Exterior::new(level.mesh, level.topology, self.problem.symmetry, &self.open)?;
        let mut dofs = ElementDofs::empty(space.count);
        let locals: Vec<_> = (0..level.mesh.triangles.len()).map(|t| space.of(t)).collect();
        locals.iter().for_each(|l| dofs.push(&l.iter().map(|l| l.unknown).collect::<Vec<_>>()));
        let infinite = exterior.as_ref().map(|e| InfiniteEdges::new(e, &space, self.problem.symmetry, &self.permittivity));
        infinite.iter().for_each(|i| i.number(&mut dofs));
        let (mut fixed, units) = self.prescribed(&space, dofs.count);
        if infinite.is_some() && self.problem.symmetry == Symmetry::Axisymmetric {
            // in three dimensions the potential vanishes at infinity
            fixed[dofs.count - 1] = true;
        }
        let element = |e: usize| {
            let Some(local) = locals.get(e) else {
                return infinite.as_ref().map_or_else(Vec::new, |i| i.matrix(e - locals.len()));
            };
            let permittivity = self.permittivity[level.mesh.triangle_regions[e] as usize];
            let triangle = reference.element(level.mesh.corners(e), self.problem.symmetry);
            let m = local.len();
            let mut out = vec![0.0; m * m];
            for j in 0..m {
                for i in j..m {
                    let sign = permittivity * local[i].sign * local[j].sign;
                    out[j * m + i] = sign * triangle.gradients(local[i].shape as usize, local[j].shape as usize);
                }
            }
            out
        };
        Ok(gram(&dofs, &fixed, &units, element)?)
    }

    fn functionals(&self, products: &DMatrix<f64>) -> Vec<Functional> {
        let n = self.held.len();
        let matrix: Vec<Vec<f64>> = (0..n).map(|i| (0..n).map(|j| products[(i, j)]).collect()).collect();
        let weights = |field: usize| -> Vec<f64> {
            let all = self.problem.conductors.iter().map(|c| c.potential).enumerate();
            all.map(|(c, v)| if field == n { v } else { f64::from(u8::from(c == field)) }).collect()
        };
        let found = charges(self.problem, self.quantities, &matrix).ok().flatten().unwrap_or_default();
        let functional = |f: super::goals::Functional| Functional {
            name: f.name,
            value: f.value,
            unit: f.unit,
            scale: f.scale,
            left: weights(f.pair.0),
            right: weights(f.pair.1),
            factor: f.factor,
        };
        found.into_iter().map(functional).collect()
    }
}
