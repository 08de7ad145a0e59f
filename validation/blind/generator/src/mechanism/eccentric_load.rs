//! `eccentric_load`: the load acts off centre, the plate tilts on its bed of beads, the gap becomes a wedge.
//!
//! Limits: linear bed; the rim on the loaded side must stay open. The wedge is integrated over the plate numerically.

use super::{Mechanism, Numbers, numbers};
use crate::draws::Draws;
use crate::state::{Scene, State};

/// Moment F x on a bed of stiffness k per area: slope F x / (k pi r^4 / 4), so the rim moves by 4 (x/r) of the mean compression.
#[derive(Debug, Clone)]
pub struct EccentricLoad;

/// Nothing to draw.
pub fn draw(_: &mut Draws) -> Box<dyn Mechanism> {
    Box::new(EccentricLoad)
}

impl Mechanism for EccentricLoad {
    fn id(&self) -> &'static str {
        "eccentric_load"
    }
    fn size_start(&self) -> f64 {
        0.1
    }
    fn size_limit(&self) -> f64 {
        0.8
    }
    fn numbers(&self, size: f64) -> Numbers {
        numbers([("offset_over_radius", size)])
    }
    fn geometry(&self, size: f64, scene: Scene, state: &mut State) {
        for (gap, compression) in state.gap.iter_mut().zip(&state.compression) {
            gap.tilt += 4.0 * size * compression * scene.sensor.height_rtv;
        }
    }
}
