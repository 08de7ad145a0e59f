//! The sensor's flat layers as bonding makes them: what must follow metal in its plane grows and yields across it alone.
//!
//! Limits: thin layers between plates that stay flat; plane stress for heat, uniaxial strain for pressure.

use crate::disc::{Laminate, Sheet};
use truegap_core::{Sensor, sensor::Material};

/// Layers in whose equations bonding is included.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct BondedLayers {
    /// the sensor with the electrode's common growth in its plane, and with the growth and the modulus of the insulator on a shield
    pub sensor: Sensor,
    /// growth of the insulator behind the electrode over that of the one on a shield, 1/K
    pub backing_per_kelvin: f64,
    /// growth of the thickness of the insulator behind the electrode less that of its area, beyond what the analytic model has, 1/K
    pub behind_per_kelvin: f64,
}

impl BondedLayers {
    /// The layers of a sensor.
    pub(crate) fn of(sensor: &Sensor) -> Self {
        let (plate, film) = (Laminate::backed(sensor), Sheet::of("insulator", &sensor.insulator));
        let in_plane = plate.flat_expansion();
        let on_shield = film.held_growth(sensor.conductor.material.expansion);
        let mut bonded = sensor.clone();
        let metal = &mut bonded.conductor.material;
        *metal = Material { expansion: in_plane, ..metal.clone() };
        let insulator = &mut bonded.insulator.material;
        insulator.expansion = on_shield;
        insulator.young.value = film.held_modulus();
        Self {
            sensor: bonded,
            backing_per_kelvin: film.held_growth(in_plane) - on_shield,
            behind_per_kelvin: film.held_growth(in_plane)
                - film.expansion
                - 2.0 * (in_plane - sensor.conductor.material.expansion),
        }
    }
}
