//! `force_rate_squared`: the reading rises with the square of the loading rate.
//!
//! Limits: even in the rate; nothing to see at constant load.

use super::{LIMIT_PF, START_PF};
use crate::draws::Draws;
use crate::mechanism::{Mechanism, Numbers, numbers};
use crate::state::{Scene, State};

/// `s (r / r0)^2 / (1 + (r / r0)^2)`, r the rate of the load.
#[derive(Debug, Clone)]
pub struct ForceRateSquared {
    scale: f64,
}

/// Draws its shape.
pub fn draw(draws: &mut Draws) -> Box<dyn Mechanism> {
    Box::new(ForceRateSquared { scale: draws.log_between(0.2, 2.0) })
}

impl Mechanism for ForceRateSquared {
    fn id(&self) -> &'static str {
        "force_rate_squared"
    }
    fn size_start(&self) -> f64 {
        START_PF
    }
    fn size_limit(&self) -> f64 {
        LIMIT_PF
    }
    fn numbers(&self, size: f64) -> Numbers {
        numbers([("pf_at_full_rate", size), ("scale_n_per_s", self.scale)])
    }
    fn readout(&self, size: f64, scene: Scene, state: &mut State) {
        let rate = scene.history.rate(&scene.history.force);
        for (reading, rate) in state.reading.iter_mut().zip(rate) {
            let square = (rate / self.scale).powi(2);
            *reading += size * square / (1.0 + square);
        }
    }
}
