//! Force against strain of a bonded bead as a smooth law, shared by all assumptions that need it.
//!
//! Limits: strains up to [`Law::greatest`]; modulus and face scale the force, so one law serves every temperature.

use super::{
    geometry::Cell,
    press::{Bonding, Pressed, error_by_rim, press},
};
use crate::{error::AuditError, fit::Chebyshev, study::Study};

/// Degree of the fit of reduced load over strain.
const DEGREE: usize = 5;
/// Strain steps from rest to the greatest strain.
const STEPS: usize = 14;

/// Reduced load F / (E A) of a bead over its compressive strain.
#[derive(Clone, Debug, PartialEq)]
pub struct Law {
    /// greatest strain covered
    pub greatest: f64,
    /// what was computed
    pub pressed: Pressed,
    /// estimated relative error of the force at the greatest strain
    pub relative_error: f64,
    /// secant stiffness, reduced load / strain
    secant: Chebyshev,
}

impl Law {
    /// Computes the law of a cell up to a strain.
    ///
    /// # Errors
    /// [`AuditError::Fem`] where the bead finds no equilibrium.
    pub fn of(cell: &Cell, bonding: Bonding, greatest: f64) -> Result<Self, AuditError> {
        let mut law = Self::unjudged(cell, bonding, greatest)?;
        law.relative_error = law.relative_error.max(error_by_rim(cell, bonding, &law.pressed)?);
        Ok(law)
    }

    /// The law with the misfit of its curve as the only estimate of its error: half the work.
    pub(crate) fn unjudged(cell: &Cell, bonding: Bonding, greatest: f64) -> Result<Self, AuditError> {
        let strains: Vec<f64> = (1..=STEPS).map(|i| greatest * i as f64 / STEPS as f64).collect();
        let pressed = press(cell, bonding, &strains)?;
        let mut points = vec![(0.0, pressed.stiffness)];
        points.extend(pressed.steps.iter().map(|s| (s.strain, s.reduced_load / s.strain)));
        let secant = Chebyshev::fit(&points, DEGREE, 0.0, greatest)?;
        let relative_error = secant.misfit(&points)? / pressed.stiffness;
        Ok(Self { greatest, pressed, relative_error, secant })
    }

    /// Reduced load at a strain.
    ///
    /// # Errors
    /// [`AuditError::OutOfRange`] beyond the greatest strain.
    pub(crate) fn reduced_load(&self, strain: f64) -> Result<f64, AuditError> {
        Ok(strain * self.secant.at(strain)?)
    }

    /// Strain at a reduced load, by bisection.
    ///
    /// # Errors
    /// [`AuditError::OutOfRange`] beyond the load at the greatest strain.
    pub fn strain(&self, reduced_load: f64) -> Result<f64, AuditError> {
        let (mut low, mut high) = (0.0, self.greatest);
        let most = self.reduced_load(high)?;
        if !(reduced_load >= 0.0 && reduced_load <= most) {
            let what = "load over modulus and bead area";
            return Err(AuditError::OutOfRange {
                what,
                value: reduced_load,
                low: 0.0,
                high: most,
                remedy: "audit a smaller full_scale",
            });
        }
        while high - low > 1e-14 {
            let middle = 0.5 * (low + high);
            if middle <= low || middle >= high {
                break;
            }
            if self.reduced_load(middle)? < reduced_load { low = middle } else { high = middle }
        }
        Ok(0.5 * (low + high))
    }
}

/// The law of the sensor's bonded beads, up to the strain that free beads would reach at full load and the worse of the two temperatures.
///
/// # Errors
/// As [`Law::of`]; [`AuditError::Lacks`] without beads.
pub fn bonded_law(study: &Study<'_>) -> Result<std::sync::Arc<Law>, AuditError> {
    study.shared(|study| {
        study.keep_going()?;
        let cell = Cell::of(study.sensor)?;
        let chain = study.chain(crate::swap::Swap::none());
        let mut greatest: f64 = 0.05;
        for temperature in [study.options.cold_c, study.options.hot_c] {
            greatest = greatest.max(chain.row(study.full_n(), temperature)?.squeeze.strain);
        }
        Law::of(&cell, Bonding::Bonded, greatest)
    })
}
