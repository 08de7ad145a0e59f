//! What can be wrong with an elastic body, and how its solution fails.

use crate::algebra::SolveError;
use crate::mesh::MeshError;

/// Errors of the elastic problems.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ElasticityError {
    /// A mesh that cannot be used, or a boundary that it does not have.
    #[error(transparent)]
    Mesh(#[from] MeshError),
    /// The linear algebra failed.
    #[error(transparent)]
    Solve(#[from] SolveError),
    /// The list of materials does not fit the regions.
    #[error(
        "{given} materials were given for {} regions ({}); give one for each, in this order", regions.len(), regions.join(", ")
    )]
    MaterialCount {
        /// Materials given.
        given: usize,
        /// Names of the regions.
        regions: Vec<String>,
    },
    /// A number of a material is not physics, or not for this law.
    #[error("{quantity} of the material of region `{region}` is {value}: {remedy}")]
    Material {
        /// Region.
        region: String,
        /// Which number.
        quantity: &'static str,
        /// Its value.
        value: f64,
        /// What to do.
        remedy: &'static str,
    },
    /// The mixed formulation with linear displacements.
    #[error("region `{region}` asks for the mixed formulation with linear elements, which is unstable; use quadratic elements")]
    MixedNeedsQuadratic {
        /// Region.
        region: String,
    },
    /// Estimates with linear elements.
    #[error(
        "errors are estimated for quadratic elements only, and the order is linear; use quadratic elements, or `Solver::solve` where no estimate is needed"
    )]
    EstimateNeedsQuadratic,
    /// Two conditions contradict each other.
    #[error("two conditions prescribe the {component} displacement at ({}, {}) m: {first} m and {second} m; remove one", at[0], at[1])]
    Conflict {
        /// Direction.
        component: &'static str,
        /// Where.
        at: [f64; 2],
        /// One value.
        first: f64,
        /// The other.
        second: f64,
    },
    /// A value in a condition is not finite.
    #[error("the condition on {place} has the value {value}; give a finite number")]
    Value {
        /// Boundary or point.
        place: String,
        /// The value.
        value: f64,
    },
    /// A point that is no node of the mesh.
    #[error("the condition at the point ({}, {}) m finds no node there; make it a corner of an outline", at[0], at[1])]
    NoNode {
        /// The point.
        at: [f64; 2],
    },
    /// Pressure on an edge inside the body.
    #[error("boundary `{boundary}` with a pressure runs inside the body near ({}, {}) m; pressure acts on the outside only", at[0], at[1])]
    PressureInside {
        /// Boundary.
        boundary: String,
        /// Where.
        at: [f64; 2],
    },
    /// A body that can move as a whole.
    #[error(
        "the part of the body around ({:.4e}, {:.4e}) m can still move as a whole ({motion}); fix that motion on a boundary or at a point of it", at[0], at[1]
    )]
    RigidMotion {
        /// A point of the part.
        at: [f64; 2],
        /// What it can do.
        motion: &'static str,
    },
    /// Newton's method found no equilibrium.
    #[error(
        "no equilibrium found between load factors {reached} and {wanted} (last relative correction {correction:.1e}); {advice}"
    )]
    NotConverged {
        /// Last factor with an equilibrium.
        reached: f64,
        /// Factor that failed.
        wanted: f64,
        /// Largest correction over largest displacement.
        correction: f64,
        /// What to do, for the loads of the body.
        advice: &'static str,
    },
    /// A linear solution that does not settle under refinement.
    #[error(
        "the solution does not settle (relative correction {correction:.1e} after refinement); the body is nearly a mechanism, or its materials or shapes have extreme ratios"
    )]
    IllConditioned {
        /// Largest correction over largest displacement.
        correction: f64,
    },
    /// A quantity asked outside the body.
    #[error("the point ({}, {}) m lies outside the body", at[0], at[1])]
    Outside {
        /// The point.
        at: [f64; 2],
    },
    /// A circumferential harmonic that is not available.
    #[error("harmonic {harmonic} of a {symmetry} body is not available: {remedy}")]
    Harmonic {
        /// Number of waves.
        harmonic: u32,
        /// Symmetry of the body.
        symmetry: &'static str,
        /// What to do.
        remedy: &'static str,
    },
    /// No instability in the given range.
    #[error(
        "the smallest eigenvalue of harmonic {harmonic} keeps its sign between load factors {low} ({at_low:.3e}) and {high} ({at_high:.3e}); widen the range"
    )]
    NoInstability {
        /// Number of waves.
        harmonic: u32,
        /// Lower factor.
        low: f64,
        /// Upper factor.
        high: f64,
        /// Eigenvalue at the lower factor.
        at_low: f64,
        /// Eigenvalue at the upper factor.
        at_high: f64,
    },
    /// An eigenvalue iteration that does not settle.
    #[error("the eigenvalue of harmonic {harmonic} did not settle in {iterations} iterations (last change {change:.1e})")]
    Eigenvalue {
        /// Number of waves.
        harmonic: u32,
        /// Iterations done.
        iterations: usize,
        /// Relative change in the last one.
        change: f64,
    },
    /// A component of a tensor that does not exist.
    #[error("the component `{found}` is not known; use rr, zz, tt or rz (planar: xx, yy, tt or xy)")]
    UnknownComponent {
        /// What was asked for.
        found: String,
    },
    /// Adaptive refinement ended before the target.
    #[error(
        "output `{output}` has an estimated relative error of {estimate:.1e} with {unknowns} unknowns, {wanted:.1e} was asked for; raise the target, or round the corner that makes the quantity infinite"
    )]
    NotReached {
        /// Output.
        output: String,
        /// Estimate reached.
        estimate: f64,
        /// Unknowns used.
        unknowns: usize,
        /// Error wanted.
        wanted: f64,
    },
    /// A reaction where nothing is held.
    #[error("boundary `{boundary}` has no reaction in this component: nothing holds it there; fix or displace it")]
    NoSupport {
        /// Boundary.
        boundary: String,
    },
    /// A force that a plate does not reach.
    #[error(
        "the plate does not press with {force:.3e} (N, planar N/m) (tried: travels up to {travel:.3e} m); give less force, or hold the body so that it resists"
    )]
    NoForce {
        /// Force wanted (N or N/m).
        force: f64,
        /// Travel tried (m).
        travel: f64,
    },
    /// Contact forces that do not settle.
    #[error("contact does not settle: {gap:.1e} m of penetration left after {rounds} rounds; load in smaller steps")]
    Contact {
        /// Deepest penetration (m).
        gap: f64,
        /// Rounds done.
        rounds: usize,
    },
}
