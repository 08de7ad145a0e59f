//! What a maker chooses about a sensor, and cannot hold exactly.
//!
//! Limits: the quantities of the paper's Table 2 that its equations contain, plus thermal softening and stray capacitance; L1 enters no equation.

use serde::{Deserialize, Serialize};
use std::fmt;
use truegap_core::{Sensor, sensor::Filling, units::Measure};

/// A quantity of the design.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Quantity {
    /// Young's modulus of the silicone, Pa
    Young,
    /// its change with temperature, Pa/K
    Softening,
    /// height of the beads, m
    Height,
    /// thickness of the copper, m
    Conductor,
    /// thickness of the tin, m
    Plating,
    /// thickness of the polyimide, m
    Insulator,
    /// diameter of a bead, m
    BeadDiameter,
    /// number of beads; read and set as a real number through the area of all beads
    BeadCount,
    /// diameter of the electrode, m
    Diameter,
    /// capacitance beside the sensor, F
    Stray,
}

/// All quantities. The diameter of a bead comes before the number: setting both in this order sets both.
pub const QUANTITIES: [Quantity; 10] = [
    Quantity::Young,
    Quantity::Softening,
    Quantity::Height,
    Quantity::Conductor,
    Quantity::Plating,
    Quantity::Insulator,
    Quantity::BeadDiameter,
    Quantity::BeadCount,
    Quantity::Diameter,
    Quantity::Stray,
];

impl Quantity {
    /// Name as in files and on the command line.
    pub fn name(self) -> &'static str {
        match self {
            Self::Young => "young",
            Self::Softening => "softening",
            Self::Height => "height",
            Self::Conductor => "conductor",
            Self::Plating => "plating",
            Self::Insulator => "insulator",
            Self::BeadDiameter => "bead_diameter",
            Self::BeadCount => "bead_count",
            Self::Diameter => "diameter",
            Self::Stray => "stray",
        }
    }

    /// In words.
    pub fn says(self) -> &'static str {
        match self {
            Self::Young => "modulus of the silicone",
            Self::Softening => "softening of the silicone",
            Self::Height => "height of the beads",
            Self::Conductor => "thickness of the copper",
            Self::Plating => "thickness of the tin",
            Self::Insulator => "thickness of the polyimide",
            Self::BeadDiameter => "diameter of a bead",
            Self::BeadCount => "number of beads",
            Self::Diameter => "diameter of the electrode",
            Self::Stray => "stray capacitance",
        }
    }

    /// The quantity of a name.
    pub fn named(name: &str) -> Option<Self> {
        QUANTITIES.into_iter().find(|q| q.name() == name)
    }

    /// The paper's symbol.
    pub fn symbol(self) -> &'static str {
        match self {
            Self::Young => "E_RTV",
            Self::Softening => "K_SE",
            Self::Height => "h_RTV",
            Self::Conductor => "h_Cu",
            Self::Plating => "h_Sn",
            Self::Insulator => "h_PA",
            Self::BeadDiameter => "L_2",
            Self::BeadCount => "N",
            Self::Diameter => "D",
            Self::Stray => "C_stray",
        }
    }

    /// Unit for people, and its factor from SI.
    pub fn unit(self) -> (&'static str, f64) {
        match self {
            Self::Young => ("MPa", 1e-6),
            Self::Softening => ("kPa/K", 1e-3),
            Self::Diameter => ("mm", 1e3),
            Self::BeadCount => ("", 1.0),
            Self::Stray => ("pF", 1e12),
            _ => ("um", 1e6),
        }
    }

    /// Value and spread in a sensor; `None` where the sensor has no such part.
    pub fn of(self, sensor: &Sensor) -> Option<Measure> {
        let rubber = &sensor.dielectric.layer;
        match self {
            Self::Young => Some(rubber.material.young),
            Self::Softening => Some(rubber.material.softening),
            Self::Height => Some(rubber.thickness),
            Self::Conductor => Some(sensor.conductor.thickness),
            Self::Plating => sensor.plating.as_ref().map(|plating| plating.thickness),
            Self::Insulator => Some(sensor.insulator.thickness),
            Self::BeadDiameter => beads(sensor).map(|(_, diameter)| diameter),
            Self::BeadCount => beads(sensor).map(|(count, _)| Measure::exact(f64::from(count))),
            Self::Diameter => Some(sensor.diameter),
            Self::Stray => Some(sensor.stray),
        }
    }

    /// Puts a value in; nothing happens where the sensor has no such part. A number of beads changes the area of all beads in proportion.
    pub fn set(self, sensor: &mut Sensor, value: f64) {
        let rubber = &mut sensor.dielectric.layer;
        match self {
            Self::Young => rubber.material.young.value = value,
            Self::Softening => rubber.material.softening.value = value,
            Self::Height => rubber.thickness.value = value,
            Self::Conductor => sensor.conductor.thickness.value = value,
            Self::Plating => {
                if let Some(plating) = &mut sensor.plating {
                    plating.thickness.value = value;
                }
            }
            Self::Insulator => sensor.insulator.thickness.value = value,
            Self::Diameter => sensor.diameter.value = value,
            Self::Stray => sensor.stray.value = value,
            Self::BeadDiameter | Self::BeadCount => {
                if let Filling::Beads { count, diameter } = &mut sensor.dielectric.filling {
                    let scaled = || diameter.value * (value / f64::from(*count)).sqrt();
                    diameter.value = if self == Self::BeadDiameter { value } else { scaled() };
                }
            }
        }
    }
}

impl Quantity {
    /// Puts a spread in (one standard deviation, SI); nothing happens where the sensor has no such part, or beads are counted.
    pub fn set_spread(self, sensor: &mut Sensor, sd: f64) {
        let rubber = &mut sensor.dielectric.layer;
        let measure = match self {
            Self::Young => Some(&mut rubber.material.young),
            Self::Softening => Some(&mut rubber.material.softening),
            Self::Height => Some(&mut rubber.thickness),
            Self::Conductor => Some(&mut sensor.conductor.thickness),
            Self::Plating => sensor.plating.as_mut().map(|plating| &mut plating.thickness),
            Self::Insulator => Some(&mut sensor.insulator.thickness),
            Self::Diameter => Some(&mut sensor.diameter),
            Self::Stray => Some(&mut sensor.stray),
            Self::BeadCount => None,
            Self::BeadDiameter => match &mut sensor.dielectric.filling {
                Filling::Beads { diameter, .. } => Some(diameter),
                Filling::Solid { .. } => None,
            },
        };
        if let Some(measure) = measure {
            measure.sd = sd;
        }
    }
}

fn beads(sensor: &Sensor) -> Option<(u32, Measure)> {
    match sensor.dielectric.filling {
        Filling::Beads { count, diameter } => Some((count, diameter)),
        Filling::Solid { .. } => None,
    }
}

impl fmt::Display for Quantity {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::metrics::{MetricOptions, metrics};
    use truegap_core::sensor::builtin_sensors;

    #[test]
    fn a_real_number_of_beads_agrees_with_a_counted_one() {
        let sensor = builtin_sensors()[0].sensor().unwrap();
        let (mut counted, mut scaled) = (sensor.clone(), sensor);
        let Filling::Beads { count, .. } = &mut counted.dielectric.filling else { panic!("the default has beads") };
        *count = 70;
        Quantity::BeadCount.set(&mut scaled, 70.0);
        let [a, b] = [counted, scaled].map(|s| metrics(&s, MetricOptions::default()).unwrap());
        a.0.iter().zip(b.0).for_each(|(a, b)| approx::assert_relative_eq!(*a, b, max_relative = 1e-9));
    }

    #[test]
    fn what_is_set_is_read_back() {
        let sensor = builtin_sensors()[0].sensor().unwrap();
        for quantity in QUANTITIES.into_iter().filter(|&q| q != Quantity::BeadCount) {
            let mut changed = sensor.clone();
            quantity.set(&mut changed, 1.25e-4);
            assert_eq!(quantity.of(&changed).unwrap().value, 1.25e-4, "{quantity}");
            assert_ne!(sensor, changed);
        }
    }
}
