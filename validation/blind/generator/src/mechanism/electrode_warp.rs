//! `electrode_warp`: the electrode bends with temperature, and the declared base model leaves that out.
//!
//! Limits: the size is the share of the free bimetal's curvature that the beads let through; above 1 the layers differ from their data.

use super::{Mechanism, Needs, Numbers, numbers};
use crate::draws::Draws;
use crate::physics::warp::curvature;
use crate::state::{Scene, State};

/// Curvature as a share of the free one.
#[derive(Debug, Clone)]
pub struct ElectrodeWarp;

/// Nothing to draw.
pub fn draw(_: &mut Draws) -> Box<dyn Mechanism> {
    Box::new(ElectrodeWarp)
}

impl Mechanism for ElectrodeWarp {
    fn id(&self) -> &'static str {
        "electrode_warp"
    }
    fn size_start(&self) -> f64 {
        0.1
    }
    fn size_limit(&self) -> f64 {
        1.3
    }
    fn needs(&self) -> Needs {
        Needs { no_warp: true, ..Needs::default() }
    }
    fn numbers(&self, size: f64) -> Numbers {
        numbers([("share_of_free_curvature", size)])
    }
    fn geometry(&self, size: f64, scene: Scene, state: &mut State) {
        for (gap, temperature) in state.gap.iter_mut().zip(&state.temperature) {
            gap.curvature += size * curvature(scene.sensor, *temperature);
        }
    }
}
