//! `ageing`: the modulus drifts with the logarithm of time since the first record.
//!
//! Limits: depends on the clock only; the size is the relative change per decade.

use super::{Mechanism, Numbers, numbers};
use crate::draws::Draws;
use crate::state::{Scene, State};

/// `1 +/- s log10(1 + t / t0)`.
#[derive(Debug, Clone)]
pub struct Ageing {
    sign: f64,
    onset: f64,
}

/// Draws the direction and the onset, s.
pub fn draw(draws: &mut Draws) -> Box<dyn Mechanism> {
    Box::new(Ageing { sign: draws.sign(), onset: draws.log_between(300.0, 6000.0) })
}

impl Mechanism for Ageing {
    fn id(&self) -> &'static str {
        "ageing"
    }
    fn size_start(&self) -> f64 {
        0.001
    }
    fn size_limit(&self) -> f64 {
        0.4
    }
    fn numbers(&self, size: f64) -> Numbers {
        numbers([("modulus_change_per_decade", self.sign * size), ("onset_s", self.onset)])
    }
    fn stiffness(&self, size: f64, scene: Scene, state: &mut State) {
        for (stiffness, time) in state.stiffness.iter_mut().zip(&scene.history.time) {
            *stiffness *= 1.0 + self.sign * size * (1.0 + time / self.onset).log10();
        }
    }
}
