//! `held_warp`: the beads hold the electrode down, so that only a part of its free curvature is left, the less the more it is pressed.
//!
//! Limits: one curvature for the whole plate; the hold grows by a quarter at full load. The size is the share of the curvature that is held.

use crate::draws::Draws;
use crate::mechanism::{Mechanism, Needs, Numbers, numbers};
use crate::physics::constants::RATED_FORCE;
use crate::state::{Scene, State};

/// Nothing to draw.
#[derive(Debug, Clone)]
pub struct HeldWarp;

/// Draws its shape.
pub fn draw(_: &mut Draws) -> Box<dyn Mechanism> {
    Box::new(HeldWarp)
}

impl Mechanism for HeldWarp {
    fn id(&self) -> &'static str {
        "held_warp"
    }
    fn size_start(&self) -> f64 {
        0.02
    }
    fn size_limit(&self) -> f64 {
        1.0
    }
    fn needs(&self) -> Needs {
        Needs { warp: true, ..Needs::default() }
    }
    fn numbers(&self, size: f64) -> Numbers {
        numbers([("share_held", size)])
    }
    fn geometry(&self, size: f64, _: Scene, state: &mut State) {
        for (row, gap) in state.gap.iter_mut().enumerate() {
            let pressed = 1.0 + 0.25 * (state.force[row] / RATED_FORCE - 0.5);
            gap.curvature *= 1.0 - size * pressed;
        }
    }
}
