//! `cycle_fatigue`: each cycle of load breaks a little of the rubber: the modulus falls with the logarithm of the way that the load has gone.
//!
//! Limits: never comes back; the greatest load does not matter. The size is the fall per e-fold.

use crate::draws::Draws;
use crate::mechanism::{Mechanism, Numbers, numbers};
use crate::physics::constants::RATED_FORCE;
use crate::state::{Scene, State};

/// Cycles to full load after which the fall begins.
#[derive(Debug, Clone)]
pub struct CycleFatigue {
    onset: f64,
}

/// Draws its shape.
pub fn draw(draws: &mut Draws) -> Box<dyn Mechanism> {
    Box::new(CycleFatigue { onset: draws.log_between(1.0, 8.0) })
}

impl Mechanism for CycleFatigue {
    fn id(&self) -> &'static str {
        "cycle_fatigue"
    }
    fn size_start(&self) -> f64 {
        1e-4
    }
    fn size_limit(&self) -> f64 {
        0.2
    }
    fn numbers(&self, size: f64) -> Numbers {
        numbers([("modulus_fall_per_e_fold", size), ("onset_cycles", self.onset)])
    }
    fn stiffness(&self, size: f64, _: Scene, state: &mut State) {
        let mut way = 0.0;
        for row in 0..state.force.len() {
            if row > 0 {
                way += (state.force[row] - state.force[row - 1]).abs();
            }
            state.stiffness[row] *= 1.0 - size * (way / (2.0 * RATED_FORCE * self.onset)).ln_1p();
        }
    }
}
