//! The beads as springs: the modulus with which a ring or layer of them answers at one load and temperature.
//!
//! Secant moduli: right for the mean strain; rings that are loaded differently share one modulus.

use crate::error::AuditError;
use std::f64::consts::PI;
use truegap_core::{Sensor, sensor::Filling};
use truegap_model::stack::{Device, Warm};

/// Beads at one load and temperature.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BeadSpring {
    /// modulus of the bead material that gives the bead's shortening, per undeformed bead area and height, Pa
    pub young: f64,
    /// share of the electrode that the beads cover, undeformed
    pub coverage: f64,
    /// height, m
    pub height: f64,
    /// linear thermal expansion, 1/K
    pub expansion: f64,
}

impl BeadSpring {
    /// The beads of a sensor under a force (N); `strain` is their force-strain law, (12) for the paper's.
    ///
    /// # Errors
    /// What the law refuses.
    pub fn new(
        sensor: &Sensor,
        warm: &Warm,
        force_n: f64,
        strain: impl Fn(&Warm, f64) -> Result<f64, AuditError>,
    ) -> Result<Self, AuditError> {
        let layer = &sensor.dielectric.layer;
        let expansion = layer.material.expansion;
        let grown = 1.0 + expansion * warm.kelvin;
        // At rest the secant is the tangent: a force so small that the law is straight.
        let probe = if force_n.abs() > 1e-6 * sensor.full_scale { force_n } else { 1e-6 * sensor.full_scale };
        let e = strain(warm, probe)?;
        let radius = 0.5 * sensor.diameter.value;
        let coverage = match sensor.dielectric.filling {
            Filling::Beads { count, diameter } => f64::from(count) * diameter.value * diameter.value / (4.0 * radius * radius),
            Filling::Solid { coverage } => coverage,
        };
        Ok(Self {
            young: probe / (coverage * PI * radius * radius * e * grown),
            coverage,
            height: layer.thickness.value,
            expansion,
        })
    }

    /// The paper's beads.
    ///
    /// # Errors
    /// [`AuditError::NoResponse`] where the load closes the gap.
    pub(crate) fn of_paper(sensor: &Sensor, device: &Device, warm: &Warm, force_n: f64) -> Result<Self, AuditError> {
        Self::new(sensor, warm, force_n, |warm, force| {
            device.strain(warm, force, 1.0, [0.0; 2]).map_err(|_| AuditError::NoResponse {
                force_n: force,
                temperature_c: device.reference_c + warm.kelvin,
                strain: 1.0,
            })
        })
    }

    /// Stiffness per electrode area, Pa/m.
    pub fn stiffness(&self) -> f64 {
        self.young * self.coverage / self.height
    }

    /// Zones of one bead pitch each, from the axis to the rim.
    pub fn zones(sensor: &Sensor) -> usize {
        match sensor.dielectric.filling {
            // Pitch sqrt(A / N) against the radius sqrt(A / pi).
            Filling::Beads { count, .. } => (f64::from(count) / PI).sqrt().round().max(1.0) as usize,
            Filling::Solid { .. } => 1,
        }
    }
}
