//! `plate_bending`: the electrode bends under the load like a simply supported, uniformly loaded plate.
//!
//! Limits: deflection proportional to load; its mean over the plate is already in the compression. The size is the middle's deflection, m/N.

use super::{Mechanism, Numbers, numbers};
use crate::draws::Draws;
use crate::state::{Scene, State};

/// Deflection, toward or away from the other plate.
#[derive(Debug, Clone)]
pub struct PlateBending {
    sign: f64,
}

/// Draws the direction: pressed in the middle, or at the rim.
pub fn draw(draws: &mut Draws) -> Box<dyn Mechanism> {
    Box::new(PlateBending { sign: draws.sign() })
}

impl Mechanism for PlateBending {
    fn id(&self) -> &'static str {
        "plate_bending"
    }
    fn size_start(&self) -> f64 {
        1e-6
    }
    fn size_limit(&self) -> f64 {
        25e-6
    }
    fn numbers(&self, size: f64) -> Numbers {
        numbers([("middle_um_per_n", self.sign * size * 1e6)])
    }
    fn geometry(&self, size: f64, _: Scene, state: &mut State) {
        for (gap, force) in state.gap.iter_mut().zip(&state.force) {
            gap.bow += self.sign * size * force;
        }
    }
}
