//! `converter_memory`: the capacitor of the converter keeps a share of the conversion before.
//!
//! Limits: by rows and not by time, whatever lies between them; the first row of a run is right. The size is the share kept.

use crate::draws::Draws;
use crate::mechanism::{Mechanism, Numbers, numbers};
use crate::state::{Scene, State};

/// Nothing to draw.
#[derive(Debug, Clone)]
pub struct ConverterMemory;

/// Draws its shape.
pub fn draw(_: &mut Draws) -> Box<dyn Mechanism> {
    Box::new(ConverterMemory)
}

impl Mechanism for ConverterMemory {
    fn id(&self) -> &'static str {
        "converter_memory"
    }
    fn size_start(&self) -> f64 {
        1e-4
    }
    fn size_limit(&self) -> f64 {
        0.9
    }
    fn numbers(&self, size: f64) -> Numbers {
        numbers([("share_kept", size)])
    }
    fn readout(&self, size: f64, scene: Scene, state: &mut State) {
        let true_pf = state.reading.clone();
        for run in scene.history.runs() {
            for row in run.skip(1) {
                state.reading[row] += size * (state.reading[row - 1] - true_pf[row]);
            }
        }
    }
}
