//! The parameters of the stack: which toleranced quantity of the sensor each one is.
//!
//! Limits: independent Gaussian tolerances.

use super::options::StackOptions;
use truegap_core::{Measure, Parameter, Sensor, sensor::Filling};

/// Farad in a picofarad.
const PICO: f64 = 1e-12;

/// A quantity that calibration may adjust.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Knob {
    Young,
    Softening,
    Height,
    Conductor,
    Plating,
    Insulator,
    BeadDiameter,
    ElectrodeDiameter,
    Stray,
}

/// Name, unit and meaning of each knob.
const KNOBS: [(Knob, &str, &str, &str); 9] = [
    (Knob::Young, "young_rtv", "Pa", "Young's modulus of the silicone at the reference temperature"),
    (Knob::Softening, "softening_rtv", "Pa/K", "change of the silicone's Young's modulus with temperature"),
    (Knob::Height, "height_rtv", "m", "height of the compressible dielectric"),
    (Knob::Conductor, "thickness_copper", "m", "thickness of the electrode's conductor"),
    (Knob::Plating, "thickness_tin", "m", "thickness of the electrode's plating"),
    (Knob::Insulator, "thickness_polyimide", "m", "thickness of the insulator"),
    (Knob::BeadDiameter, "bead_diameter", "m", "diameter of a bead"),
    (Knob::ElectrodeDiameter, "electrode_diameter", "m", "diameter of the electrodes"),
    (Knob::Stray, "stray_capacitance", "pF", "capacitance beside the sensor"),
];

/// Knobs and parameters of a sensor: those with a tolerance that do something.
pub(super) fn of(sensor: &Sensor, options: StackOptions) -> (Vec<Knob>, Vec<Parameter>) {
    let toleranced = |&(knob, name, unit, meaning): &(Knob, &str, &str, &str)| {
        let measure = knob.measure(sensor, options).filter(|m| m.sd > 0.0)?;
        let scale = if knob == Knob::Stray { PICO } else { 1.0 };
        let parameter = Parameter::normal(name, unit, measure.value / scale, measure.sd / scale, meaning);
        Some((knob, if knob.is_positive() { positive(parameter, measure.value) } else { parameter }))
    };
    KNOBS.iter().filter_map(toleranced).unzip()
}

/// Held within a factor of a hundred of its nominal value: beyond, it is another sensor.
fn positive(parameter: Parameter, nominal: f64) -> Parameter {
    parameter.within(0.01 * nominal, 100.0 * nominal)
}

impl Knob {
    fn is_positive(self) -> bool {
        !matches!(self, Self::Softening | Self::Stray)
    }

    /// What the sensor says about the quantity; `None` where it has none or where it does nothing.
    fn measure(self, sensor: &Sensor, options: StackOptions) -> Option<Measure> {
        let rubber = &sensor.dielectric.layer;
        let warps = options.warp && sensor.plating.is_some();
        match self {
            Self::Young => Some(rubber.material.young),
            Self::Softening => Some(rubber.material.softening),
            Self::Height => Some(rubber.thickness),
            Self::Conductor => warps.then_some(sensor.conductor.thickness),
            Self::Plating => sensor.plating.as_ref().filter(|_| warps).map(|p| p.thickness),
            Self::Insulator => Some(sensor.insulator.thickness),
            Self::BeadDiameter => match sensor.dielectric.filling {
                Filling::Beads { diameter, .. } => Some(diameter),
                Filling::Solid { .. } => None,
            },
            Self::ElectrodeDiameter => Some(sensor.diameter),
            Self::Stray => Some(sensor.stray),
        }
    }

    /// Puts a value, in the parameter's unit, into a sensor.
    pub(super) fn set(self, sensor: &mut Sensor, value: f64) {
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
            Self::BeadDiameter => {
                if let Filling::Beads { diameter, .. } = &mut sensor.dielectric.filling {
                    diameter.value = value;
                }
            }
            Self::ElectrodeDiameter => sensor.diameter.value = value,
            Self::Stray => sensor.stray.value = value * PICO,
        }
    }
}
