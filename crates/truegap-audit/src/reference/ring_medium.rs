//! The permittivity of rings that makes the flat disc conduct as its bead cells do, at the height of the beads and near it.
//!
//! Limits: rings as wide as when cold; one permittivity for all rings of one height, straight over the height.

use super::CellSlopes;
use crate::AuditError;
use crate::disc::{Fineness, Gap, Laminate, Section, field::gap_capacitance};
use truegap_core::VACUUM_PERMITTIVITY;

/// The gap of a flat disc, and permittivities relative to that of vacuum.
#[derive(Clone, Debug)]
pub(super) struct FlatRings {
    /// the electrode, as wide as heat has left it
    pub plate: Laminate,
    /// insulator below the rings, m
    pub film: f64,
    /// share of the electrode that the rings cover
    pub coverage: f64,
    /// how many
    pub zones: usize,
    /// of the insulator
    pub film_permittivity: f64,
    /// between the rings
    pub air_permittivity: f64,
    /// mesh of the section
    pub fineness: Fineness,
    /// relative error wanted of its capacitance
    pub target: f64,
}

/// Relative permittivity of a ring over its height.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct RingMedium {
    /// height of the beads, m
    pub height: f64,
    /// relative permittivity at it
    pub permittivity: f64,
    /// change of it with the height, 1/m
    pub slope: f64,
}

/// Share of its target to which a capacitance is met.
const MET: f64 = 0.2;
/// Fields after which it must be.
const ROUNDS: usize = 8;

impl RingMedium {
    /// Rings of the beads' height (m) whose flat disc has the cells' capacitance (F) there and, by its slopes, near it.
    ///
    /// # Errors
    /// What the field refuses; [`AuditError::OutOfRange`] where no permittivity does it.
    pub fn of(flat: &FlatRings, height: f64, main: f64, slopes: &CellSlopes) -> Result<Self, AuditError> {
        let permittivity = flat.permittivity(height, main, flat.film_permittivity)?;
        let [lower, higher] = [(-slopes.step, slopes.main[0]), (slopes.step, slopes.main[1])]
            .map(|(step, main)| flat.permittivity(height + step, main, permittivity));
        Ok(Self { height, permittivity, slope: (higher? - lower?) / (2.0 * slopes.step) })
    }

    /// At a height (m).
    pub fn at(&self, height: f64) -> f64 {
        self.permittivity + self.slope * (height - self.height)
    }
}

impl FlatRings {
    /// The permittivity of rings of a height (m) that gives a capacitance (F), by steps as long as parallel plates side by side would need.
    fn permittivity(&self, height: f64, wanted: f64, start: f64) -> Result<f64, AuditError> {
        let gap = Gap::Rings { height, coverage: self.coverage, zones: self.zones };
        let section = Section::new(&self.plate, &gap, Some(self.film), self.fineness)?;
        let mut permittivity = start;
        for _ in 0..ROUNDS {
            let of = |region: &str| self.of_region(region, permittivity);
            let found = gap_capacitance(&section.mesh, &of, self.target)?;
            if (found / wanted - 1.0).abs() <= MET * self.target {
                return Ok(permittivity);
            }
            permittivity += (wanted - found) / self.slope(height, permittivity);
        }
        let (what, remedy) =
            ("relative permittivity of the rings", "the cell's field cannot be that of rings; ask for a larger target");
        Err(AuditError::OutOfRange { what, value: permittivity, low: 0.0, high: f64::INFINITY, remedy })
    }

    /// Change of the capacitance with the rings' permittivity, F: field lines straight across.
    fn slope(&self, height: f64, permittivity: f64) -> f64 {
        let area = self.coverage * std::f64::consts::PI * self.plate.radius * self.plate.radius;
        let across = height + self.film * permittivity / self.film_permittivity;
        VACUUM_PERMITTIVITY * area * height / (across * across)
    }

    fn of_region(&self, region: &str, ring: f64) -> f64 {
        let relative = match region {
            "air" => self.air_permittivity,
            "facing" => self.film_permittivity,
            _ => ring,
        };
        VACUUM_PERMITTIVITY * relative
    }
}
