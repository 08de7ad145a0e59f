//! Rings that push but do not pull, and the load plate that carries a given force.
//!
//! A ring lets go as a whole; friction is not limited where it holds.

use super::Disc;
use super::body::{Bent, Loading};
use crate::AuditError;
use truegap_fem::physics::elasticity::Component;

/// How the plate rests on the beads.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Bond {
    /// bonded: beads push and pull
    Bonded,
    /// touching: beads only push
    Touching,
}

/// A bent disc and the rings that carry it.
#[derive(Clone, Debug)]
pub struct Carried {
    /// the disc
    pub bent: Bent,
    /// rings that push (or pull, if bonded)
    pub attached: Vec<bool>,
    /// force of each ring on the plate, N, positive in compression; empty where the beads are one layer
    pub forces: Vec<f64>,
}

impl Disc {
    /// Equilibrium under a loading; touching rings that would pull are let go, those that would be passed are taken back.
    ///
    /// # Errors
    /// Where Newton's method finds no equilibrium, or the set of touching rings does not settle.
    pub fn carried(&self, kelvin: f64, loading: Loading, bond: Bond) -> Result<Carried, AuditError> {
        let rings = self.section.rings.len();
        let mut attached = vec![true; rings];
        for _ in 0..(2 * rings + 2) {
            let bent = self.solve(kelvin, loading, &attached)?;
            let forces = self.forces(&bent, &attached)?;
            let next = if bond == Bond::Bonded { attached.clone() } else { self.touching(&bent, kelvin, &attached, &forces)? };
            if next == attached {
                return Ok(Carried { bent, attached, forces });
            }
            if !next.contains(&true) {
                return Err(AuditError::OutOfRange {
                    what: "rings of beads that carry the plate",
                    value: 0.0,
                    low: 1.0,
                    high: rings as f64,
                    remedy: "load the plate, or take the free plate",
                });
            }
            attached = next;
        }
        Err(AuditError::OutOfRange {
            what: "rounds of beads letting go and touching again",
            value: (2 * rings + 2) as f64,
            low: 0.0,
            high: (2 * rings + 1) as f64,
            remedy: "give the load in another form, or more zones",
        })
    }

    /// Equilibrium under a rigid plate that carries `force_n`, to one part in a thousand.
    ///
    /// # Errors
    /// As [`Disc::carried`].
    pub fn pressed(&self, kelvin: f64, force_n: f64, bond: Bond) -> Result<Carried, AuditError> {
        let Some(beads) = self.beads else {
            return Err(AuditError::OutOfRange {
                what: "beads below a loaded plate",
                value: 0.0,
                low: 1.0,
                high: 1.0,
                remedy: "give the disc beads",
            });
        };
        let area = std::f64::consts::PI * self.plate.radius * self.plate.radius;
        let flat = force_n / (area * beads.stiffness()) - beads.expansion * kelvin * beads.height;
        // Where the plate carries nothing yet: above the rim of the free shape.
        let sag = self.plate.free_sag(kelvin).abs();
        let (mut low, mut high) = ((flat - 2.0 * sag - 0.5 * flat.abs(), 0.0), (f64::NAN, f64::NAN));
        let mut travel = flat;
        for _ in 0..12 {
            let carried = self.carried(kelvin, Loading::Plate(travel), bond)?;
            let found = carried.bent.plate_force;
            if (found / force_n - 1.0).abs() < 1e-3 {
                return Ok(carried);
            }
            if found < force_n {
                low = (travel, found)
            } else {
                high = (travel, found)
            }
            travel = if high.0.is_nan() {
                travel + (force_n - found) / (area * beads.stiffness())
            } else {
                let secant = low.0 + (force_n - low.1) * (high.0 - low.0) / (high.1 - low.1);
                secant.clamp(low.0 + 0.02 * (high.0 - low.0), high.0 - 0.02 * (high.0 - low.0))
            };
        }
        Err(AuditError::OutOfRange {
            what: "travel of the load plate in m",
            value: travel,
            low: low.0,
            high: high.0,
            remedy: "the force does not settle; use an even load",
        })
    }

    fn forces(&self, bent: &Bent, attached: &[bool]) -> Result<Vec<f64>, AuditError> {
        let force = |(j, &on): (usize, &bool)| {
            if !on {
                return Ok(0.0);
            }
            bent.solution.reaction(&format!("foot {}", j + 1), Component::Second).map_err(AuditError::fem("force of a ring"))
        };
        attached.iter().enumerate().map(force).collect()
    }

    /// Rings that touch: attached ones that push, and free ones whose top would be passed.
    fn touching(&self, bent: &Bent, kelvin: f64, attached: &[bool], forces: &[f64]) -> Result<Vec<bool>, AuditError> {
        let profile = self.profile(bent)?;
        let grown = self.beads.map_or(0.0, |b| b.expansion * kelvin * b.height);
        let state = |j: usize| {
            if attached[j] {
                return forces[j] > 0.0;
            }
            let ring = self.section.rings[j];
            let lowest =
                [ring.inner, ring.outer].map(|r| profile.height(r / self.plate.radius)).into_iter().fold(f64::INFINITY, f64::min);
            lowest < grown
        };
        Ok((0..attached.len()).map(state).collect())
    }
}
