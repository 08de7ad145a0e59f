//! `slips`: a contact slips a few times while it is loaded: the zero jumps inside a run, each jump settling within seconds.
//!
//! Limits: one to six jumps of like size, at rows rather than times, so that every protocol has them.

use super::{LIMIT_PF, START_PF};
use crate::draws::Draws;
use crate::mechanism::{Mechanism, Numbers, numbers};
use crate::state::{Scene, State};

/// Where (share of the rows), how high (share of the size), how fast (s).
#[derive(Debug, Clone)]
pub struct Slips {
    jumps: Vec<(f64, f64)>,
    settling: f64,
}

/// Draws one to six jumps.
pub fn draw(draws: &mut Draws) -> Box<dyn Mechanism> {
    let count = 1 + draws.index(6);
    let mut jumps: Vec<(f64, f64)> =
        (0..count).map(|_| (draws.between(0.1, 0.9), draws.sign() * draws.between(0.7, 1.3))).collect();
    jumps.sort_by(|a, b| a.0.total_cmp(&b.0));
    Box::new(Slips { jumps, settling: draws.log_between(0.1, 3.0) })
}

impl Mechanism for Slips {
    fn id(&self) -> &'static str {
        "slips"
    }
    fn size_start(&self) -> f64 {
        START_PF
    }
    fn size_limit(&self) -> f64 {
        LIMIT_PF
    }
    fn numbers(&self, size: f64) -> Numbers {
        numbers([("jump_pf", size), ("jumps", self.jumps.len() as f64), ("settling_s", self.settling)])
    }
    fn readout(&self, size: f64, scene: Scene, state: &mut State) {
        let time = &scene.history.time;
        for (place, height) in &self.jumps {
            let start = (place * time.len() as f64) as usize;
            for row in start..time.len() {
                let settled = -(-(time[row] - time[start]) / self.settling).exp_m1();
                state.reading[row] += size * height * settled;
            }
        }
    }
}
