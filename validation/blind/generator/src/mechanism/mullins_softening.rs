//! `mullins_softening`: below the greatest load ever the beads are softer, in the manner of Ogden and Roxburgh (energies, not loads).
//!
//! Limits: on first loading nothing is softer; the greatest load is remembered for good, through all runs.

use super::{Mechanism, Numbers, numbers};
use crate::draws::Draws;
use crate::state::{Scene, State};

/// Factor on the modulus `1 - s tanh((Wm - W) / (m + b Wm))`, W the load squared (energy of a linear bead), Wm its greatest value.
///
/// **Source:** Ogden and Roxburgh, Proc. R. Soc. A 455 (1999) 2861, with tanh for erf.
#[derive(Debug, Clone)]
pub struct Mullins {
    energy: f64,
    slope: f64,
}

/// Draws m (N^2) and b.
pub fn draw(draws: &mut Draws) -> Box<dyn Mechanism> {
    Box::new(Mullins { energy: draws.between(0.5, 4.0), slope: draws.between(0.1, 0.5) })
}

impl Mechanism for Mullins {
    fn id(&self) -> &'static str {
        "mullins_softening"
    }
    fn size_start(&self) -> f64 {
        0.003
    }
    fn size_limit(&self) -> f64 {
        0.6
    }
    fn numbers(&self, size: f64) -> Numbers {
        numbers([("depth", size), ("energy_scale_n2", self.energy), ("slope", self.slope)])
    }
    fn stiffness(&self, size: f64, _: Scene, state: &mut State) {
        let mut greatest = 0.0_f64;
        for (stiffness, force) in state.stiffness.iter_mut().zip(&state.force) {
            let energy = force * force;
            greatest = greatest.max(energy);
            *stiffness *= 1.0 - size * ((greatest - energy) / (self.energy + self.slope * greatest)).tanh();
        }
    }
}
