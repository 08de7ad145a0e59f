//! `trapped_air_stiffness`: air shut in between the beads is squeezed (Boyle), warms up and leaks out.
//!
//! Limits: ideal gas, isothermal with the sensor, leak proportional to the pressure difference; at ambient pressure when a run starts.

use super::{Mechanism, Numbers, numbers};
use crate::draws::Draws;
use crate::physics::beads::{area, resistance, root, young};
use crate::physics::constants::{ATMOSPHERE, ZERO_CELSIUS};
use crate::physics::layers::radius;
use crate::state::{Scene, State};
use std::f64::consts::PI;

/// Leak time; the size is the share of the plate's free area that is sealed.
#[derive(Debug, Clone)]
pub struct TrappedAir {
    leak: f64,
}

/// Draws the leak time, s.
pub fn draw(draws: &mut Draws) -> Box<dyn Mechanism> {
    Box::new(TrappedAir { leak: draws.log_between(2.0, 60.0) })
}

impl Mechanism for TrappedAir {
    fn id(&self) -> &'static str {
        "trapped_air_stiffness"
    }
    fn size_start(&self) -> f64 {
        0.002
    }
    fn size_limit(&self) -> f64 {
        0.6
    }
    fn numbers(&self, size: f64) -> Numbers {
        numbers([("sealed_share", size), ("leak_time_s", self.leak)])
    }
    fn strain(&self, size: f64, scene: Scene, state: &mut State) {
        for run in scene.history.runs() {
            let start = state.temperature[run.start] + ZERO_CELSIUS;
            let (mut amount, mut over) = (1.0, 0.0);
            for row in run.clone() {
                if row > run.start {
                    let dt = scene.history.time[row] - scene.history.time[row - 1];
                    amount -= over * -(-dt / self.leak).exp_m1();
                }
                let warm = (state.temperature[row] + ZERO_CELSIUS) / start;
                let e = squeezed(size * pressing_area(scene, state, row), amount * warm, state, scene, row);
                // Mol that would have to leave for the pressure to be the atmosphere's.
                over = amount - (1.0 - e) / warm;
                state.compression[row] = e;
            }
        }
    }
}

fn pressing_area(scene: Scene, state: &State, row: usize) -> f64 {
    let r = radius(scene.sensor, state.temperature[row]);
    PI * r * r - area(scene.sensor, state.temperature[row])
}

/// Compression at which beads and air together carry the load.
fn squeezed(sealed: f64, gas: f64, state: &State, scene: Scene, row: usize) -> f64 {
    let temperature = state.temperature[row];
    let beads = area(scene.sensor, temperature) * young(scene.sensor, temperature) * state.stiffness[row];
    let air = sealed * ATMOSPHERE / beads;
    let load = state.bead_load(scene.sensor, row);
    root(|e| resistance(e, state.stiffening) + air * (gas / (1.0 - e) - 1.0) - load, state.compression[row])
}
