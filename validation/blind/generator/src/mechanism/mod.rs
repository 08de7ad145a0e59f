//! Concealed causes: one file each, in other equations than the textbook form that a fitter would hold.
//!
//! A mechanism has a *shape*, drawn once, and a *size*, set by how detectable it has to be. Size 0 is the base model exactly.
//! Limits: a size beyond `size_limit` would not be believed of a real sensor; causes that cannot be seen below it are not posed.

use crate::history::History;
use crate::recording::Column;
use crate::state::{Scene, State};
use serde_json::{Map, Value};
use std::fmt::Debug;

pub mod ageing;
pub mod bonded_layers;
pub mod clock_rate;
pub mod contact_toe_in;
pub mod dead_gap;
pub mod driver_coefficient;
pub mod eccentric_load;
pub mod electrode_warp;
pub mod fringing_field;
pub mod gain_drift;
pub mod held_warp;
pub mod humidity_uptake;
pub mod load_cell_error;
pub mod mullins_softening;
pub mod offset_drift;
pub mod offset_steps;
pub mod parasitic_capacitance;
pub mod permittivity_temperature;
pub mod plate_bending;
pub mod rate_independent_hysteresis;
pub mod readout_lag;
pub mod rim_field;
pub mod saturation;
pub mod strain_stiffening;
pub mod thermal_hysteresis;
pub mod thermal_lag;
pub mod time_offset;
pub mod trapped_air_stiffness;
pub mod viscoelastic_creep;

/// Named numbers of a cause, for the sealed answer.
pub type Numbers = Map<String, Value>;

/// What a cause needs to be posed at all.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Needs {
    /// The truth bends with temperature.
    pub warp: bool,
    /// The declared base model leaves the warp out.
    pub no_warp: bool,
    /// A humidity column.
    pub humidity: bool,
}

/// A cause; the hooks are called in the order of the chain and do nothing unless written.
pub trait Mechanism: Debug + MechanismClone {
    /// Id: that of the table of effects in `design.md`, or the name of a stranger.
    fn id(&self) -> &'static str;
    /// A small size to start the search from (positive).
    fn size_start(&self) -> f64;
    /// The largest size that would be believed.
    fn size_limit(&self) -> f64;
    /// Shape and size, with units in the names.
    fn numbers(&self, size: f64) -> Numbers;
    /// What it needs.
    fn needs(&self) -> Needs {
        Needs::default()
    }
    /// A column that is recorded because of it, one entry a row.
    fn records(&self, _history: &History) -> Option<Column> {
        None
    }
    /// Load path and thermal path: `state.force`, `state.temperature`.
    fn inputs(&self, _size: f64, _scene: Scene, _state: &mut State) {}
    /// Before the beads are pressed: `state.stiffness`, `state.stiffening`.
    fn stiffness(&self, _size: f64, _scene: Scene, _state: &mut State) {}
    /// After: `state.compression`.
    fn strain(&self, _size: f64, _scene: Scene, _state: &mut State) {}
    /// `state.gap`.
    fn geometry(&self, _size: f64, _scene: Scene, _state: &mut State) {}
    /// `state.silicone`, `state.polyimide`.
    fn dielectric(&self, _size: f64, _scene: Scene, _state: &mut State) {}
    /// Capacitance beside the sensor, added to `state.reading`.
    fn field(&self, _size: f64, _scene: Scene, _state: &mut State) {}
    /// The electronics, on `state.reading`.
    fn readout(&self, _size: f64, _scene: Scene, _state: &mut State) {}
}

/// Cloning behind the trait object.
pub trait MechanismClone {
    /// A copy.
    fn boxed(&self) -> Box<dyn Mechanism>;
}

impl<M: Mechanism + Clone + 'static> MechanismClone for M {
    fn boxed(&self) -> Box<dyn Mechanism> {
        Box::new(self.clone())
    }
}

impl Clone for Box<dyn Mechanism> {
    fn clone(&self) -> Self {
        self.as_ref().boxed()
    }
}

/// Collects named numbers.
pub(crate) fn numbers<const N: usize>(pairs: [(&str, f64); N]) -> Numbers {
    pairs.into_iter().map(|(name, value)| (name.to_owned(), Value::from(value))).collect()
}
