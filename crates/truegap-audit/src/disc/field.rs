//! The electric field on a deformed section.
//!
//! Insulators, beads and air between conductors; natural condition at the rim, so no field outside of the plates. Potentials are on the section's own
//! mesh, capacitances on one refined from it; both keep the section's straight edges.

use super::submesh::{Part, part};
use crate::AuditError;
use truegap_fem::Symmetry;
use truegap_fem::mesh::{Mesh, Topology};
use truegap_fem::physics::electrostatics::{Accuracy, Conductor, Goal, Problem, Quantity, solve_adaptive, solve_on};
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

/// Regions without a field.
const METALS: [&str; 2] = ["plating", "conductor"];

/// Solves for the field on a section; `permittivity` gives that of a region (F/m), `target` is the relative error wanted of the capacitances.
///
/// # Errors
/// Where the section has folded, or the target is not reached.
pub fn field(section: &Mesh, permittivity: &dyn Fn(&str) -> f64, target: f64) -> Result<Field, AuditError> {
    let named = || AuditError::fem("field on the deformed section");
    let part = part(section, |region| !METALS.contains(&region));
    part.mesh.check().map_err(|e| named()(truegap_fem::FemError::from(e)))?;
    let conductor = |boundary: &str, potential| Conductor { boundary: boundary.into(), potential };
    let problem = Problem {
        symmetry: Symmetry::Axisymmetric,
        permittivity: part.mesh.region_names.iter().map(|name| (name.clone(), permittivity(name))).collect(),
        conductors: vec![
            conductor("face", 1.0),
            conductor("conductor.top", 1.0),
            conductor("bottom", 0.0),
            conductor("top", 0.0),
        ],
        open: Vec::new(),
    };
    let goal = |name: &str, boundary: &str| Quantity { name: name.into(), goal: Goal::Capacitance { boundary: boundary.into() } };
    let goals = [goal("main", "face"), goal("backing", "conductor.top")];
    let potential = solve_on(&problem, &[], &part.mesh).map_err(named())?.potential;
    let mut finer = part.mesh.clone();
    let accuracy = Accuracy { target, max_unknowns: 400_000, ..Accuracy::default() };
    let outcome = solve_adaptive(&problem, &goals, &mut finer, &accuracy).map_err(named())?;
    let topology = Topology::new(&part.mesh);
    let nodes = Nodes::new(&part.mesh, &topology);
    Ok(Field {
        main: outcome.answers[0].value,
        backing: outcome.answers[1].value,
        error_estimate: outcome.answers.iter().map(|a| a.error_estimate).sum(),
        potential,
        nodes,
        part,
    })
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
