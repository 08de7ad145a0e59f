//! `clock_rate`: the clock of the response runs faster or slower than that of the load.
//!
//! Limits: linear between samples, held at the ends of a run; both clocks agree once. The size is the relative rate.

use crate::draws::Draws;
use crate::mechanism::time_offset::at;
use crate::mechanism::{Mechanism, Numbers, numbers};
use crate::state::{Scene, State};

/// Faster (+) or slower (-), and where in the recording both agree (share of it).
#[derive(Debug, Clone)]
pub struct ClockRate {
    sign: f64,
    agree: f64,
}

/// Draws its shape.
pub fn draw(draws: &mut Draws) -> Box<dyn Mechanism> {
    Box::new(ClockRate { sign: draws.sign(), agree: draws.between(0.0, 0.6) })
}

impl Mechanism for ClockRate {
    fn id(&self) -> &'static str {
        "clock_rate"
    }
    fn size_start(&self) -> f64 {
        1e-7
    }
    fn size_limit(&self) -> f64 {
        1e-2
    }
    fn numbers(&self, size: f64) -> Numbers {
        numbers([("relative_rate", self.sign * size), ("agree_share", self.agree)])
    }
    fn readout(&self, size: f64, scene: Scene, state: &mut State) {
        let time = &scene.history.time;
        let (Some(first), Some(last)) = (time.first(), time.last()) else { return };
        let agree = first + self.agree * (last - first);
        let sharp = state.reading.clone();
        for run in scene.history.runs() {
            for row in run.clone() {
                let then = time[row] - self.sign * size * (time[row] - agree);
                state.reading[row] = at(time, &sharp, run.clone(), then);
            }
        }
    }
}
