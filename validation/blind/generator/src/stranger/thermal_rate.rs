//! `thermal_rate`: the reading rises while the temperature changes, either way.
//!
//! Limits: even in the rate, so that no lag explains it; nothing to see at constant temperature.

use super::{LIMIT_PF, START_PF};
use crate::draws::Draws;
use crate::mechanism::{Mechanism, Numbers, numbers};
use crate::state::{Scene, State};

/// `s |dT/dt| / (1 K/min)`, saturating.
#[derive(Debug, Clone)]
pub struct ThermalRate {
    scale: f64,
}

/// Draws its shape.
pub fn draw(draws: &mut Draws) -> Box<dyn Mechanism> {
    Box::new(ThermalRate { scale: draws.between(1.0, 4.0) })
}

impl Mechanism for ThermalRate {
    fn id(&self) -> &'static str {
        "thermal_rate"
    }
    fn size_start(&self) -> f64 {
        START_PF
    }
    fn size_limit(&self) -> f64 {
        LIMIT_PF
    }
    fn numbers(&self, size: f64) -> Numbers {
        numbers([("pf_at_full_rate", size), ("scale_k_per_min", self.scale)])
    }
    fn readout(&self, size: f64, scene: Scene, state: &mut State) {
        let rate = scene.history.rate(&scene.history.temperature);
        for (reading, rate) in state.reading.iter_mut().zip(rate) {
            *reading += size * (60.0 * rate.abs() / self.scale).tanh();
        }
    }
}
