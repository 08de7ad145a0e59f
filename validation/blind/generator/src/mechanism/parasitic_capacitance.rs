//! `parasitic_capacitance`: a constant capacitance beside the sensor, larger than the stray that the maker allows for.
//!
//! Limits: constant, so calibration hides it almost wholly in the stray: little is seen in the residual, most in the conflict with the tolerances.

use super::{Mechanism, Numbers, numbers};
use crate::draws::Draws;
use crate::state::{Scene, State};

/// The size is the capacitance, pF.
#[derive(Debug, Clone)]
pub struct ParasiticCapacitance {
    sign: f64,
}

/// Draws the sign (a compensated zero can be over-compensated, rarely).
pub fn draw(draws: &mut Draws) -> Box<dyn Mechanism> {
    Box::new(ParasiticCapacitance { sign: if draws.chance(0.8) { 1.0 } else { -1.0 } })
}

impl Mechanism for ParasiticCapacitance {
    fn id(&self) -> &'static str {
        "parasitic_capacitance"
    }
    fn size_start(&self) -> f64 {
        0.5
    }
    fn size_limit(&self) -> f64 {
        80.0
    }
    fn numbers(&self, size: f64) -> Numbers {
        numbers([("capacitance_pf", self.sign * size)])
    }
    fn field(&self, size: f64, _: Scene, state: &mut State) {
        state.reading.iter_mut().for_each(|reading| *reading += self.sign * size);
    }
}
