//! `thermal_lag`: heat diffuses into the sensor as into a slab warmed on one face; the model sees the slab's mean temperature.
//!
//! Limits: 12 eigenmodes; a run starts in equilibrium. The size is the slowest mode's time constant in seconds.

use super::{Mechanism, Numbers, numbers};
use crate::draws::Draws;
use crate::physics::memory::relax;
use crate::state::{Scene, State};
use std::f64::consts::PI;

const MODES: i32 = 12;

/// Mean temperature of a slab, other face insulated: sum of 8/(pi (2n-1))^2 of first-order lags tau / (2n-1)^2.
///
/// **Source:** Carslaw and Jaeger, Conduction of Heat in Solids, 3.4; the rest of the sum is taken as instantaneous.
#[derive(Debug, Clone)]
pub struct ThermalLag;

/// Nothing to draw.
pub fn draw(_: &mut Draws) -> Box<dyn Mechanism> {
    Box::new(ThermalLag)
}

impl Mechanism for ThermalLag {
    fn id(&self) -> &'static str {
        "thermal_lag"
    }
    fn size_start(&self) -> f64 {
        2.0
    }
    fn size_limit(&self) -> f64 {
        400.0
    }
    fn numbers(&self, size: f64) -> Numbers {
        numbers([("slowest_time_s", size)])
    }
    fn inputs(&self, size: f64, scene: Scene, state: &mut State) {
        let outside = state.temperature.clone();
        let odd = (0..MODES).map(|n| f64::from(2 * n + 1));
        let modes: Vec<(f64, f64)> = odd.map(|k| (8.0 / (PI * k * PI * k), size / (k * k))).collect();
        let fast = 1.0 - modes.iter().map(|(share, _)| share).sum::<f64>();
        for run in scene.history.runs() {
            let mut inside = vec![outside[run.start]; modes.len()];
            for row in run.start + 1..run.end {
                let dt = scene.history.time[row] - scene.history.time[row - 1];
                let mut mean = fast * outside[row];
                for (q, (share, tau)) in inside.iter_mut().zip(&modes) {
                    *q = relax(*q, outside[row - 1], outside[row], dt, *tau);
                    mean += share * *q;
                }
                state.temperature[row] = mean;
            }
        }
    }
}
