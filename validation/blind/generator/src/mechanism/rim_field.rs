//! `rim_field`: the field of a shielded electrode goes on beyond its rim, to where the shield begins.
//!
//! Limits: two coplanar half planes over a ground, per length of rim; nearly a constant. The size is a multiple of it.

use crate::draws::Draws;
use crate::mechanism::{Mechanism, Numbers, numbers};
use crate::physics::{constants::EPS0, layers::radius};
use crate::state::{Scene, State};

/// Distance of the shield from the rim, m.
#[derive(Debug, Clone)]
pub struct RimField {
    shield: f64,
}

/// Draws its shape.
pub fn draw(draws: &mut Draws) -> Box<dyn Mechanism> {
    Box::new(RimField { shield: draws.log_between(100e-6, 400e-6) })
}

impl Mechanism for RimField {
    fn id(&self) -> &'static str {
        "rim_field"
    }
    fn size_start(&self) -> f64 {
        0.05
    }
    fn size_limit(&self) -> f64 {
        6.0
    }
    fn numbers(&self, size: f64) -> Numbers {
        numbers([("over_half_planes", size), ("shield_m", self.shield)])
    }
    fn field(&self, size: f64, scene: Scene, state: &mut State) {
        for row in 0..state.reading.len() {
            let r = radius(scene.sensor, state.temperature[row]);
            let gap = state.gap[row].mean + state.gap[row].dead;
            state.reading[row] += size * 1e12 * EPS0 * 2.0 * r * (self.shield / gap).powi(2).ln_1p();
        }
    }
}
