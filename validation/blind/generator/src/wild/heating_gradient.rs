//! `heating_gradient`: while the stack heats, its outside is warmer than its inside and the gap opens (or closes) in proportion.
//!
//! Limits: the gradient settles within seconds; odd in the rate. The size is the share of the gap at 1 K/min.

use crate::draws::Draws;
use crate::mechanism::{Mechanism, Numbers, numbers};
use crate::physics::memory::relax;
use crate::state::{Scene, State};

/// Sign, and the time in which the gradient settles, s.
#[derive(Debug, Clone)]
pub struct HeatingGradient {
    sign: f64,
    settles: f64,
}

/// Draws its shape.
pub fn draw(draws: &mut Draws) -> Box<dyn Mechanism> {
    Box::new(HeatingGradient { sign: draws.sign(), settles: draws.log_between(2.0, 20.0) })
}

impl Mechanism for HeatingGradient {
    fn id(&self) -> &'static str {
        "heating_gradient"
    }
    fn size_start(&self) -> f64 {
        1e-6
    }
    fn size_limit(&self) -> f64 {
        0.05
    }
    fn numbers(&self, size: f64) -> Numbers {
        numbers([("share_at_a_kelvin_a_minute", self.sign * size), ("settles_s", self.settles)])
    }
    fn geometry(&self, size: f64, scene: Scene, state: &mut State) {
        let rate = scene.history.rate(&state.temperature);
        for run in scene.history.runs() {
            let mut gradient = 0.0;
            for row in run.skip(1) {
                let dt = scene.history.time[row] - scene.history.time[row - 1];
                gradient = relax(gradient, rate[row], rate[row], dt, self.settles);
                state.gap[row].mean *= 1.0 + self.sign * size * 60.0 * gradient;
            }
        }
    }
}
