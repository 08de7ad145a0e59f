//! The linear system of an electrostatic problem on one mesh, and its unit-potential solutions.

use super::exterior::{Exterior, InfiniteElement, POWERS, UNKNOWNS};
use super::form::dielectric;
use super::{ElectrostaticsError, Problem};
use crate::assembly::{Pattern, for_each_element};
use crate::mesh::{Mesh, NONE, Topology};
use crate::solve::{Direct, Kind, Memory};
use crate::space::{Element, ElementDofs, Nodes, Numbering, P2, ShapeTable, triangle_rule};
use crate::{FemError, Symmetry};
use nalgebra_sparse::CscMatrix;
use std::collections::BTreeMap;
use std::time::Instant;

/// Owner of unknowns that are zero in every solution.
const ZERO: u16 = u16::MAX - 1;

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
    /// Assembles and solves on a mesh.
    pub fn new(problem: &'a Problem, mesh: &'a Mesh) -> Result<Solved<'a>, FemError> {
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
        let far = match (&exterior, problem.symmetry) {
            // In three dimensions the potential vanishes at infinity; in two it floats unless a conductor goes there.
            (Some(_), Symmetry::Axisymmetric) => dofs.count - 1,
            _ => usize::MAX,
        };
        let fixed: Vec<bool> = owner.iter().enumerate().map(|(i, &o)| o != u16::MAX || i == far).collect();
        let numbering = Numbering::new(&fixed);
        let degree = if mesh.curved_edges.is_empty() { 4 } else { 6 };
        let rule = P2::table(&triangle_rule(degree));
        let pattern = Pattern::new(&dofs, &numbering);
        let mut matrix = pattern.matrix();
        let system = System {
            nodes: &nodes,
            rule: &rule,
            mesh,
            permittivity: &permittivity,
            exterior: exterior.as_ref(),
            topology: &topology,
            symmetry: problem.symmetry,
        };
        pattern.assemble(&mut matrix, |e, out| system.matrix(e, out));
        drop(pattern);
        let assembled = begin.elapsed().as_secs_f64();
        let direct = Direct::new(&matrix, Kind::Llt)?;
        let mut solved = Solved {
            problem,
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
            let rhs: Vec<f64> = self.numbering.restrict(load).iter().map(|x| -x).collect();
            let x = self.solve_free(&rhs)?;
            self.numbering.scatter(&x, u);
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
        u
    }

    /// Solves for the free unknowns with the factorised matrix.
    pub(super) fn solve_free(&mut self, rhs: &[f64]) -> Result<Vec<f64>, FemError> {
        let solution = self.direct.solve(&self.matrix, rhs)?;
        self.residual = self.residual.max(solution.residual);
        Ok(solution.x)
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

fn permittivities(problem: &Problem, mesh: &Mesh) -> Result<Vec<f64>, ElectrostaticsError> {
    mesh.region_names
        .iter()
        .map(|name| {
            let found = problem.permittivity.iter().find(|(region, _)| region == name).map_or(f64::NAN, |(_, e)| *e);
            let good = found > 0.0 && found.is_finite();
            good.then_some(found)
                .ok_or_else(|| ElectrostaticsError::BadPermittivity { region: name.clone(), permittivity: found })
        })
        .collect()
}

/// Unknowns of all triangles and infinite elements, and the first exterior unknown of every open node.
fn unknowns(nodes: &Nodes, topology: &Topology, exterior: Option<&Exterior>) -> (ElementDofs, Option<Vec<u32>>) {
    let mut dofs = ElementDofs::quadratic(nodes);
    let Some(exterior) = exterior else { return (dofs, None) };
    let mut sites = vec![NONE; nodes.points.len()];
    let mut next = nodes.points.len() as u32;
    let open: Vec<[u32; 3]> = exterior.edges.iter().filter_map(|&e| nodes.edge(topology, e)).collect();
    for &node in open.iter().flatten() {
        if sites[node as usize] == NONE {
            sites[node as usize] = next;
            next += (POWERS - 1) as u32;
        }
    }
    for edge in open {
        let mut local = Vec::with_capacity(UNKNOWNS);
        for node in edge {
            local.push(node);
            local.extend((0..POWERS as u32 - 1).map(|k| sites[node as usize] + k));
        }
        local.push(next);
        dofs.push(&local);
    }
    dofs.count = next as usize + 1;
    (dofs, Some(sites))
}

/// Conductors that touch at a node, for every such node.
pub(super) type Junctions = BTreeMap<u32, Vec<u16>>;

/// Conductor that fixes each unknown, `u16::MAX` where it is free; and the nodes that several conductors share.
fn owners(
    problem: &Problem,
    mesh: &Mesh,
    nodes: &Nodes,
    topology: &Topology,
    dofs: &ElementDofs,
    sites: Option<&Vec<u32>>,
) -> Result<(Vec<u16>, Junctions), FemError> {
    if problem.conductors.is_empty() {
        return Err(ElectrostaticsError::NoConductor.into());
    }
    let mut owner = vec![u16::MAX; dofs.count];
    let mut junctions = Junctions::new();
    for (c, conductor) in problem.conductors.iter().enumerate() {
        if !conductor.potential.is_finite() {
            return Err(ElectrostaticsError::BadPotential {
                boundary: conductor.boundary.clone(),
                potential: conductor.potential,
            }
            .into());
        }
        for edge in mesh.edges_of(mesh.boundary(&conductor.boundary)?) {
            for node in nodes.edge(topology, edge).into_iter().flatten() {
                let slot = &mut owner[node as usize];
                if *slot == u16::MAX {
                    *slot = c as u16;
                } else if *slot != c as u16 {
                    let touching = junctions.entry(node).or_insert_with(|| vec![*slot]);
                    if !touching.contains(&(c as u16)) {
                        touching.push(c as u16);
                    }
                }
            }
        }
    }
    let Some(sites) = sites else { return Ok((owner, junctions)) };
    // A conductor that reaches the open boundary goes on to infinity along the ray.
    for (node, &site) in sites.iter().enumerate().filter(|(_, s)| **s != NONE) {
        let c = owner[node];
        if c == u16::MAX {
            continue;
        }
        // Constant along the ray: trace and infinity at the conductor's potential, higher powers zero.
        owner[site as usize..site as usize + POWERS - 1].fill(ZERO);
        let far = &mut owner[dofs.count - 1];
        if *far != u16::MAX && *far != c {
            let remedy = "let at most one conductor reach the open boundary";
            return Err(
                ElectrostaticsError::OpenBoundary { reason: "two conductors reach it", at: nodes.points[node], remedy }.into()
            );
        }
        *far = c;
    }
    Ok((owner, junctions))
}
