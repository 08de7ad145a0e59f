//! `bursts`: short bursts of interference at random moments.
//!
//! Limits: bursts of 15 to 40 rows with a random tone inside.

use super::{LIMIT_PF, START_PF};
use crate::draws::Draws;
use crate::mechanism::{Mechanism, Numbers, numbers};
use crate::state::{Scene, State};

/// How many bursts in a thousand rows, and their seed.
#[derive(Debug, Clone)]
pub struct Bursts {
    per_thousand: f64,
    seed: u64,
}

/// Draws its shape.
pub fn draw(draws: &mut Draws) -> Box<dyn Mechanism> {
    Box::new(Bursts { per_thousand: draws.between(2.0, 8.0), seed: draws.bits() })
}

impl Mechanism for Bursts {
    fn id(&self) -> &'static str {
        "bursts"
    }
    fn size_start(&self) -> f64 {
        START_PF
    }
    fn size_limit(&self) -> f64 {
        LIMIT_PF
    }
    fn numbers(&self, size: f64) -> Numbers {
        numbers([("amplitude_pf", size), ("bursts_per_thousand_rows", self.per_thousand)])
    }
    fn readout(&self, size: f64, scene: Scene, state: &mut State) {
        let mut draws = Draws::of(self.seed, "bursts");
        let rows = scene.history.rows();
        let count = 1 + (self.per_thousand * rows as f64 / 1000.0) as usize;
        for _ in 0..count {
            let (start, length) = (draws.index(rows), 15 + draws.index(26));
            let (turn, height) = (draws.between(0.7, 2.5), draws.between(0.5, 1.5));
            for row in start..(start + length).min(rows) {
                state.reading[row] += size * height * (turn * (row - start) as f64).sin();
            }
        }
    }
}
