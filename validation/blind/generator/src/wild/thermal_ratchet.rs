//! `thermal_ratchet`: each warming and cooling shifts the layers a little against each other, and the gap does not come back.
//!
//! Limits: by the way that temperature has gone, whichever way. The size is the share of the gap after 100 K.

use crate::draws::Draws;
use crate::mechanism::{Mechanism, Numbers, numbers};
use crate::state::{Scene, State};

/// Sign, and power of the way.
#[derive(Debug, Clone)]
pub struct ThermalRatchet {
    sign: f64,
    power: f64,
}

/// Draws its shape.
pub fn draw(draws: &mut Draws) -> Box<dyn Mechanism> {
    Box::new(ThermalRatchet { sign: draws.sign(), power: draws.between(0.5, 1.0) })
}

impl Mechanism for ThermalRatchet {
    fn id(&self) -> &'static str {
        "thermal_ratchet"
    }
    fn size_start(&self) -> f64 {
        1e-5
    }
    fn size_limit(&self) -> f64 {
        0.1
    }
    fn numbers(&self, size: f64) -> Numbers {
        numbers([("share_after_100_k", self.sign * size), ("power", self.power)])
    }
    fn geometry(&self, size: f64, _: Scene, state: &mut State) {
        let mut way: f64 = 0.0;
        for row in 0..state.temperature.len() {
            if row > 0 {
                way += (state.temperature[row] - state.temperature[row - 1]).abs();
            }
            state.gap[row].mean *= 1.0 + self.sign * size * (way / 100.0).powf(self.power);
        }
    }
}
