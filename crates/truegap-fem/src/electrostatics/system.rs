//! The linear system of an electrostatic problem on one mesh, and its unit-potential solutions.

use super::constrained_dofs::{ConstrainedDofs, reduce};
use super::exterior::{Exterior, InfiniteElement, UNKNOWNS};
use super::floating::check_held;
use super::form::dielectric;
use super::problem::Problem;
use super::unknowns::{Junctions, owners, permittivities, unknowns};
use crate::algebra::{Direct, Kind, Memory, Pattern, for_each_element};
use crate::error::FemError;
use crate::mesh::{Mesh, Topology};
use crate::space::{Element, ElementDofs, Nodes, Numbering, Order, P2, ShapeTable, triangle_rule};
use crate::symmetry::Symmetry;
use nalgebra_sparse::CscMatrix;
use std::time::Instant;

/// Wall-clock seconds of the steps.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Seconds {
    /// Meshing and refining.
    pub mesh: f64,
    /// Numbering, pattern and assembly.
    pub assemble: f64,
    /// Factorisation, substitution and error estimate.
    pub solve: f64,
}

/// A problem solved on one mesh: the field of every conductor at 1 V with all others at 0 V, and their sum.
pub struct Solved<'a> {
    /// The mesh.
    pub mesh: &'a Mesh,
    /// Its edges.
    pub topology: Topology,
    /// Its quadratic nodes.
    pub nodes: Nodes,
    pub(super) problem: &'a Problem,
    pub(super) order: Order,
    constrained: ConstrainedDofs,
    pub(super) permittivity: Vec<f64>,
    pub(super) exterior: Option<Exterior>,
    pub(super) dofs: ElementDofs,
    pub(super) numbering: Numbering,
    pub(super) owner: Vec<u16>,
    pub(super) junctions: Junctions,
    matrix: CscMatrix<f64>,
    direct: Direct,
    rule: Vec<ShapeTable<6>>,
    /// Potentials of the unit solutions, one a conductor, over all unknowns.
    pub units: Vec<Vec<f64>>,
    /// The potential with all conductors at their values (V): nodes of the mesh first, exterior unknowns after.
    pub potential: Vec<f64>,
    /// Largest normwise backward error of the solves.
    pub residual: f64,
    /// Seconds of assembling and solving.
    pub seconds: Seconds,
}

impl<'a> Solved<'a> {
    /// Assembles and solves on a mesh, with quadratic elements.
    pub fn new(problem: &'a Problem, mesh: &'a Mesh) -> Result<Solved<'a>, FemError> {
        Solved::of_order(problem, mesh, Order::Quadratic)
    }

    /// Assembles and solves on a mesh.
    pub fn of_order(problem: &'a Problem, mesh: &'a Mesh, order: Order) -> Result<Solved<'a>, FemError> {
        let begin = Instant::now();
        if problem.symmetry == Symmetry::Axisymmetric {
            mesh.check_axis()?;
        }
        let topology = Topology::new(mesh);
        let nodes = Nodes::new(mesh, &topology);
        let permittivity = permittivities(problem, mesh)?;
        let open = problem.open.iter().map(|name| mesh.boundary(name)).collect::<Result<Vec<_>, _>>()?;
        let exterior = Exterior::new(mesh, &topology, problem.symmetry, &open)?;
        let (dofs, sites) = unknowns(&nodes, &topology, exterior.as_ref());
        let (owner, junctions) = owners(problem, mesh, &nodes, &topology, &dofs, sites.as_ref())?;
        check_held(problem, mesh)?;
        let far = match (&exterior, problem.symmetry) {
            // In three dimensions the potential vanishes at infinity; in two it floats unless a conductor goes there.
            (Some(_), Symmetry::Axisymmetric) => dofs.count - 1,
            _ => usize::MAX,
        };
        let constrained = ConstrainedDofs::new(order, &nodes, &topology);
        let mut fixed: Vec<bool> = owner.iter().enumerate().map(|(i, &o)| o != u16::MAX || i == far).collect();
        constrained.mark(&mut fixed);
        let numbering = Numbering::new(&fixed);
        let degree = if mesh.curved_edges.is_empty() { 4 } else { 6 };
        let rule = P2::table(&triangle_rule(degree));
        let without = constrained.without(&dofs);
        let (mut matrix, scatter) = Pattern::new(without.as_ref().unwrap_or(&dofs), &numbering)?.into_matrix();
        let system = System {
            nodes: &nodes,
            rule: &rule,
            mesh,
            permittivity: &permittivity,
            exterior: exterior.as_ref(),
            topology: &topology,
            symmetry: problem.symmetry,
        };
        match order {
            Order::Quadratic => scatter.assemble(&mut matrix, |e, out| system.matrix(e, out)),
            Order::Linear => scatter.assemble(&mut matrix, |e, out| system.reduced(e, out)),
        }
        drop((scatter, without));
        let assembled = begin.elapsed().as_secs_f64();
        let direct = Direct::new(&matrix, Kind::Llt)?;
        let mut solved = Solved {
            problem,
            order,
            constrained,
            mesh,
            topology,
            nodes,
            permittivity,
            exterior,
            dofs,
            numbering,
            owner,
            junctions,
            matrix,
            direct,
            rule,
            units: Vec::new(),
            potential: Vec::new(),
            residual: 0.0,
            seconds: Seconds::default(),
        };
        solved.solve_units()?;
        solved.seconds = Seconds { mesh: 0.0, assemble: assembled, solve: begin.elapsed().as_secs_f64() - assembled };
        Ok(solved)
    }

    fn solve_units(&mut self) -> Result<(), FemError> {
        let count = self.problem.conductors.len();
        let mut units: Vec<Vec<f64>> = (0..count).map(|c| self.prescribed(c as u16)).collect();
        let prescribed: Vec<&[f64]> = units.iter().map(Vec::as_slice).collect();
        // Elements on which all vectors vanish contribute nothing: most of them, for prescribed values.
        let loads = self.products(&prescribed, |of| of.iter().any(|&d| prescribed.iter().any(|u| u[d as usize] != 0.0)));
        for (u, load) in units.iter_mut().zip(&loads) {
            let response = self.response(load.iter().map(|x| -x).collect())?;
            u.iter_mut().zip(&response).for_each(|(u, r)| *u += r);
        }
        self.potential = vec![0.0; self.dofs.count];
        for (u, c) in units.iter().zip(&self.problem.conductors) {
            self.potential.iter_mut().zip(u).for_each(|(v, u)| *v += c.potential * u);
        }
        self.units = units;
        Ok(())
    }

    /// Values of all prescribed unknowns when conductor `c` is at 1 V; a node where several touch takes the mean.
    fn prescribed(&self, c: u16) -> Vec<f64> {
        let mut u: Vec<f64> = self.owner.iter().map(|&o| f64::from(u8::from(o == c))).collect();
        for (&node, touching) in &self.junctions {
            let share = f64::from(u8::from(touching.contains(&c)));
            u[node as usize] = share / touching.len() as f64;
        }
        self.constrained.fill(&mut u);
        u
    }

    /// Potential under the charges `load` with all conductors at 0 V, over all unknowns.
    pub(super) fn response(&mut self, mut load: Vec<f64>) -> Result<Vec<f64>, FemError> {
        self.constrained.gather(&mut load);
        let solution = self.direct.solve(&self.matrix, &self.numbering.restrict(&load))?;
        self.residual = self.residual.max(solution.residual);
        load.fill(0.0);
        self.numbering.scatter(&solution.x, &mut load);
        self.constrained.fill(&mut load);
        Ok(load)
    }

    fn element(&self) -> System<'_> {
        System {
            nodes: &self.nodes,
            rule: &self.rule,
            mesh: self.mesh,
            permittivity: &self.permittivity,
            exterior: self.exterior.as_ref(),
            topology: &self.topology,
            symmetry: self.problem.symmetry,
        }
    }

    /// K u for several vectors over all unknowns, element by element; elements that `counts` refuses are left out.
    fn products(&self, vectors: &[&[f64]], counts: impl Fn(&[u32]) -> bool + Sync) -> Vec<Vec<f64>> {
        let mut sums = vec![vec![0.0; self.dofs.count]; vectors.len()];
        let element = self.element();
        let local = |e: usize| {
            let of = self.dofs.of(e);
            let m = of.len();
            if !counts(of) {
                return Vec::new();
            }
            let mut k = vec![0.0; m * m];
            element.matrix(e, &mut k);
            let row = |u: &[f64], i: usize| (0..m).map(|j| k[j * m + i] * u[of[j] as usize]).sum::<f64>();
            vectors.iter().map(|u| (0..m).map(|i| row(u, i)).collect::<Vec<f64>>()).collect::<Vec<_>>()
        };
        for_each_element(self.dofs.elements(), local, |e, parts| {
            for (sum, part) in sums.iter_mut().zip(parts) {
                self.dofs.of(e).iter().zip(part).for_each(|(&d, x)| sum[d as usize] += x);
            }
        });
        sums
    }

    /// K u on the prescribed unknowns (charge at the nodes of the conductors); meaningless elsewhere.
    fn reactions(&self, vectors: &[&[f64]]) -> Vec<Vec<f64>> {
        self.products(vectors, |of| of.iter().any(|&d| self.owner[d as usize] != u16::MAX))
    }

    /// Maxwell's capacitance matrix (F, or F/m if planar), in the order of the conductors: charge on i per volt on j.
    ///
    /// **Source:** C_ij = ∫ ε ∇u_i · ∇u_j, which for Galerkin solutions is the charge by the consistent residual: the sum of
    /// K u_j over the nodes of i.
    pub fn capacitance_matrix(&self) -> Vec<Vec<f64>> {
        let reactions = self.reactions(&self.units.iter().map(Vec::as_slice).collect::<Vec<_>>());
        let n = self.units.len();
        let own: Vec<Vec<f64>> = (0..n).map(|i| self.prescribed(i as u16)).collect();
        let entry = |i: usize, j: usize| own[i].iter().zip(&reactions[j]).map(|(u, k)| u * k).sum::<f64>();
        (0..n).map(|i| (0..n).map(|j| 0.5 * (entry(i, j) + entry(j, i))).collect()).collect()
    }

    /// Charges on the conductors (C, or C/m) by the consistent residual: the sum of K V over the nodes of each.
    pub fn charges(&self) -> Vec<f64> {
        let reaction = &self.reactions(&[&self.potential])[0];
        let sum = |c: usize| self.prescribed(c as u16).iter().zip(reaction).map(|(u, q)| u * q).sum();
        (0..self.units.len()).map(sum).collect()
    }

    /// Field energy (J, or J/m), the exterior included: half of V K V.
    pub fn energy(&self) -> f64 {
        let product = &self.products(&[&self.potential], |_| true)[0];
        0.5 * self.potential.iter().zip(product).map(|(u, k)| u * k).sum::<f64>()
    }

    /// Number of free unknowns.
    pub fn unknowns(&self) -> usize {
        self.numbering.free.len()
    }

    /// What the factorisation holds.
    pub fn memory(&self) -> Memory {
        self.direct.memory()
    }

    pub(super) fn infinite(&self, k: usize) -> Option<InfiniteElement> {
        self.element().infinite(k)
    }
}

/// Everything an element matrix depends on.
struct System<'a> {
    nodes: &'a Nodes,
    rule: &'a [ShapeTable<6>],
    mesh: &'a Mesh,
    permittivity: &'a [f64],
    exterior: Option<&'a Exterior>,
    topology: &'a Topology,
    symmetry: Symmetry,
}

impl System<'_> {
    fn matrix(&self, e: usize, out: &mut [f64]) {
        let triangles = self.mesh.triangles.len();
        if e < triangles {
            let permittivity = self.permittivity[self.mesh.triangle_regions[e] as usize];
            return triangle_matrix(&self.nodes.element(e), self.rule, self.symmetry, permittivity, out);
        }
        if let Some(element) = self.infinite(e - triangles) {
            element.matrix(out);
        }
    }

    /// The same without the middles that follow their ends.
    fn reduced(&self, e: usize, out: &mut [f64]) {
        let mut full = [0.0; UNKNOWNS * UNKNOWNS];
        let m = if e < self.mesh.triangles.len() { 6 } else { UNKNOWNS };
        self.matrix(e, &mut full[..m * m]);
        reduce(&mut full[..m * m], m, out);
    }

    fn infinite(&self, k: usize) -> Option<InfiniteElement> {
        let exterior = self.exterior?;
        let nodes = self.nodes.edge(self.topology, exterior.edges[k])?;
        let relative = |i: u32| {
            let p = self.nodes.points[i as usize];
            [p[0] - exterior.centre[0], p[1] - exterior.centre[1]]
        };
        let region = self.mesh.triangle_regions[exterior.triangles[k] as usize];
        Some(InfiniteElement {
            nodes: nodes.map(relative),
            symmetry: self.symmetry,
            permittivity: self.permittivity[region as usize],
        })
    }
}

/// Adds the matrix of one triangle (full, column by column).
fn triangle_matrix(element: &Element, rule: &[ShapeTable<6>], symmetry: Symmetry, permittivity: f64, out: &mut [f64]) {
    for q in rule {
        let map = element.map(q);
        let weight = q.weight * map.jacobian * symmetry.weight(map.at[0]);
        let shapes = map.shapes(q);
        for j in 0..6 {
            for i in j..6 {
                out[6 * j + i] += weight * dielectric(permittivity, shapes[i], shapes[j]);
            }
        }
    }
    for j in 0..6 {
        for i in 0..j {
            out[6 * j + i] = out[6 * i + j];
        }
    }
}
