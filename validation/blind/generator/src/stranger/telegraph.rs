//! `telegraph`: a second axis of load that switches on and off at random, seen through the load.
//!
//! Limits: two states; switches at random rows.

use super::{LIMIT_PF, START_PF};
use crate::draws::Draws;
use crate::mechanism::{Mechanism, Numbers, numbers};
use crate::physics::constants::RATED_FORCE;
use crate::state::{Scene, State};

/// Mean rows in a state, and the seed.
#[derive(Debug, Clone)]
pub struct Telegraph {
    rows: f64,
    seed: u64,
}

/// Draws its shape.
pub fn draw(draws: &mut Draws) -> Box<dyn Mechanism> {
    Box::new(Telegraph { rows: draws.log_between(20.0, 200.0), seed: draws.bits() })
}

impl Mechanism for Telegraph {
    fn id(&self) -> &'static str {
        "telegraph"
    }
    fn size_start(&self) -> f64 {
        START_PF
    }
    fn size_limit(&self) -> f64 {
        LIMIT_PF
    }
    fn numbers(&self, size: f64) -> Numbers {
        numbers([("amplitude_pf", size), ("rows_in_a_state", self.rows)])
    }
    fn readout(&self, size: f64, scene: Scene, state: &mut State) {
        let mut draws = Draws::of(self.seed, "telegraph");
        let mut on = 1.0;
        for (reading, force) in state.reading.iter_mut().zip(&scene.history.force) {
            if draws.chance(1.0 / self.rows) {
                on = -on;
            }
            *reading += size * on * (0.3 + force / RATED_FORCE);
        }
    }
}
