//! Load and strain of one sensor's bonded beads, from the tables.
//!
//! Limits: strains up to the end of the tables.

use super::{library::Library, one_sensor::curve};
use crate::{cell::Cell, error::AuditError, fit::Chebyshev};

/// Bonded beads of one sensor.
#[derive(Clone, Debug)]
pub(super) struct BeadLaw {
    /// load over modulus, area and strain
    secant: Chebyshev,
    softest: f64,
}

impl BeadLaw {
    /// The beads of a sensor.
    ///
    /// # Errors
    /// [`AuditError::Uncovered`] beyond the tables.
    pub(super) fn of(cell: &Cell, tables: &Library) -> Result<Self, AuditError> {
        let at = [cell.shape_factor(), 1.0 - 2.0 * cell.poisson];
        let secant = curve(&tables.bead_load.given(&at)?);
        Ok(Self { softest: secant.at(0.0)?, secant })
    }

    /// Greatest strain covered.
    pub(super) fn greatest(&self) -> f64 {
        self.secant.high
    }

    /// Load over modulus and area at a strain of cold beads.
    ///
    /// # Errors
    /// [`AuditError::OutOfRange`] beyond the greatest strain.
    pub(super) fn load(&self, strain: f64) -> Result<f64, AuditError> {
        Ok(strain * self.secant.at(strain)?)
    }

    /// Load over modulus, area and strain.
    ///
    /// # Errors
    /// As [`BeadLaw::load`].
    pub(super) fn secant(&self, strain: f64) -> Result<f64, AuditError> {
        self.secant.at(strain)
    }

    /// Slope of the load over modulus and area at a strain.
    ///
    /// # Errors
    /// As [`BeadLaw::load`].
    pub(super) fn tangent(&self, strain: f64) -> Result<f64, AuditError> {
        let step = 1e-4 * self.secant.high;
        let (low, high) = ((strain - step).max(0.0), (strain + step).min(self.secant.high));
        Ok((self.load(high)? - self.load(low)?) / (high - low))
    }

    /// Strain of the warm height at a load over modulus and mean area, by Newton's method on e k(e). Heat acts through them alone: 7e-5 of the strain
    /// is what is left at 30 K.
    ///
    /// # Errors
    /// [`AuditError::Uncovered`] beyond the greatest strain.
    pub(super) fn strain(&self, reduced_load: f64) -> Result<f64, AuditError> {
        let mut strain = (reduced_load / self.softest).clamp(0.0, self.secant.high);
        for _ in 0..50 {
            let next = strain - (self.load(strain)? - reduced_load) / self.tangent(strain)?;
            if (next - strain).abs() <= 1e-12 {
                // an argument beyond the table is refused here
                self.secant.at(next)?;
                return Ok(next);
            }
            strain = if next > self.secant.high { 0.5 * (strain + self.secant.high) } else { next.max(0.0) };
        }
        let what = "load over modulus and bead area".to_owned();
        let high = self.load(self.secant.high)?;
        Err(AuditError::Uncovered { what, value: reduced_load, low: 0.0, high, remedy: "take a smaller load" })
    }
}
