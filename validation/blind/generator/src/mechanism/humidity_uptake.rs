//! `humidity_uptake`: polyimide takes up water by a Freundlich isotherm, at once or after diffusing into the film.
//!
//! Limits: one mode of diffusion; in equilibrium when a run starts. The size is the relative change of permittivity from dry to wet.

use super::{Mechanism, Needs, Numbers, numbers};
use crate::draws::Draws;
use crate::physics::memory::relax;
use crate::state::{Scene, State};

/// Reference humidity, share.
const REFERENCE: f64 = 0.5;

/// Isotherm `h^q` and diffusion time.
#[derive(Debug, Clone)]
pub struct HumidityUptake {
    power: f64,
    time: f64,
}

/// Draws the isotherm's power and, half the time, a lag in s.
pub fn draw(draws: &mut Draws) -> Box<dyn Mechanism> {
    let time = if draws.chance(0.5) { draws.log_between(10.0, 120.0) } else { 0.0 };
    Box::new(HumidityUptake { power: draws.between(0.8, 1.3), time })
}

impl Mechanism for HumidityUptake {
    fn id(&self) -> &'static str {
        "humidity_uptake"
    }
    fn size_start(&self) -> f64 {
        5e-6
    }
    fn size_limit(&self) -> f64 {
        0.3
    }
    fn needs(&self) -> Needs {
        Needs { humidity: true, ..Needs::default() }
    }
    fn numbers(&self, size: f64) -> Numbers {
        numbers([
            ("relative_permittivity_change_dry_to_wet", size),
            ("isotherm_power", self.power),
            ("diffusion_time_s", self.time),
        ])
    }
    fn dielectric(&self, size: f64, scene: Scene, state: &mut State) {
        let air: Vec<f64> = scene.history.humidity.iter().map(|h| h / 100.0).collect();
        for run in scene.history.runs() {
            let mut film = air[run.start];
            for row in run.clone() {
                if row > run.start {
                    let dt = scene.history.time[row] - scene.history.time[row - 1];
                    film = relax(film, air[row - 1], air[row], dt, self.time);
                }
                state.polyimide[row] *= 1.0 + size * (film.powf(self.power) - REFERENCE.powf(self.power));
            }
        }
    }
}
