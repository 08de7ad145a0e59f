//! The electric field on a deformed section.
//!
//! Insulators, beads and air between conductors; natural condition at the rim, so no field outside of the plates. Potentials are on the section's own
//! mesh, capacitances on one refined from it; both keep the section's straight edges.

use super::submesh::{Part, part};
use crate::error::AuditError;
use truegap_fem::Symmetry;
use truegap_fem::electrostatics::{Accuracy, Answer, Conductor, Goal, Problem, Quantity, solve_adaptive, solve_on};
use truegap_fem::mesh::{Mesh, Topology};
use truegap_fem::space::{Nodes, P2};

/// Electrode at 1 V against shields at 0 V.
#[derive(Clone, Debug)]
pub struct Field {
    /// where there is a field: part of the section
    pub part: Part,
    /// its quadratic nodes
    pub nodes: Nodes,
    /// potential at them, V
    pub potential: Vec<f64>,
    /// capacitance across the gap, F
    pub main: f64,
    /// capacitance behind the electrode, F
    pub backing: f64,
    /// estimated magnitude of the error of their sum, F
    pub error_estimate: f64,
}

/// What fails where it fails.
const FAILED: &str = "field on the deformed section";
/// Regions without a field.
const METALS: [&str; 2] = ["plating", "conductor"];

/// Solves for the field on a section; `permittivity` gives that of a region (F/m), `target` is the relative error wanted of the capacitances.
///
/// # Errors
/// Where the section has folded, or the target is not reached.
pub(crate) fn field(section: &Mesh, permittivity: &dyn Fn(&str) -> f64, target: f64) -> Result<Field, AuditError> {
    let part = part(section, |region| !METALS.contains(&region));
    let problem = problem(&part.mesh, permittivity, &[("face", 1.0), ("conductor.top", 1.0), ("bottom", 0.0), ("top", 0.0)])?;
    let potential = solve_on(&problem, &[], &part.mesh).map_err(AuditError::fem(FAILED))?.potential;
    let answers = capacitances(&problem, &part.mesh, &["face", "conductor.top"], target)?;
    let topology = Topology::new(&part.mesh);
    let nodes = Nodes::new(&part.mesh, &topology);
    Ok(Field {
        main: answers[0].value,
        backing: answers[1].value,
        error_estimate: answers.iter().map(|a| a.error_estimate).sum(),
        potential,
        nodes,
        part,
    })
}

/// Capacitance across the gap of a section alone, F; arguments as in [`field`].
///
/// # Errors
/// As [`field`].
pub(crate) fn gap_capacitance(section: &Mesh, permittivity: &dyn Fn(&str) -> f64, target: f64) -> Result<f64, AuditError> {
    let gap = part(section, |region| !METALS.contains(&region) && region != "backing").mesh;
    let problem = problem(&gap, permittivity, &[("face", 1.0), ("bottom", 0.0)])?;
    Ok(capacitances(&problem, &gap, &["face"], target)?[0].value)
}

fn problem(mesh: &Mesh, permittivity: &dyn Fn(&str) -> f64, conductors: &[(&str, f64)]) -> Result<Problem, AuditError> {
    mesh.check().map_err(|e| AuditError::fem(FAILED)(truegap_fem::FemError::from(e)))?;
    let conductor = |&(boundary, potential): &(&str, f64)| Conductor { boundary: boundary.into(), potential };
    Ok(Problem {
        symmetry: Symmetry::Axisymmetric,
        permittivity: mesh.region_names.iter().map(|name| (name.clone(), permittivity(name))).collect(),
        conductors: conductors.iter().map(conductor).collect(),
        open: Vec::new(),
    })
}

/// Capacitances of some boundaries, on a mesh that is refined until each has its relative target.
fn capacitances(problem: &Problem, mesh: &Mesh, boundaries: &[&str], target: f64) -> Result<Vec<Answer>, AuditError> {
    let goal = |boundary: &&str| Quantity { name: (*boundary).into(), goal: Goal::Capacitance { boundary: (*boundary).into() } };
    let goals: Vec<Quantity> = boundaries.iter().map(goal).collect();
    let accuracy = Accuracy { target, max_unknowns: 400_000, ..Accuracy::default() };
    let mut finer = mesh.clone();
    Ok(solve_adaptive(problem, &goals, &mut finer, &accuracy).map_err(AuditError::fem(FAILED))?.answers)
}

impl Field {
    /// Magnitude of the field at the corners of a triangle, V/m.
    pub fn strength(&self, triangle: usize) -> [f64; 3] {
        let element = self.nodes.element(triangle);
        [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]].map(|reference| {
            let map = element.map_at(reference);
            let (_, slope) = P2::at(reference);
            let mut e = [0.0; 2];
            for (k, &node) in self.nodes.triangles[triangle].iter().enumerate() {
                let g = map.gradient(slope[k]);
                let u = self.potential[node as usize];
                e = [e[0] - u * g[0], e[1] - u * g[1]];
            }
            e[0].hypot(e[1])
        })
    }
}
