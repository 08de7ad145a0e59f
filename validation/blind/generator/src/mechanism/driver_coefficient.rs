//! `driver_coefficient`: the reading follows the supply of the electronics, which is recorded.
//!
//! Limits: slightly bent, at once; the supply sags and recovers in three slow tones. The size is the change per volt, pF.

use crate::draws::Draws;
use crate::history::History;
use crate::mechanism::{Mechanism, Numbers, numbers};
use crate::recording::Column;
use crate::state::{Scene, State};
use std::f64::consts::TAU;

/// Sign, bend (1/V), and the tones of the supply: height (V), period (s), phase.
#[derive(Debug, Clone)]
pub struct DriverCoefficient {
    sign: f64,
    bend: f64,
    tones: Vec<[f64; 3]>,
}

/// Draws its shape.
pub fn draw(draws: &mut Draws) -> Box<dyn Mechanism> {
    let tones = [(0.02, 90.0), (0.05, 700.0), (0.1, 4000.0)];
    let tones = tones.map(|(v, s)| [v * draws.between(0.6, 1.5), s * draws.between(0.6, 1.5), draws.between(0.0, TAU)]).to_vec();
    Box::new(DriverCoefficient { sign: draws.sign(), bend: draws.between(-0.3, 0.3), tones })
}

/// Supply at which the electronics were adjusted, V.
const NOMINAL: f64 = 3.3;

impl DriverCoefficient {
    /// Voltage of the supply, one entry a row.
    fn supply(&self, history: &History) -> Vec<f64> {
        let at = |t: &f64| self.tones.iter().map(|[v, s, phase]| v * (TAU * t / s + phase).sin()).sum::<f64>();
        history.time.iter().map(|t| NOMINAL + at(t)).collect()
    }
}

impl Mechanism for DriverCoefficient {
    fn id(&self) -> &'static str {
        "driver_coefficient"
    }
    fn size_start(&self) -> f64 {
        1e-4
    }
    fn size_limit(&self) -> f64 {
        2.0
    }
    fn numbers(&self, size: f64) -> Numbers {
        numbers([("pf_per_volt", self.sign * size), ("bend_per_volt", self.bend)])
    }
    fn records(&self, history: &History) -> Option<Column> {
        Some(Column { name: "supply".into(), unit: "V".into(), values: self.supply(history) })
    }
    fn readout(&self, size: f64, scene: Scene, state: &mut State) {
        for (reading, volt) in state.reading.iter_mut().zip(self.supply(scene.history)) {
            let over = volt - NOMINAL;
            *reading += self.sign * size * over * (1.0 + self.bend * over);
        }
    }
}
