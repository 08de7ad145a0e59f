//! `converter_ripple`: a converter whose codes cluster: an error periodic in the reading itself.
//!
//! Limits: one harmonic.

use super::{LIMIT_PF, START_PF};
use crate::draws::Draws;
use crate::mechanism::{Mechanism, Numbers, numbers};
use crate::state::{Scene, State};
use std::f64::consts::TAU;

/// `s sin(2 pi C / P + phase)`.
#[derive(Debug, Clone)]
pub struct ConverterRipple {
    period: f64,
    phase: f64,
}

/// Draws its shape.
pub fn draw(draws: &mut Draws) -> Box<dyn Mechanism> {
    Box::new(ConverterRipple { period: draws.between(0.06, 0.3), phase: draws.between(0.0, TAU) })
}

impl Mechanism for ConverterRipple {
    fn id(&self) -> &'static str {
        "converter_ripple"
    }
    fn size_start(&self) -> f64 {
        START_PF
    }
    fn size_limit(&self) -> f64 {
        LIMIT_PF
    }
    fn numbers(&self, size: f64) -> Numbers {
        numbers([("amplitude_pf", size), ("period_pf", self.period)])
    }
    fn readout(&self, size: f64, _: Scene, state: &mut State) {
        for reading in &mut state.reading {
            *reading += size * (TAU * *reading / self.period + self.phase).sin();
        }
    }
}
