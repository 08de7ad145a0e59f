//! `strain_stiffening`: bonded, nearly incompressible beads stiffen as their shape factor grows under load.
//!
//! Limits: modulus proportional to a power of the shape factor; the power 2 is the thin-disc limit (Gent and Lindley, 1959).

use super::{Mechanism, Numbers, numbers};
use crate::draws::Draws;
use crate::state::{Scene, State};

/// The size is the power of S(e)/S(0).
#[derive(Debug, Clone)]
pub struct StrainStiffening;

/// Nothing to draw.
pub fn draw(_: &mut Draws) -> Box<dyn Mechanism> {
    Box::new(StrainStiffening)
}

impl Mechanism for StrainStiffening {
    fn id(&self) -> &'static str {
        "strain_stiffening"
    }
    fn size_start(&self) -> f64 {
        0.02
    }
    fn size_limit(&self) -> f64 {
        4.0
    }
    fn numbers(&self, size: f64) -> Numbers {
        numbers([("shape_factor_power", size)])
    }
    fn stiffness(&self, size: f64, _: Scene, state: &mut State) {
        state.stiffening += size;
    }
}
