//! Axisymmetric and planar finite elements: meshing, quadratic spaces, sparse assembly and direct solvers,
//! with electrostatics and thermoelasticity built on them.
//!
//! The crate knows no sensor: it takes outlines, materials and boundary conditions. Everything inside is SI
//! (metres, volts, pascals); text with units exists only in case files. Sizes are those of two-dimensional
//! problems (a few million unknowns on one machine).

// Comparisons are written so that NaN falls on the refusing side.
#![allow(clippy::neg_cmp_op_on_partial_ord)]

pub mod adapt;
pub mod assembly;
pub mod case;
pub mod error;
pub mod io;
pub mod mesh;
pub mod physics;
pub mod problems;
pub mod solve;
pub mod space;

pub use error::FemError;

/// Which body a two-dimensional mesh stands for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Symmetry {
    /// Coordinates are (r, z); integrals carry 2 pi r.
    Axisymmetric,
    /// Coordinates are (x, y); integrals are per metre of depth.
    Planar,
}

impl Symmetry {
    /// Weight of a quadrature point at the first coordinate `r` (m): 2 pi r, or 1.
    #[inline]
    pub fn weight(self, r: f64) -> f64 {
        match self {
            Symmetry::Axisymmetric => std::f64::consts::TAU * r,
            Symmetry::Planar => 1.0,
        }
    }
}
