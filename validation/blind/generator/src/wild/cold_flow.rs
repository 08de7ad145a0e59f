//! `cold_flow`: under load the beads flow for good: the gap shrinks by a power of load times time.
//!
//! Limits: never comes back; rests unloaded. The size is the share of the gap lost after an hour at full load.

use crate::draws::Draws;
use crate::mechanism::{Mechanism, Numbers, numbers};
use crate::physics::constants::RATED_FORCE;
use crate::state::{Scene, State};

/// Power of the dose.
#[derive(Debug, Clone)]
pub struct ColdFlow {
    power: f64,
}

/// Draws its shape.
pub fn draw(draws: &mut Draws) -> Box<dyn Mechanism> {
    Box::new(ColdFlow { power: draws.between(0.4, 0.8) })
}

impl Mechanism for ColdFlow {
    fn id(&self) -> &'static str {
        "cold_flow"
    }
    fn size_start(&self) -> f64 {
        1e-5
    }
    fn size_limit(&self) -> f64 {
        0.1
    }
    fn numbers(&self, size: f64) -> Numbers {
        numbers([("share_after_an_hour", size), ("power", self.power)])
    }
    fn geometry(&self, size: f64, scene: Scene, state: &mut State) {
        let (time, load) = (&scene.history.time, &state.force);
        let mut dose = 0.0;
        for row in 0..load.len() {
            if row > 0 && scene.history.run[row] == scene.history.run[row - 1] {
                dose += 0.5 * (load[row] + load[row - 1]) * (time[row] - time[row - 1]);
            }
            state.gap[row].mean *= 1.0 - size * (dose / (RATED_FORCE * 3600.0)).powf(self.power);
        }
    }
}
