//! What lies between the plates of a unit cell.
//!
//! Limits: one permittivity a material, whatever the temperature.

use truegap_core::Sensor;

/// Relative permittivities of a cell.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Filled {
    /// bead
    pub bead: f64,
    /// between the beads
    pub air: f64,
    /// film
    pub film: f64,
}

/// Relative permittivities of a sensor's cell.
pub(crate) fn filled(sensor: &Sensor) -> Filled {
    Filled {
        bead: sensor.dielectric.layer.material.permittivity,
        air: sensor.dielectric.surrounding_permittivity,
        film: sensor.insulator.material.permittivity,
    }
}
