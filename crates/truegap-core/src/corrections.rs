//! What finite elements say of one sensor, as curves without a free number: handed from whoever computes them to whoever needs them.
//!
//! Limits: plain data; nothing here knows where the curves come from. Shielded sensors with bonded beads.

use crate::curve::{Curve, CurveError};
use serde::{Deserialize, Serialize};

/// Corrections of one sensor.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Corrections {
    /// name of the sensor
    pub sensor: String,
    /// see [`Corrections::stiffening`]
    pub stiffening: Curve,
    /// see [`Corrections::bonded_strain`]
    pub bonded_strain: Curve,
    /// see [`Corrections::mixing`]
    pub mixing: Curve,
    /// see [`Corrections::fringing`]
    pub fringing: Curve,
    /// gain of the gap without load, over kelvins above the reference; see [`Corrections::warp`]
    pub warp: Curve,
    /// share of it that is left, over load / full load
    pub warp_left: Curve,
    /// capacitance that the field at the edges of the tail adds, the same at every load, pF
    pub tail_edge_pf: f64,
    /// see [`Corrections::held_growth`]
    pub held_growth_per_kelvin: f64,
    /// see [`Corrections::insulator_growth`]
    pub insulator_growth_per_kelvin: f64,
}

impl Corrections {
    /// Every curve.
    pub fn curves(&self) -> [&Curve; 6] {
        [&self.stiffening, &self.bonded_strain, &self.mixing, &self.fringing, &self.warp, &self.warp_left]
    }

    /// Whether the samples make curves; to be asked of what was read from a file.
    ///
    /// # Errors
    /// [`CurveError`] of the first that do not.
    pub fn check(&self) -> Result<(), CurveError> {
        self.curves().into_iter().try_for_each(Curve::check)
    }

    /// Stress of bonded beads over that of beads that slide on the plates, at one compressive strain of the warm, unloaded height.
    pub fn stiffening(&self, strain: f64) -> f64 {
        self.stiffening.at(strain)
    }

    /// Strain of bonded beads under the load that would bring sliding ones to `free_strain`; what [`crate::Stage::strain`] needs.
    pub fn bonded_strain(&self, free_strain: f64) -> f64 {
        self.bonded_strain.at(free_strain)
    }

    /// Capacitance of the gap with the field around bulging beads over that of beads and air side by side, at one strain of bonded beads,
    /// without what heat has added to their height.
    pub fn mixing(&self, strain: f64) -> f64 {
        self.mixing.at(strain)
    }

    /// Capacitance that the field at all rims of the disc adds, over that of the gap; `aspect` as in [`crate::FieldView`].
    pub fn fringing(&self, aspect: f64) -> f64 {
        self.fringing.at(aspect)
    }

    /// Capacitance of the gap with what is left of the warp on bonded beads over that of flat plates, so many kelvin above the reference; `load` over the
    /// full one, below a rigid plate.
    pub fn warp(&self, kelvin: f64, load: f64) -> f64 {
        1.0 + (self.warp.at(kelvin) - 1.0) * self.warp_left.at(load)
    }

    /// [`Corrections::warp`] for many rows, to the last bit.
    pub fn warps(&self) -> impl Fn(f64, f64) -> f64 + '_ {
        let [warp, left] = [&self.warp, &self.warp_left].map(Curve::smooth);
        move |kelvin, load| 1.0 + (warp.at(kelvin) - 1.0) * left.at(load)
    }

    /// Growth of the height of held beads over that of free ones, 1/K: `strain -= held_growth x (temperature - reference)`.
    pub fn held_growth(&self) -> f64 {
        self.held_growth_per_kelvin
    }

    /// Growth of the thickness of a bonded insulator less that of the electrode's area, beyond free growth, 1/K: factor on
    /// [`crate::Dielectric::insulator`] of `1 / (1 + insulator_growth x (temperature - reference))`.
    pub fn insulator_growth(&self) -> f64 {
        self.insulator_growth_per_kelvin
    }
}
