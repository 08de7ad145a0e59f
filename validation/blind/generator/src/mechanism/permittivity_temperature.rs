//! `permittivity_temperature`: permittivity of silicone or polyimide follows temperature as a van 't Hoff exponential.
//!
//! Limits: one of the two layers; memoryless. The size is the absolute value of B in `exp(B (1/293 K - 1/T))`.

use super::{Mechanism, Numbers, numbers};
use crate::draws::Draws;
use crate::physics::constants::{REFERENCE, ZERO_CELSIUS};
use crate::state::{Scene, State};

/// Sign and layer.
#[derive(Debug, Clone)]
pub struct PermittivityTemperature {
    sign: f64,
    polyimide: bool,
}

/// Draws the layer (silicone has the larger coefficient but the smaller share) and the sign.
pub fn draw(draws: &mut Draws) -> Box<dyn Mechanism> {
    let polyimide = draws.chance(0.5);
    Box::new(PermittivityTemperature { sign: draws.sign(), polyimide })
}

impl Mechanism for PermittivityTemperature {
    fn id(&self) -> &'static str {
        "permittivity_temperature"
    }
    fn size_start(&self) -> f64 {
        if self.polyimide { 0.05 } else { 5.0 }
    }
    fn size_limit(&self) -> f64 {
        if self.polyimide { 60.0 } else { 600.0 }
    }
    fn numbers(&self, size: f64) -> Numbers {
        let [silicone, polyimide] = if self.polyimide { [0.0, size] } else { [size, 0.0] };
        numbers([("silicone_b_k", self.sign * silicone), ("polyimide_b_k", self.sign * polyimide)])
    }
    fn dielectric(&self, size: f64, _: Scene, state: &mut State) {
        let layer = if self.polyimide { &mut state.polyimide } else { &mut state.silicone };
        for (factor, temperature) in layer.iter_mut().zip(&state.temperature) {
            let inverse = 1.0 / (REFERENCE + ZERO_CELSIUS) - 1.0 / (temperature + ZERO_CELSIUS);
            *factor *= (self.sign * size * inverse).exp();
        }
    }
}
