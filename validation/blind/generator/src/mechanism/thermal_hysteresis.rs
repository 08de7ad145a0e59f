//! `thermal_hysteresis`: the tin yields, so the warp on heating is not that on cooling: a few plays in temperature.
//!
//! Limits: rate-independent; relaxed at the start of a run. The size is the share of the warp that goes through the plays.

use super::{Mechanism, Needs, Numbers, numbers};
use crate::draws::Draws;
use crate::physics::{memory::play, warp::curvature};
use crate::state::{Scene, State};

/// Three plays of equal weight, slack W/3, 2W/3, W.
#[derive(Debug, Clone)]
pub struct ThermalHysteresis {
    slack: f64,
}

/// Draws the largest slack, K.
pub fn draw(draws: &mut Draws) -> Box<dyn Mechanism> {
    Box::new(ThermalHysteresis { slack: draws.between(2.0, 8.0) })
}

impl Mechanism for ThermalHysteresis {
    fn id(&self) -> &'static str {
        "thermal_hysteresis"
    }
    fn size_start(&self) -> f64 {
        0.1
    }
    fn size_limit(&self) -> f64 {
        6.0
    }
    fn needs(&self) -> Needs {
        Needs { warp: true, ..Needs::default() }
    }
    fn numbers(&self, size: f64) -> Numbers {
        numbers([("share", size), ("largest_slack_k", self.slack)])
    }
    fn geometry(&self, size: f64, scene: Scene, state: &mut State) {
        for run in scene.history.runs() {
            let mut memory = [state.temperature[run.start]; 3];
            for row in run {
                let now = state.temperature[row];
                let free = curvature(scene.sensor, now);
                for (j, q) in memory.iter_mut().enumerate() {
                    *q = play(*q, now, self.slack * (j as f64 + 1.0) / 3.0);
                    state.gap[row].curvature += size / 3.0 * (curvature(scene.sensor, *q) - free);
                }
            }
        }
    }
}
