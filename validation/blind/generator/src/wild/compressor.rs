//! `compressor`: a cooling compressor nearby switches on and off, and the zero of the electronics breathes with it.
//!
//! Limits: a rounded square wave of constant period. The size is half its height, pF.

use crate::draws::Draws;
use crate::mechanism::{Mechanism, Numbers, numbers};
use crate::state::{Scene, State};
use std::f64::consts::TAU;

/// Period as a share of the recording, phase, and how square.
#[derive(Debug, Clone)]
pub struct Compressor {
    share: f64,
    phase: f64,
    square: f64,
}

/// Draws its shape.
pub fn draw(draws: &mut Draws) -> Box<dyn Mechanism> {
    Box::new(Compressor { share: draws.log_between(0.02, 0.15), phase: draws.between(0.0, TAU), square: draws.between(0.5, 3.0) })
}

impl Mechanism for Compressor {
    fn id(&self) -> &'static str {
        "compressor"
    }
    fn size_start(&self) -> f64 {
        2e-4
    }
    fn size_limit(&self) -> f64 {
        1.0
    }
    fn numbers(&self, size: f64) -> Numbers {
        numbers([("amplitude_pf", size), ("period_share", self.share)])
    }
    fn readout(&self, size: f64, scene: Scene, state: &mut State) {
        let time = &scene.history.time;
        let (Some(first), Some(last)) = (time.first(), time.last()) else { return };
        let period = self.share * (last - first);
        for (reading, t) in state.reading.iter_mut().zip(time) {
            *reading += size * (self.square * (TAU * (t - first) / period + self.phase).sin()).tanh();
        }
    }
}
