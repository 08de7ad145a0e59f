//! `motor_pickup`: the motor that loads the sensor disturbs the reading while it turns, by the root of its speed.
//!
//! Limits: even in the rate, so that no lag explains it. The size is the disturbance at one newton a second, pF.

use crate::draws::Draws;
use crate::mechanism::{Mechanism, Numbers, numbers};
use crate::state::{Scene, State};

/// Power of the speed.
#[derive(Debug, Clone)]
pub struct MotorPickup {
    power: f64,
}

/// Draws its shape.
pub fn draw(draws: &mut Draws) -> Box<dyn Mechanism> {
    Box::new(MotorPickup { power: draws.between(0.4, 1.2) })
}

impl Mechanism for MotorPickup {
    fn id(&self) -> &'static str {
        "motor_pickup"
    }
    fn size_start(&self) -> f64 {
        2e-4
    }
    fn size_limit(&self) -> f64 {
        1.0
    }
    fn numbers(&self, size: f64) -> Numbers {
        numbers([("pf_at_a_newton_a_second", size), ("power", self.power)])
    }
    fn readout(&self, size: f64, scene: Scene, state: &mut State) {
        let rate = scene.history.rate(&scene.history.force);
        for (reading, rate) in state.reading.iter_mut().zip(rate) {
            *reading += size * rate.abs().powf(self.power);
        }
    }
}
