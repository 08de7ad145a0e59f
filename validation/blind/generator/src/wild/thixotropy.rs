//! `thixotropy`: while it is worked the filled rubber softens (Payne, Mullins' second kind) and heals at rest.
//!
//! Limits: follows how fast the load changes, either way, and fades with one time constant. The size is the largest softening.

use crate::draws::Draws;
use crate::mechanism::{Mechanism, Numbers, numbers};
use crate::physics::memory::relax;
use crate::state::{Scene, State};

/// Speed of half the softening, N/s, and the time of healing, s.
#[derive(Debug, Clone)]
pub struct Thixotropy {
    speed: f64,
    heals: f64,
}

/// Draws its shape.
pub fn draw(draws: &mut Draws) -> Box<dyn Mechanism> {
    Box::new(Thixotropy { speed: draws.log_between(0.2, 1.5), heals: draws.log_between(8.0, 60.0) })
}

impl Mechanism for Thixotropy {
    fn id(&self) -> &'static str {
        "thixotropy"
    }
    fn size_start(&self) -> f64 {
        1e-3
    }
    fn size_limit(&self) -> f64 {
        0.4
    }
    fn numbers(&self, size: f64) -> Numbers {
        numbers([("softening", size), ("speed_n_per_s", self.speed), ("heals_s", self.heals)])
    }
    fn stiffness(&self, size: f64, scene: Scene, state: &mut State) {
        let rate = scene.history.rate(&state.force);
        for run in scene.history.runs() {
            let mut worked = 0.0;
            for row in run.skip(1) {
                let dt = scene.history.time[row] - scene.history.time[row - 1];
                let aim = rate[row].abs() / (rate[row].abs() + self.speed);
                worked = relax(worked, aim, aim, dt, self.heals);
                state.stiffness[row] *= 1.0 - size * worked;
            }
        }
    }
}
