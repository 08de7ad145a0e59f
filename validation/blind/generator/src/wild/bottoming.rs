//! `bottoming`: beyond a certain compression the beads meet a hard stop (a spacer, a grain of dirt) and give way less.
//!
//! Limits: a soft knee; nothing to see below it. The size is the share of the further compression that is lost.

use super::softplus;
use crate::draws::Draws;
use crate::mechanism::{Mechanism, Numbers, numbers};
use crate::state::{Scene, State};

/// Where the stop is, as a share of the largest compression, and how sharp.
#[derive(Debug, Clone)]
pub struct Bottoming {
    stop: f64,
    sharp: f64,
}

/// Draws its shape.
pub fn draw(draws: &mut Draws) -> Box<dyn Mechanism> {
    Box::new(Bottoming { stop: draws.between(0.5, 0.8), sharp: draws.between(0.02, 0.06) })
}

impl Mechanism for Bottoming {
    fn id(&self) -> &'static str {
        "bottoming"
    }
    fn size_start(&self) -> f64 {
        1e-3
    }
    fn size_limit(&self) -> f64 {
        0.9
    }
    fn numbers(&self, size: f64) -> Numbers {
        numbers([("share_lost", size), ("stop_share", self.stop)])
    }
    fn strain(&self, size: f64, _: Scene, state: &mut State) {
        let most = state.compression.iter().copied().fold(0.0, f64::max);
        let width = self.sharp * most;
        if width > 0.0 {
            for e in &mut state.compression {
                *e -= size * softplus((*e - self.stop * most) / width) * width;
            }
        }
    }
}
