//! `contact_toe_in`: beads of unequal height touch one after another; the share in contact follows a rational law of the load.
//!
//! Limits: memoryless; the share missing at zero load is the size.

use super::{Mechanism, Numbers, numbers};
use crate::draws::Draws;
use crate::state::{Scene, State};

/// Share in contact `1 - m / (1 + (F/F0)^2)`: the tail of heights is heavier than exponential.
#[derive(Debug, Clone)]
pub struct ContactToeIn {
    force: f64,
}

/// Draws the load at which half of the missing beads carry, N.
pub fn draw(draws: &mut Draws) -> Box<dyn Mechanism> {
    Box::new(ContactToeIn { force: draws.between(0.3, 1.2) })
}

impl Mechanism for ContactToeIn {
    fn id(&self) -> &'static str {
        "contact_toe_in"
    }
    fn size_start(&self) -> f64 {
        0.01
    }
    fn size_limit(&self) -> f64 {
        0.6
    }
    fn numbers(&self, size: f64) -> Numbers {
        numbers([("missing_share", size), ("half_force_n", self.force)])
    }
    fn stiffness(&self, size: f64, _: Scene, state: &mut State) {
        for (stiffness, force) in state.stiffness.iter_mut().zip(&state.force) {
            let x = force / self.force;
            *stiffness *= 1.0 - size / (1.0 + x * x);
        }
    }
}
