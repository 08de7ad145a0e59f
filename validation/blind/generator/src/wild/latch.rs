//! `latch`: something in the load path snaps over above one load and back below a smaller one, and the gap with it.
//!
//! Limits: one relay, at rest when a run starts. The size is the share of the gap.

use crate::draws::Draws;
use crate::mechanism::{Mechanism, Numbers, numbers};
use crate::state::{Scene, State};

/// Loads of snapping over and back, N.
#[derive(Debug, Clone)]
pub struct Latch {
    over: f64,
    back: f64,
}

/// Draws its shape.
pub fn draw(draws: &mut Draws) -> Box<dyn Mechanism> {
    let over = draws.between(1.6, 2.8);
    Box::new(Latch { over, back: over * draws.between(0.3, 0.7) })
}

impl Mechanism for Latch {
    fn id(&self) -> &'static str {
        "latch"
    }
    fn size_start(&self) -> f64 {
        1e-5
    }
    fn size_limit(&self) -> f64 {
        0.1
    }
    fn numbers(&self, size: f64) -> Numbers {
        numbers([("share_of_gap", size), ("over_n", self.over), ("back_n", self.back)])
    }
    fn geometry(&self, size: f64, scene: Scene, state: &mut State) {
        for run in scene.history.runs() {
            let mut over = false;
            for row in run {
                over = if over { state.force[row] > self.back } else { state.force[row] > self.over };
                if over {
                    state.gap[row].mean *= 1.0 - size;
                }
            }
        }
    }
}
