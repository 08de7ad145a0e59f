//! `fringing_field`: field outside the rim, by Kirchhoff's edge formula for a disc capacitor.
//!
//! Limits: thin plates in one medium; the size multiplies Kirchhoff's value (a shield above the plate and thick metal raise it).

use super::{Mechanism, Numbers, numbers};
use crate::draws::Draws;
use crate::physics::{constants::EPS0, layers::radius};
use crate::state::{Scene, State};
use std::f64::consts::PI;

/// `C_edge = eps0 r (ln(16 pi r / d) - 1)`.
///
/// **Source:** Landau and Lifshitz, Electrodynamics of Continuous Media, paragraph 3, problem (Kirchhoff 1877).
#[derive(Debug, Clone)]
pub struct FringingField;

/// Nothing to draw.
pub fn draw(_: &mut Draws) -> Box<dyn Mechanism> {
    Box::new(FringingField)
}

impl Mechanism for FringingField {
    fn id(&self) -> &'static str {
        "fringing_field"
    }
    fn size_start(&self) -> f64 {
        0.3
    }
    fn size_limit(&self) -> f64 {
        6.0
    }
    fn numbers(&self, size: f64) -> Numbers {
        numbers([("over_kirchhoff", size)])
    }
    fn field(&self, size: f64, scene: Scene, state: &mut State) {
        for row in 0..state.reading.len() {
            let r = radius(scene.sensor, state.temperature[row]);
            let gap = state.gap[row].mean + state.gap[row].dead;
            state.reading[row] += size * 1e12 * EPS0 * r * ((16.0 * PI * r / gap).ln() - 1.0);
        }
    }
}
