//! The permittivity of rings that makes the flat disc conduct as its bead cells do, at the height of the beads and near it.
//!
//! Limits: rings as wide as when cold; one permittivity for all rings of one height, straight over the height.

use super::cells::CellSlopes;
use crate::disc::{Fineness, Gap, Laminate, Section, gap_capacitance};
use crate::error::AuditError;
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
    /// What the field refuses; [`AuditError::NotConverged`] where no permittivity does it.
    pub(super) fn of(flat: &FlatRings, height: f64, main: f64, slopes: &CellSlopes) -> Result<Self, AuditError> {
        let permittivity = flat.permittivity(height, main, flat.film_permittivity)?;
        let [lower, higher] = [(-slopes.step, slopes.main[0]), (slopes.step, slopes.main[1])]
            .map(|(step, main)| flat.permittivity(height + step, main, permittivity));
        Ok(Self { height, permittivity, slope: (higher? - lower?) / (2.0 * slopes.step) })
    }

    /// At a height (m).
    pub(super) fn at(&self, height: f64) -> f64 {
        self.permittivity + self.slope * (height - self.height)
    }
}

impl FlatRings {
    /// The permittivity of rings of a height (m) that gives a capacitance (F).
    fn permittivity(&self, height: f64, wanted: f64, start: f64) -> Result<f64, AuditError> {
        let gap = Gap::Rings { height, coverage: self.coverage, zones: self.zones };
        let section = Section::new(&self.plate, &gap, Some(self.film), self.fineness)?;
        let capacitance = |permittivity| {
            let of = |region: &str| self.of_region(region, permittivity);
            gap_capacitance(&section.mesh, &of, self.target)
        };
        self.meeting(height, wanted, start, capacitance)
    }

    /// The permittivity at which `capacitance` is the wanted one (F), by steps as long as parallel plates side by side would need.
    fn meeting(
        &self,
        height: f64,
        wanted: f64,
        start: f64,
        capacitance: impl Fn(f64) -> Result<f64, AuditError>,
    ) -> Result<f64, AuditError> {
        let (mut permittivity, mut left) = (start, f64::INFINITY);
        for _ in 0..ROUNDS {
            let found = capacitance(permittivity)?;
            left = (found / wanted - 1.0).abs();
            if left <= MET * self.target {
                return Ok(permittivity);
            }
            permittivity += (wanted - found) / self.slope(height, permittivity);
        }
        Err(AuditError::NotConverged {
            what: "the relative permittivity of the rings",
            at: format!("{height:.4e} m and {wanted:.4e} F"),
            steps: ROUNDS,
            measure: "the relative error of the capacitance",
            left,
            target: MET * self.target,
            remedy: "the cell's field cannot be that of rings; ask for a larger target",
        })
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

#[cfg(test)]
mod tests {
    use super::*;
    use truegap_core::sensor::builtin_sensor;

    #[test]
    fn a_capacitance_that_no_permittivity_gives_is_not_converged() {
        let sensor = builtin_sensor("singletact-s15-4.5n").unwrap().unwrap();
        let flat = FlatRings {
            plate: Laminate::backed(&sensor),
            film: 25e-6,
            coverage: 0.15,
            zones: 2,
            film_permittivity: 3.4,
            air_permittivity: 1.0,
            fineness: Fineness { columns: 12, rows: 1 },
            target: 1e-2,
        };
        // the film below the rings lets no more through
        let found = flat.meeting(162e-6, 1e-12, 3.4, |_| Ok(0.75e-12));
        let Err(AuditError::NotConverged { steps, left, target, .. }) = found else { panic!("{found:?}") };
        assert_eq!((steps, target), (ROUNDS, MET * flat.target));
        assert!((left - 0.25).abs() < 1e-12, "{left}");
        let straight = |permittivity: f64| Ok(1e-12 * permittivity / 3.5);
        assert!((flat.meeting(162e-6, 1e-12, 3.5, straight).unwrap() - 3.5).abs() < 1e-12);
    }
}
