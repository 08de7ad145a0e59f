//! `beat`: a periodic disturbance whose phase moves with the load.
//!
//! Limits: one tone; no memory.

use super::{LIMIT_PF, START_PF};
use crate::draws::Draws;
use crate::mechanism::{Mechanism, Numbers, numbers};
use crate::state::{Scene, State};
use std::f64::consts::TAU;

/// `s sin(2 pi t / T + a F)`.
#[derive(Debug, Clone)]
pub struct Beat {
    period: f64,
    phase_per_newton: f64,
}

/// Draws its shape.
pub fn draw(draws: &mut Draws) -> Box<dyn Mechanism> {
    Box::new(Beat { period: draws.log_between(7.0, 90.0), phase_per_newton: draws.between(0.7, 2.0) })
}

impl Mechanism for Beat {
    fn id(&self) -> &'static str {
        "beat"
    }
    fn size_start(&self) -> f64 {
        START_PF
    }
    fn size_limit(&self) -> f64 {
        LIMIT_PF
    }
    fn numbers(&self, size: f64) -> Numbers {
        numbers([("amplitude_pf", size), ("period_s", self.period), ("phase_rad_per_n", self.phase_per_newton)])
    }
    fn readout(&self, size: f64, scene: Scene, state: &mut State) {
        for row in 0..state.reading.len() {
            let turn = TAU * scene.history.time[row] / self.period;
            state.reading[row] += size * (turn + self.phase_per_newton * scene.history.force[row]).sin();
        }
    }
}
