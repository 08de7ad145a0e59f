//! `readout_lag`: the electronics low-pass the reading through two equal poles.
//!
//! Limits: exact for readings that are linear between samples; settled at the first sample of a run. The size is the mean delay, s.

use super::{Mechanism, Numbers, numbers};
use crate::draws::Draws;
use crate::physics::memory::relax;
use crate::state::{Scene, State};

/// Two poles of half the delay each; the ramp between samples is cut in four so that the second pole sees its curved input.
#[derive(Debug, Clone)]
pub struct ReadoutLag;

const PIECES: i32 = 4;

/// Nothing to draw.
pub fn draw(_: &mut Draws) -> Box<dyn Mechanism> {
    Box::new(ReadoutLag)
}

impl Mechanism for ReadoutLag {
    fn id(&self) -> &'static str {
        "readout_lag"
    }
    fn size_start(&self) -> f64 {
        2e-4
    }
    fn size_limit(&self) -> f64 {
        3.0
    }
    fn numbers(&self, size: f64) -> Numbers {
        numbers([("delay_s", size)])
    }
    fn readout(&self, size: f64, scene: Scene, state: &mut State) {
        let sharp = state.reading.clone();
        for run in scene.history.runs() {
            let (mut first, mut second) = (sharp[run.start], sharp[run.start]);
            for row in run.start + 1..run.end {
                let dt = (scene.history.time[row] - scene.history.time[row - 1]) / f64::from(PIECES);
                for piece in 0..PIECES {
                    let at = |k: i32| sharp[row - 1] + (sharp[row] - sharp[row - 1]) * f64::from(k) / f64::from(PIECES);
                    let before = first;
                    first = relax(first, at(piece), at(piece + 1), dt, 0.5 * size);
                    second = relax(second, before, first, dt, 0.5 * size);
                }
                state.reading[row] = second;
            }
        }
    }
}
