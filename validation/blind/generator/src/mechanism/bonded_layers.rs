//! `bonded_layers`: beads bonded to both plates stiffen as they get flatter and, hardly compressible, push the plates apart when heated.
//!
//! Limits: a power of the shape factor, and the expansion of the bonded share upwards; the size is that power.

use crate::draws::Draws;
use crate::mechanism::{Mechanism, Numbers, numbers};
use crate::physics::constants::{EXPANSION_RTV, REFERENCE};
use crate::state::{Scene, State};

/// Share of the sideways expansion that a bond turns upwards.
#[derive(Debug, Clone)]
pub struct BondedLayers {
    upwards: f64,
}

/// Draws its shape.
pub fn draw(draws: &mut Draws) -> Box<dyn Mechanism> {
    Box::new(BondedLayers { upwards: draws.between(0.3, 0.8) })
}

impl Mechanism for BondedLayers {
    fn id(&self) -> &'static str {
        "bonded_layers"
    }
    fn size_start(&self) -> f64 {
        0.002
    }
    fn size_limit(&self) -> f64 {
        2.0
    }
    fn numbers(&self, size: f64) -> Numbers {
        numbers([("power", size), ("share_upwards", self.upwards)])
    }
    fn stiffness(&self, size: f64, _: Scene, state: &mut State) {
        state.stiffening += size;
    }
    fn geometry(&self, size: f64, _: Scene, state: &mut State) {
        for (gap, temperature) in state.gap.iter_mut().zip(&state.temperature) {
            // both directions in the plane go upwards where the bead cannot widen
            gap.mean *= 1.0 + size * 2.0 * self.upwards * EXPANSION_RTV * (temperature - REFERENCE);
        }
    }
}
