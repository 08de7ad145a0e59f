//! The physics chain from what is done to a sensor to what is read, and the places where omitted physics plugs in.
//!
//! ```text
//! load ─► load path ─► ┐
//!                      ├─► beads (strain) ─► geometry ─► dielectric ─► field ─► readout ─► value
//! temperature ─► thermal path ─► ┘
//! ```
//!
//! Limits: a stage sees whole columns, in time order, and may not look at the recorded response.

use crate::inputs::Inputs;
use serde::{Deserialize, Serialize};

/// Places of the chain, in its order.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum StageName {
    /// clocks and references of the inputs
    Inputs,
    /// load path
    LoadPath,
    /// thermal path
    ThermalPath,
    /// compressible dielectric
    Beads,
    /// gap and electrode shape
    Geometry,
    /// permittivities
    Dielectric,
    /// field outside the plates
    Field,
    /// electronics
    Readout,
}

/// What drives the beads, after the load path and the thermal path.
#[derive(Clone, Copy, Debug)]
pub struct Drive<'a> {
    /// what was recorded
    pub inputs: &'a Inputs,
    /// load that arrives at the dielectric, in units of [`Drive::full_load`]; zeros where a base model has none
    pub load: &'a [f64],
    /// temperature of the sensor, degrees Celsius; the reference temperature where none was recorded
    pub temperature_c: &'a [f64],
    /// temperature at which the sensor is described, degrees Celsius
    pub reference_c: f64,
    /// full load in SI (N or Pa); `load` is relative to it
    pub full_load: f64,
}

/// Shape of the gap, a column a quantity.
#[derive(Clone, Debug)]
pub struct Geometry<'a> {
    /// compressive strain of the dielectric
    pub strain: &'a [f64],
    /// extra mean separation, as a share of the unloaded gap at the reference temperature
    pub gap: Vec<f64>,
    /// temperature difference that bends the electrode, K
    pub warp_kelvin: Vec<f64>,
    /// factor on the curvature of the electrode
    pub warp_factor: f64,
    /// slope of the gap across the plate: difference between rim and centre over the mean gap, along one diameter
    pub tilt: Vec<f64>,
    /// rim sag that the load adds to the electrode, as a share of the unloaded gap at the reference temperature (positive: rim opens, centre closes)
    pub sag: Vec<f64>,
}

/// Factors on relative permittivities.
#[derive(Clone, Debug)]
pub struct Dielectric {
    /// solid part of the compressible dielectric (beads, foam)
    pub beads: Vec<f64>,
    /// insulator in series and in the shields (polyimide)
    pub insulator: Vec<f64>,
}

/// What the field stage may use.
#[derive(Clone, Copy, Debug)]
pub struct FieldView<'a> {
    /// mean separation of the electrodes, as a share of the electrode's radius
    pub aspect: &'a [f64],
    /// compressive strain of the dielectric between them; of a given gap, its closing
    pub strain: &'a [f64],
    /// capacitance (or reading, for plates with a free gain) between the plates, without any field outside of them
    pub plates: &'a [f64],
}

/// What the readout stage may use.
#[derive(Clone, Copy, Debug)]
pub struct Readout {
    /// response without load at the reference temperature
    pub zero: f64,
    /// response at full load at the reference temperature, less `zero`
    pub span: f64,
}

impl Readout {
    /// Reading that no gain changes: 0 where readings have both signs, else the response without load.
    pub fn of_no_gain(&self) -> f64 {
        let full = self.zero + self.span;
        if self.zero.min(full) < 0.0 && self.zero.max(full) > 0.0 { 0.0 } else { self.zero }
    }
}

/// Omitted physics with its numbers filled in: each method is the identity unless the physics acts at that stage.
///
/// Columns have one entry a row of [`Drive::inputs`].
#[allow(unused_variables)]
pub trait Stage: Send + Sync {
    /// Whether the inputs are shifted against the response's clock: seconds by which the load is late, `elapsed_s` seconds after the recording's first row.
    ///
    /// On a straight line in the elapsed time: see [`Stage::shifts`].
    fn late_s(&self, elapsed_s: f64) -> f64 {
        0.0
    }
    /// The same of the recorded driver of this number: as late as the load, unless it was recorded beside the response.
    fn driver_late_s(&self, driver: usize, elapsed_s: f64) -> f64 {
        self.late_s(elapsed_s)
    }
    /// Whether the load is late anywhere: a straight line that is zero at two places is zero everywhere.
    fn shifts(&self) -> bool {
        self.late_s(0.0) != 0.0 || self.late_s(1.0) != 0.0
    }
    /// The same physics in a recording that begins after so many runs of others; `None` where the number of a run plays no part.
    fn after_runs(&self, runs: usize) -> Option<Box<dyn Stage>> {
        None
    }
    /// Load path: turns recorded load into load on the dielectric, in units of `full_load`.
    fn load(&self, inputs: &Inputs, load: &mut [f64]) {}
    /// Whether [`Stage::feedback`] acts.
    fn feeds_back(&self) -> bool {
        false
    }
    /// Load that the model's own response takes from what acts on it or adds to it, in units of `full_load`: for base models that say
    /// [`Simulator::feeds_back`](crate::Simulator::feeds_back).
    fn feedback(&self, drive: &Drive<'_>, response: &[f64], load: &mut [f64]) {}
    /// Thermal path: turns the thermometer's reading into the sensor's temperature, degrees Celsius.
    fn thermal(&self, inputs: &Inputs, temperature_c: &mut [f64]) {}
    /// Beads: factor on the Young's modulus, before the strain is known.
    fn modulus(&self, drive: &Drive<'_>, factor: &mut [f64]) {}
    /// Beads: stress at strain e is multiplied by `1 + a e + b e^2`; returns `[a, b]`.
    fn stiffening(&self) -> [f64; 2] {
        [0.0, 0.0]
    }
    /// Beads: turns elastic strain into strain with a history.
    fn strain(&self, drive: &Drive<'_>, strain: &mut [f64]) {}
    /// Geometry of gap and electrode.
    fn geometry(&self, drive: &Drive<'_>, geometry: &mut Geometry<'_>) {}
    /// Permittivities.
    fn dielectric(&self, drive: &Drive<'_>, factors: &mut Dielectric) {}
    /// Field outside the plates: adds to `extra`, in the unit of `view.plates`.
    fn field(&self, drive: &Drive<'_>, view: &FieldView<'_>, extra: &mut [f64]) {}
    /// Readout: turns the true value into the recorded one, in the response's unit.
    fn readout(&self, drive: &Drive<'_>, readout: &Readout, value: &mut [f64]) {}
}

#[cfg(test)]
mod tests {
    use super::Readout;

    #[test]
    fn a_gain_leaves_0_alone_where_readings_have_both_signs() {
        for (zero, span, exact) in [(-2.0, 5.0, 0.0), (3.0, -4.0, 0.0), (1.0, 4.0, 1.0), (-5.0, 4.0, -5.0), (0.0, 1.0, 0.0)] {
            assert_eq!(Readout { zero, span }.of_no_gain(), exact);
        }
    }
}
