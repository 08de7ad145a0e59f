//! The stack of layers: from a gap and permittivities to picofarads.
//!
//! Limits: as `model_conventions.md` has it, the bead layer is integrated first and then put in series with the polyimide.

use super::constants::{
    EPS_AIR, EPS_PA, EPS_RTV, EPS0, EXPANSION_CU, EXPANSION_PA, POISSON, REFERENCE, TAIL_LENGTH, TAIL_WIDTH, YOUNG_PA,
};
use super::{beads, field};
use crate::sensor::Sensor;
use std::f64::consts::PI;

/// What one reading depends on.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Moment {
    /// Load on the stack, N.
    pub force: f64,
    /// Temperature of the sensor, degC.
    pub temperature: f64,
    /// Compression of the beads (positive).
    pub compression: f64,
    /// Shape of the gap; its mean is that of the bead layer. `dead` in metres of air.
    pub gap: field::Gap,
    /// Permittivity of the silicone over its nominal value.
    pub silicone: f64,
    /// Permittivity of the polyimide over its nominal value.
    pub polyimide: f64,
}

/// Capacitances of the parts, pF.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Parts {
    /// Average permittivity of the bead layer.
    pub permittivity: f64,
    /// Bead layer.
    pub beads: f64,
    /// Polyimide under the electrode.
    pub polyimide: f64,
    /// Both in series.
    pub main: f64,
    /// Tail.
    pub tail: f64,
    /// All of it, with the backing and the stray capacitance.
    pub total: f64,
}

/// Electrode radius at `temperature` (degC), m.
pub fn radius(sensor: &Sensor, temperature: f64) -> f64 {
    0.5 * sensor.plate_diameter * (1.0 + EXPANSION_CU * (temperature - REFERENCE))
}

/// Average permittivity of the bead layer (20) with the spread bead area; `silicone` scales that of the silicone.
pub fn permittivity(sensor: &Sensor, temperature: f64, compression: f64, silicone: f64) -> f64 {
    let r = radius(sensor, temperature);
    let spread = 1.0 + POISSON * compression;
    let filled = beads::area(sensor, temperature) * spread * spread / (PI * r * r);
    EPS_AIR + filled * (EPS_RTV * silicone - EPS_AIR)
}

/// Capacitances at one moment; `None` where the plates touch.
pub fn parts(sensor: &Sensor, moment: &Moment, disc: &field::Disc) -> Option<Parts> {
    const PICO: f64 = 1e12;
    let r = radius(sensor, moment.temperature);
    let plate = PI * r * r;
    let permittivity = permittivity(sensor, moment.temperature, moment.compression, moment.silicone);
    let gap = field::Gap { dead: moment.gap.dead * permittivity / EPS_AIR, ..moment.gap };
    let film = sensor.height_pa * (1.0 + EXPANSION_PA * (moment.temperature - REFERENCE));
    let pressed = film * (1.0 - moment.force / (plate * YOUNG_PA));
    let eps_pa = EPS0 * EPS_PA * moment.polyimide;
    let beads = EPS0 * permittivity * plate * disc.mean_inverse(&gap, r)?;
    let polyimide = eps_pa * plate / pressed;
    let main = 1.0 / (1.0 / beads + 1.0 / polyimide);
    let tail = 2.0 * eps_pa * TAIL_LENGTH * TAIL_WIDTH / film;
    let total = main + polyimide + tail + sensor.stray;
    Some(Parts {
        permittivity,
        beads: beads * PICO,
        polyimide: polyimide * PICO,
        main: main * PICO,
        tail: tail * PICO,
        total: total * PICO,
    })
}
