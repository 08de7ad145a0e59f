//! A checked case: regions, materials, conditions, outputs. SI throughout.

use super::temperature::Temperature;
use crate::elasticity::PressureLoad;
use crate::mesh::{Geometry, Point};
use crate::symmetry::Symmetry;

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

/// What drives a plate.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Drive {
    /// It moves towards the body (m).
    Travel(f64),
    /// It presses (N; N/m in planar bodies).
    Force(f64),
}

/// A rigid plate across a coordinate.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Plate {
    /// Which coordinate: 0 or 1.
    pub component: usize,
    /// Where it stands without load (m).
    pub position: f64,
    /// How it presses.
    pub drive: Drive,
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
    /// On which surface it acts, where the case says so.
    pub pressure_load: Option<PressureLoad>,
    /// A rigid plate without friction that the boundary may touch.
    pub plate: Option<Plate>,
}

/// How a target is met.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, serde::Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Method {
    /// Triangles of one order are halved where the error is; the rule, and the only one that takes every case.
    #[default]
    Refine,
    /// Polynomials of high degree on meshes graded into the singular corners.
    Hp,
}

impl Method {
    /// Whether it is the rule.
    pub fn is_refine(&self) -> bool {
        *self == Method::Refine
    }
}

/// How fine.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MeshRequest {
    /// Relative error wanted in the outputs; refines adaptively.
    pub target_error: Option<f64>,
    /// Longest edge (m), of the first mesh if adaptive.
    pub max_edge: Option<f64>,
    /// Polynomial order of the elements; the hp version chooses its own.
    pub order: u8,
    /// How the error is brought down.
    pub method: Method,
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
    /// Force of a plate.
    ContactForce,
    /// Radius of what touches a plate.
    ContactRadius,
    /// Largest pressure under a plate.
    PeakPressure,
    /// Way of a plate towards the body.
    PlateTravel,
    /// Potential at a point.
    Potential,
    /// Field at a point.
    Field,
}

impl OutputKind {
    /// Whether it belongs to a plate.
    pub fn is_of_a_plate(self) -> bool {
        matches!(self, Self::ContactForce | Self::ContactRadius | Self::PeakPressure | Self::PlateTravel)
    }
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
