//! `dead_gap`: air between beads and electrode that never closes (roughness, a bowed film), in series at every point of the plate.
//!
//! Limits: same thickness everywhere and at every load; the size is that thickness in m. Calibration hides most of it.

use super::{Mechanism, Numbers, numbers};
use crate::draws::Draws;
use crate::state::{Scene, State};

/// Constant air gap.
#[derive(Debug, Clone)]
pub struct DeadGap;

/// Nothing to draw.
pub fn draw(_: &mut Draws) -> Box<dyn Mechanism> {
    Box::new(DeadGap)
}

impl Mechanism for DeadGap {
    fn id(&self) -> &'static str {
        "dead_gap"
    }
    fn size_start(&self) -> f64 {
        1e-6
    }
    fn size_limit(&self) -> f64 {
        120e-6
    }
    fn numbers(&self, size: f64) -> Numbers {
        numbers([("thickness_um", size * 1e6)])
    }
    fn geometry(&self, size: f64, _: Scene, state: &mut State) {
        state.gap.iter_mut().for_each(|gap| gap.dead += size);
    }
}
