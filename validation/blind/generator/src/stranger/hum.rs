//! `hum`: interference of constant frequency, aliased by the sampling.
//!
//! Limits: one tone.

use super::{LIMIT_PF, START_PF};
use crate::draws::Draws;
use crate::mechanism::{Mechanism, Numbers, numbers};
use crate::state::{Scene, State};
use std::f64::consts::TAU;

/// A tone `s sin(2 pi f t + phase)`.
#[derive(Debug, Clone)]
pub struct Hum {
    frequency: f64,
    phase: f64,
}

/// Draws its shape.
pub fn draw(draws: &mut Draws) -> Box<dyn Mechanism> {
    Box::new(Hum { frequency: draws.log_between(0.11, 0.9), phase: draws.between(0.0, TAU) })
}

impl Mechanism for Hum {
    fn id(&self) -> &'static str {
        "hum"
    }
    fn size_start(&self) -> f64 {
        START_PF
    }
    fn size_limit(&self) -> f64 {
        LIMIT_PF
    }
    fn numbers(&self, size: f64) -> Numbers {
        numbers([("amplitude_pf", size), ("frequency_hz", self.frequency)])
    }
    fn readout(&self, size: f64, scene: Scene, state: &mut State) {
        for (reading, time) in state.reading.iter_mut().zip(&scene.history.time) {
            *reading += size * (TAU * self.frequency * time + self.phase).sin();
        }
    }
}
