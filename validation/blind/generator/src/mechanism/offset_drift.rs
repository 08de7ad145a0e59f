//! `offset_drift`: the zero moves by a power of time since the first record.
//!
//! Limits: depends on the clock only; the size is the drift after an hour, pF.

use super::{Mechanism, Numbers, numbers};
use crate::draws::Draws;
use crate::state::{Scene, State};

/// `+/- s (t / 1 h)^p`.
#[derive(Debug, Clone)]
pub struct OffsetDrift {
    sign: f64,
    power: f64,
}

/// Draws direction and power.
pub fn draw(draws: &mut Draws) -> Box<dyn Mechanism> {
    Box::new(OffsetDrift { sign: draws.sign(), power: draws.between(0.6, 1.4) })
}

impl Mechanism for OffsetDrift {
    fn id(&self) -> &'static str {
        "offset_drift"
    }
    fn size_start(&self) -> f64 {
        1e-4
    }
    fn size_limit(&self) -> f64 {
        2.0
    }
    fn numbers(&self, size: f64) -> Numbers {
        numbers([("pf_after_an_hour", self.sign * size), ("power", self.power)])
    }
    fn readout(&self, size: f64, scene: Scene, state: &mut State) {
        for (reading, time) in state.reading.iter_mut().zip(&scene.history.time) {
            *reading += self.sign * size * (time / 3600.0).powf(self.power);
        }
    }
}
