//! `glass_knee`: below a certain temperature the rubber stiffens as it nears its glass.
//!
//! Limits: a soft knee in temperature, at once. The size is the relative change of the modulus per kelvin below it.

use super::softplus;
use crate::draws::Draws;
use crate::mechanism::{Mechanism, Numbers, numbers};
use crate::state::{Scene, State};

/// Where the knee is within the range of temperature, and how sharp (K).
#[derive(Debug, Clone)]
pub struct GlassKnee {
    knee: f64,
    sharp: f64,
}

/// Draws its shape.
pub fn draw(draws: &mut Draws) -> Box<dyn Mechanism> {
    Box::new(GlassKnee { knee: draws.between(0.3, 0.6), sharp: draws.between(0.8, 2.5) })
}

impl Mechanism for GlassKnee {
    fn id(&self) -> &'static str {
        "glass_knee"
    }
    fn size_start(&self) -> f64 {
        1e-4
    }
    fn size_limit(&self) -> f64 {
        0.1
    }
    fn numbers(&self, size: f64) -> Numbers {
        numbers([("per_kelvin", size), ("knee_share", self.knee)])
    }
    fn stiffness(&self, size: f64, _: Scene, state: &mut State) {
        let least = state.temperature.iter().copied().fold(f64::INFINITY, f64::min);
        let most = state.temperature.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        let knee = least + self.knee * (most - least);
        for (stiffness, temperature) in state.stiffness.iter_mut().zip(&state.temperature) {
            *stiffness *= 1.0 + size * self.sharp * softplus((knee - temperature) / self.sharp);
        }
    }
}
