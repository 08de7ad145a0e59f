//! `load_cell_error`: the reference for the load has a zero error, a gain error and a bow of its own.
//!
//! Limits: memoryless; the recorded load is as the protocol says, the true one differs. The size is the largest error, N.

use super::{Mechanism, Numbers, numbers};
use crate::draws::Draws;
use crate::physics::constants::RATED_FORCE;
use crate::state::{Scene, State};

/// True minus recorded load: `s (zero + gain x + bow 4 x (1 - x))`, x = F over the rated load.
#[derive(Debug, Clone)]
pub struct LoadCellError {
    zero: f64,
    gain: f64,
    bow: f64,
}

/// Draws the mixture.
pub fn draw(draws: &mut Draws) -> Box<dyn Mechanism> {
    let raw = [draws.normal() * 0.5, draws.normal() * 0.5, draws.sign() * draws.between(0.5, 1.0)];
    let scale = raw.iter().map(|x| x.abs()).sum::<f64>();
    Box::new(LoadCellError { zero: raw[0] / scale, gain: raw[1] / scale, bow: raw[2] / scale })
}

impl Mechanism for LoadCellError {
    fn id(&self) -> &'static str {
        "load_cell_error"
    }
    fn size_start(&self) -> f64 {
        0.003
    }
    fn size_limit(&self) -> f64 {
        1.0
    }
    fn numbers(&self, size: f64) -> Numbers {
        numbers([("zero_n", size * self.zero), ("gain_n", size * self.gain), ("bow_n", size * self.bow)])
    }
    fn inputs(&self, size: f64, _: Scene, state: &mut State) {
        for force in &mut state.force {
            let x = *force / RATED_FORCE;
            *force += size * (self.zero + self.gain * x + self.bow * 4.0 * x * (1.0 - x));
        }
    }
}
