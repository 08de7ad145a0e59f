//! `random_walk`: the reading wanders at random.
//!
//! Limits: steps are equal in rows, not in time; starts at zero with each run.

use super::{LIMIT_PF, START_PF};
use crate::draws::Draws;
use crate::mechanism::{Mechanism, Numbers, numbers};
use crate::state::{Scene, State};

/// Seed of the walk.
#[derive(Debug, Clone)]
pub struct RandomWalk {
    seed: u64,
}

/// Draws its shape.
pub fn draw(draws: &mut Draws) -> Box<dyn Mechanism> {
    Box::new(RandomWalk { seed: draws.bits() })
}

impl Mechanism for RandomWalk {
    fn id(&self) -> &'static str {
        "random_walk"
    }
    fn size_start(&self) -> f64 {
        START_PF
    }
    fn size_limit(&self) -> f64 {
        LIMIT_PF
    }
    fn numbers(&self, size: f64) -> Numbers {
        numbers([("pf_after_a_hundred_rows", size)])
    }
    fn readout(&self, size: f64, scene: Scene, state: &mut State) {
        let mut draws = Draws::of(self.seed, "walk");
        for run in scene.history.runs() {
            let mut place = 0.0;
            for row in run {
                state.reading[row] += 0.1 * size * place;
                place += draws.normal();
            }
        }
    }
}
