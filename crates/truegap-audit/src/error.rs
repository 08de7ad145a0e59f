//! Why an audit has no answer.
//!
//! Limits: messages name the load and temperature, not the line of a sensor file.

use std::path::PathBuf;
use truegap_core::SimulationError;
#[cfg(feature = "fem")]
use truegap_fem::{FemError, elasticity::ElasticityError, electrostatics::ElectrostaticsError, mesh::MeshError};

/// Anything that keeps an assumption from being examined.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum AuditError {
    /// The finite elements failed.
    #[cfg(feature = "fem")]
    #[error("{problem}: {source}")]
    Fem {
        /// what was solved
        problem: String,
        /// why it failed
        source: Box<FemError>,
    },
    /// The analytic model has no answer somewhere in the range of the study.
    #[error(
        "the analytic model has no capacitance at {force_n} N and {temperature_c} degC (beads strained by {strain}); audit a smaller full_scale, or a thicker or stiffer dielectric"
    )]
    NoResponse {
        /// load, N
        force_n: f64,
        /// temperature, degrees Celsius
        temperature_c: f64,
        /// compressive strain reached; NaN where the beads have none
        strain: f64,
    },
    /// The analytic model refused.
    #[error(transparent)]
    Simulation(#[from] SimulationError),
    /// A result lies outside what a table or a bracket covers.
    #[error("{what} = {value} lies outside {low} to {high}; {remedy}")]
    OutOfRange {
        /// quantity with unit
        what: &'static str,
        /// its value
        value: f64,
        /// least value covered
        low: f64,
        /// greatest value covered
        high: f64,
        /// how to fix it
        remedy: &'static str,
    },
    /// An iteration ended before it met its target.
    #[error(
        "{what} did not converge at {at}: after {steps} steps {measure} is {left:.3e}, wanted is at most {target:.3e}; {remedy}"
    )]
    NotConverged {
        /// what was sought
        what: &'static str,
        /// where: load and temperature, or what else was given
        at: String,
        /// steps taken
        steps: usize,
        /// what tells how far it came, with unit
        measure: &'static str,
        /// its last value
        left: f64,
        /// its greatest value that would have done
        target: f64,
        /// how to fix it
        remedy: &'static str,
    },
    /// A disc without beads was asked for what only beads can carry.
    #[error("{what} needs beads below the disc, which has none; give the disc beads")]
    NoBeads {
        /// what was asked for
        what: &'static str,
    },
    /// A table of corrections does not cover the sensor.
    #[error("{what} = {value} lies outside of {low} to {high}; {remedy}")]
    Uncovered {
        /// quantity
        what: String,
        /// its value
        value: f64,
        /// least value covered
        low: f64,
        /// greatest value covered
        high: f64,
        /// how to fix it
        remedy: &'static str,
    },
    /// A table of corrections is at fault.
    #[error("the table {name} of corrections cannot be used: {problem}; make it again with the command in its file")]
    Table {
        /// table
        name: &'static str,
        /// what is wrong
        problem: String,
    },
    /// The sensor has not what was asked about.
    #[error("sensor {sensor} has no {part}; leave this assumption out for it")]
    Lacks {
        /// name of the sensor
        sensor: String,
        /// what it lacks
        part: &'static str,
    },
    /// No assumption of that name.
    #[error("there is no assumption {id}; known ones: {known}")]
    Unknown {
        /// what was asked for
        id: String,
        /// the register
        known: String,
    },
    /// The caller asked to stop.
    #[error("the audit was stopped; finished assumptions are in the cache, a second run continues from there")]
    Cancelled,
    /// The cache cannot be used.
    #[error("cache file {}: {problem}; make the folder writable, or run without a cache", path.display())]
    Cache {
        /// file
        path: PathBuf,
        /// what the system or the parser said
        problem: String,
    },
}

#[cfg(feature = "fem")]
impl AuditError {
    /// Names the problem that the finite elements failed at; for `map_err`.
    pub fn fem<E: Into<FemError>>(problem: &str) -> impl FnOnce(E) -> Self {
        let problem = problem.to_owned();
        move |source| Self::Fem { problem, source: Box::new(source.into()) }
    }
}

#[cfg(feature = "fem")]
impl From<FemError> for AuditError {
    fn from(source: FemError) -> Self {
        Self::Fem { problem: "finite elements".into(), source: Box::new(source) }
    }
}

#[cfg(feature = "fem")]
impl From<MeshError> for AuditError {
    fn from(source: MeshError) -> Self {
        Self::Fem { problem: "mesh".into(), source: Box::new(source.into()) }
    }
}

#[cfg(feature = "fem")]
impl From<ElasticityError> for AuditError {
    fn from(source: ElasticityError) -> Self {
        Self::Fem { problem: "elastic body".into(), source: Box::new(source.into()) }
    }
}

#[cfg(feature = "fem")]
impl From<ElectrostaticsError> for AuditError {
    fn from(source: ElectrostaticsError) -> Self {
        Self::Fem { problem: "electric field".into(), source: Box::new(source.into()) }
    }
}
