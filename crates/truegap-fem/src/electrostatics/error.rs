//! What can be wrong with an electrostatic problem.

/// Errors of the electrostatic problem; coordinates are metres.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ElectrostaticsError {
    /// No conductor has a potential.
    #[error("no boundary has a potential; give at least one [[boundary]] a `potential`")]
    NoConductor,
    /// Every conductor has the same potential.
    #[error(
        "all conductors are at {potential} V, so there is no difference to divide the charge by; give `{boundary}` or another boundary a different potential"
    )]
    NoDifference {
        /// Common potential (V).
        potential: f64,
        /// The boundary asked about.
        boundary: String,
    },
    /// A permittivity is not positive.
    #[error("region `{region}` has the permittivity {permittivity} F/m; it must be positive and finite")]
    BadPermittivity {
        /// Region.
        region: String,
        /// Value (F/m).
        permittivity: f64,
    },
    /// A potential is not finite.
    #[error("conductor `{boundary}` has the potential {potential} V; give it a finite number")]
    BadPotential {
        /// Boundary.
        boundary: String,
        /// Value (V).
        potential: f64,
    },
    /// Two conductors that touch exchange an infinite charge.
    #[error("conductors `{a}` and `{b}` touch at ({}, {}) m, so `{output}` is infinite; leave a gap between them or give them one name", at[0], at[1])]
    Touching {
        /// Output.
        output: String,
        /// One conductor.
        a: String,
        /// The other.
        b: String,
        /// Where (m).
        at: [f64; 2],
    },
    /// Output of a boundary that carries no potential.
    #[error("boundary `{boundary}` has no potential, so it has no charge; conductors are: {known}")]
    NotAConductor {
        /// Boundary.
        boundary: String,
        /// Conductors.
        known: String,
    },
    /// The far boundary cannot be continued to infinity.
    #[error("the open boundary cannot be continued to infinity: {reason} near ({}, {}) m; {remedy}", at[0], at[1])]
    OpenBoundary {
        /// What is wrong.
        reason: &'static str,
        /// Where.
        at: [f64; 2],
        /// What to do.
        remedy: &'static str,
    },
    /// A part that no potential reaches.
    #[error(
        "region `{region}` near ({}, {}) m touches no boundary with a potential and is not joined to one that does, so its potential may be anything; join it, give one of its boundaries a `potential`, or remove it", at[0], at[1]
    )]
    Floating {
        /// Region.
        region: String,
        /// A corner of it (m).
        at: [f64; 2],
    },
    /// A point outside the mesh.
    #[error("output point ({}, {}) m lies outside the mesh; move it inside a region", at[0], at[1])]
    PointOutside {
        /// The point.
        at: [f64; 2],
    },
    /// The wanted accuracy needs more unknowns than allowed.
    #[error(
        "`{output}` has an estimated relative error of {estimate:.1e} with {unknowns} unknowns, the most allowed; wanted {wanted:.1e}: raise target_error"
    )]
    NotReached {
        /// Output.
        output: String,
        /// Estimated relative error.
        estimate: f64,
        /// Unknowns used.
        unknowns: usize,
        /// Target.
        wanted: f64,
    },
}
