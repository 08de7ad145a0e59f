//! FEM cases as text: `truegap.case/1` files in, named quantities out.
//!
//! Text carries units; everything in a `Case` is SI. The file describes one body, one physics, one state.

mod elasticity;
mod electrostatics;
mod error;
mod geometry;
mod raw;
mod read;
mod result;
mod temperature;
pub mod units;

pub use elasticity::problem as elastic_problem;
pub use error::CaseError;
pub use read::read_case;
pub use result::{CaseResult, MeshCounts, QuantityValue, SecondsSpent};
pub use temperature::{RadialTerm, Temperature};

use crate::mesh::{Geometry, Mesh, MeshOptions, Point, SizeField, mesh_geometry};
use crate::{FemError, Symmetry};

/// Which equations.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Physics {
    /// Potentials and charges.
    Electrostatics,
    /// Displacements and stresses.
    Elasticity,
}

/// Constitutive law of a solid.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Law {
    /// Hooke's law, small strain.
    Linear,
    /// Compressible neo-Hookean, finite strain.
    NeoHookean,
    /// St Venant-Kirchhoff, finite rotation, small strain.
    StVenantKirchhoff,
}

/// A material; what a physics does not need may be missing.
#[derive(Debug, Clone, PartialEq)]
pub struct Material {
    /// Name.
    pub name: String,
    /// Relative permittivity.
    pub relative_permittivity: Option<f64>,
    /// Young's modulus (Pa).
    pub young: Option<f64>,
    /// Poisson's ratio.
    pub poisson: Option<f64>,
    /// Linear thermal expansion (1/K).
    pub expansion: f64,
    /// Constitutive law.
    pub law: Law,
}

/// What holds on a named boundary.
#[derive(Debug, Clone, PartialEq)]
pub struct Condition {
    /// Name of the boundary.
    pub boundary: String,
    /// Potential (V).
    pub potential: Option<f64>,
    /// The boundary stands for unbounded space.
    pub open: bool,
    /// Components held at zero.
    pub fix: [bool; 2],
    /// Prescribed displacement of the components (m).
    pub displace: [Option<f64>; 2],
    /// Pressure on the surface, positive inwards (Pa).
    pub pressure: Option<f64>,
}

/// How fine.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MeshRequest {
    /// Relative error wanted in the outputs; refines adaptively.
    pub target_error: Option<f64>,
    /// Longest edge (m), of the first mesh if adaptive.
    pub max_edge: Option<f64>,
    /// Polynomial order of the elements.
    pub order: u8,
}

/// What an output is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum OutputKind {
    /// Charge over the largest potential difference.
    Capacitance,
    /// Maxwell's matrix.
    CapacitanceMatrix,
    /// Field or strain energy.
    Energy,
    /// Force on a boundary.
    Reaction,
    /// Displacement at a point.
    Displacement,
    /// Stress at a point.
    Stress,
    /// Strain at a point.
    Strain,
    /// Potential at a point.
    Potential,
    /// Field at a point.
    Field,
}

/// A wanted quantity.
#[derive(Debug, Clone, PartialEq)]
pub struct Output {
    /// Name in the results.
    pub name: String,
    /// What.
    pub kind: OutputKind,
    /// On which boundary.
    pub boundary: Option<String>,
    /// At which point (m).
    pub at: Option<Point>,
    /// Which component, as written: `r`, `z`, `rr`, ...
    pub component: Option<String>,
}

/// A checked case; SI throughout.
#[derive(Debug, Clone, PartialEq)]
pub struct Case {
    /// Where it was read from, for messages.
    pub file: String,
    /// Which equations.
    pub physics: Physics,
    /// Which symmetry.
    pub symmetry: Symmetry,
    /// Regions and boundaries.
    pub geometry: Geometry,
    /// Material of every region, index into `materials`.
    pub region_materials: Vec<usize>,
    /// Materials.
    pub materials: Vec<Material>,
    /// Conditions, one a boundary name.
    pub conditions: Vec<Condition>,
    /// Temperature.
    pub temperature: Temperature,
    /// How fine.
    pub mesh: MeshRequest,
    /// What is asked for.
    pub outputs: Vec<Output>,
}

/// The first mesh of a case: as coarse as the drawing and `max_edge` allow; adaptive cases refine it while solving.
pub fn mesh_case(case: &Case) -> Result<Mesh, FemError> {
    let max_edge = case.mesh.max_edge.unwrap_or(f64::INFINITY);
    // A quadratic arc of the angle a misses a^4 / 480 of the area: a tenth of the target, 10 degrees at most.
    let arc = case.mesh.target_error.map_or(10.0, |t| (48.0 * t).powf(0.25).to_degrees().clamp(0.5, 10.0));
    let options =
        MeshOptions { size: SizeField { max_edge, ..SizeField::default() }, arc_step_degrees: arc, ..MeshOptions::default() };
    Ok(mesh_geometry(&case.geometry, &options)?)
}

/// Solves a case.
pub fn solve_case(case: &Case) -> Result<CaseResult, FemError> {
    match case.physics {
        Physics::Electrostatics => Ok(electrostatics::solve(case)?.0),
        Physics::Elasticity => Ok(elasticity::solve(case)?.0),
    }
}

/// Solves a case and returns the last mesh as well, with the potential (V) at its quadratic nodes in
/// electrostatics, the displacement (m, `2 node + component`) in elasticity.
pub fn solve_case_with_fields(case: &Case) -> Result<(CaseResult, Mesh, Vec<f64>), FemError> {
    match case.physics {
        Physics::Electrostatics => {
            let (result, mesh, outcome) = electrostatics::solve(case)?;
            Ok((result, mesh, outcome.potential))
        }
        Physics::Elasticity => {
            let (result, outcome) = elasticity::solve(case)?;
            let body = outcome.solution.body();
            let displacement = outcome.solution.state()[..body.displacements].to_vec();
            Ok((result, body.problem.mesh.clone(), displacement))
        }
    }
}
