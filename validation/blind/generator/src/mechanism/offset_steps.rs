//! `offset_steps`: the zero jumps a few times (a slipping contact), each jump settling within seconds.
//!
//! Limits: one to three jumps of like size, at rows rather than times, so that every protocol has them. The size is the jump, pF.

use super::{Mechanism, Numbers, numbers};
use crate::chain::{Scene, State};
use crate::draws::Draws;

/// Where (share of the rows), how high (share of the size), how fast (s).
#[derive(Debug, Clone)]
pub struct OffsetSteps {
    steps: Vec<(f64, f64)>,
    settling: f64,
}

/// Draws one to three jumps.
pub fn draw(draws: &mut Draws) -> Box<dyn Mechanism> {
    let count = 1 + draws.index(3);
    let mut steps: Vec<(f64, f64)> =
        (0..count).map(|_| (draws.between(0.1, 0.9), draws.sign() * draws.between(0.7, 1.3))).collect();
    steps.sort_by(|a, b| a.0.total_cmp(&b.0));
    Box::new(OffsetSteps { steps, settling: draws.log_between(0.1, 3.0) })
}

impl Mechanism for OffsetSteps {
    fn id(&self) -> &'static str {
        "offset_steps"
    }
    fn size_start(&self) -> f64 {
        2e-4
    }
    fn size_limit(&self) -> f64 {
        2.0
    }
    fn numbers(&self, size: f64) -> Numbers {
        numbers([("step_pf", size), ("steps", self.steps.len() as f64), ("settling_s", self.settling)])
    }
    fn readout(&self, size: f64, scene: Scene, state: &mut State) {
        let time = &scene.history.time;
        for (place, height) in &self.steps {
            let start = (place * time.len() as f64) as usize;
            for row in start..time.len() {
                let settled = -(-(time[row] - time[start]) / self.settling).exp_m1();
                state.reading[row] += size * height * settled;
            }
        }
    }
}
