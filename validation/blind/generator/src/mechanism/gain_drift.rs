//! `gain_drift`: the gain of the readout about its tared zero follows temperature, slightly bent.
//!
//! Limits: memoryless; the zero is the sensor's own unloaded value at 20 degC. The size is the change per kelvin.

use super::{Mechanism, Numbers, numbers};
use crate::chain::simulate;
use crate::draws::Draws;
use crate::history::History;
use crate::physics::constants::REFERENCE;
use crate::state::{Scene, State};

/// Sign and bend (1/K) of the gain against temperature.
#[derive(Debug, Clone)]
pub struct GainDrift {
    sign: f64,
    bend: f64,
}

/// Draws both.
pub fn draw(draws: &mut Draws) -> Box<dyn Mechanism> {
    Box::new(GainDrift { sign: draws.sign(), bend: draws.between(-0.006, 0.006) })
}

impl Mechanism for GainDrift {
    fn id(&self) -> &'static str {
        "gain_drift"
    }
    fn size_start(&self) -> f64 {
        2e-4
    }
    fn size_limit(&self) -> f64 {
        0.02
    }
    fn numbers(&self, size: f64) -> Numbers {
        numbers([("per_kelvin", self.sign * size), ("bend_per_kelvin", self.bend)])
    }
    fn readout(&self, size: f64, scene: Scene, state: &mut State) {
        let rest =
            History { run: vec![1], time: vec![0.0], force: vec![0.0], temperature: vec![REFERENCE], humidity: vec![50.0] };
        // An untouched sensor at rest is open; should it not be, there is no zero to tare and nothing to drift about.
        let Ok(zero) = simulate(Scene { sensor: scene.sensor, history: &rest }, false, &[]) else { return };
        for (reading, temperature) in state.reading.iter_mut().zip(&scene.history.temperature) {
            let dt = temperature - REFERENCE;
            *reading += self.sign * size * dt * (1.0 + self.bend * dt) * (*reading - zero[0]);
        }
    }
}
