//! `offset_steps`: the zero jumps where the sensor was plugged in again, in some of the pauses between runs.
//!
//! Limits: one to three pauses, jumps of like size; a recording of one run has none. A jump inside a run is the stranger `slips`, as in the shared recordings.
//! The size is the jump, pF.

use super::{Mechanism, Numbers, numbers};
use crate::draws::Draws;
use crate::state::{Scene, State};

/// Which pause (share of them), how high (share of the size).
#[derive(Debug, Clone)]
pub struct OffsetSteps {
    jumps: Vec<(f64, f64)>,
}

/// Draws one to three pauses.
pub fn draw(draws: &mut Draws) -> Box<dyn Mechanism> {
    let count = 1 + draws.index(3);
    Box::new(OffsetSteps {
        jumps: (0..count).map(|_| (draws.between(0.0, 1.0), draws.sign() * draws.between(0.7, 1.3))).collect(),
    })
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
        numbers([("jump_pf", size), ("jumps", self.jumps.len() as f64)])
    }
    fn readout(&self, size: f64, scene: Scene, state: &mut State) {
        let runs = scene.history.runs();
        let pauses = runs.len() - 1;
        for (place, height) in self.jumps.iter().filter(|_| pauses > 0) {
            let after = 1 + ((place * pauses as f64) as usize).min(pauses - 1);
            state.reading[runs[after].start..].iter_mut().for_each(|reading| *reading += size * height);
        }
    }
}
