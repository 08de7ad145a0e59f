//! The sensor: what a maker can vary, with the tolerances of `reference/model_conventions.md`.
//!
//! Limits: constants of Table 1 are shared by all sensors; only the nine toleranced values differ from sensor to sensor.

use crate::draws::Draws;
use serde::{Deserialize, Serialize};

/// Standard deviations beyond which no sensor leaves the maker (drawn again).
const TRUNCATION: f64 = 2.0;

/// A sensor; SI units.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Sensor {
    /// Young's modulus of the silicone at 20 degC, Pa.
    pub young_rtv: f64,
    /// Change of that modulus with temperature, Pa/K.
    pub softening: f64,
    /// Height of the beads, m.
    pub height_rtv: f64,
    /// Copper thickness, m.
    pub height_cu: f64,
    /// Tin thickness, m.
    pub height_sn: f64,
    /// Polyimide thickness, m.
    pub height_pa: f64,
    /// Bead diameter, m.
    pub bead_diameter: f64,
    /// Electrode diameter, m.
    pub plate_diameter: f64,
    /// Stray capacitance, F.
    pub stray: f64,
    /// Number of beads.
    pub beads: f64,
}

/// One toleranced value of a sensor.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Toleranced {
    /// `young_rtv`, 5 %.
    Young,
    /// `softening`, 15 %.
    Softening,
    /// `height_rtv`, 5 um.
    Beads,
    /// `height_cu`, 5 %.
    Copper,
    /// `height_sn`, 5 %.
    Tin,
    /// `height_pa`, 3 %.
    Polyimide,
    /// `bead_diameter`, 2 %.
    BeadDiameter,
    /// `plate_diameter`, 25 um.
    Plate,
    /// `stray`, 0.3 pF.
    Stray,
}

impl Toleranced {
    /// All of them, in a fixed order.
    pub const ALL: [Self; 9] = [
        Self::Young,
        Self::Softening,
        Self::Beads,
        Self::Copper,
        Self::Tin,
        Self::Polyimide,
        Self::BeadDiameter,
        Self::Plate,
        Self::Stray,
    ];
}

impl Sensor {
    /// The built-in `singletact-s15-4.5n` at its nominal values.
    pub fn singletact_s15() -> Self {
        Self {
            young_rtv: 1.075e6,
            softening: -7.6e3,
            height_rtv: 162e-6,
            height_cu: 34e-6,
            height_sn: 5e-6,
            height_pa: 25e-6,
            bead_diameter: 700e-6,
            plate_diameter: 15e-3,
            stray: 0.0,
            beads: 65.0,
        }
    }

    /// One standard deviation of `what` about this (nominal) sensor, in the value's own unit.
    pub fn tolerance(&self, what: Toleranced) -> f64 {
        match what {
            Toleranced::Young => 0.05 * self.young_rtv,
            Toleranced::Softening => 0.15 * self.softening.abs(),
            Toleranced::Beads => 5e-6,
            Toleranced::Copper => 0.05 * self.height_cu,
            Toleranced::Tin => 0.05 * self.height_sn,
            Toleranced::Polyimide => 0.03 * self.height_pa,
            Toleranced::BeadDiameter => 0.02 * self.bead_diameter,
            Toleranced::Plate => 25e-6,
            Toleranced::Stray => 0.3e-12,
        }
    }

    /// The same sensor with one value moved by `by`, in the value's own unit.
    pub fn moved(&self, what: Toleranced, by: f64) -> Self {
        let mut sensor = self.clone();
        let value = match what {
            Toleranced::Young => &mut sensor.young_rtv,
            Toleranced::Softening => &mut sensor.softening,
            Toleranced::Beads => &mut sensor.height_rtv,
            Toleranced::Copper => &mut sensor.height_cu,
            Toleranced::Tin => &mut sensor.height_sn,
            Toleranced::Polyimide => &mut sensor.height_pa,
            Toleranced::BeadDiameter => &mut sensor.bead_diameter,
            Toleranced::Plate => &mut sensor.plate_diameter,
            Toleranced::Stray => &mut sensor.stray,
        };
        *value += by;
        sensor
    }

    /// A sensor from the line: every toleranced value normal about this one, drawn again beyond two standard deviations.
    pub fn drawn(&self, draws: &mut Draws) -> Self {
        Toleranced::ALL
            .iter()
            .fold(self.clone(), |sensor, &what| sensor.moved(what, self.tolerance(what) * draws.truncated_normal(TRUNCATION)))
    }
}
