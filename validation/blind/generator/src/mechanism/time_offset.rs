//! `time_offset`: the clock of the response is late or early against that of the load.
//!
//! Limits: linear between samples, held at the ends of a run; load and temperature share one clock. The size is the shift, s.

use super::{Mechanism, Numbers, numbers};
use crate::draws::Draws;
use crate::state::{Scene, State};
use std::ops::Range;

/// Late (+) or early (-).
#[derive(Debug, Clone)]
pub struct TimeOffset {
    sign: f64,
}

/// Draws the sign.
pub fn draw(draws: &mut Draws) -> Box<dyn Mechanism> {
    Box::new(TimeOffset { sign: draws.sign() })
}

impl Mechanism for TimeOffset {
    fn id(&self) -> &'static str {
        "time_offset"
    }
    fn size_start(&self) -> f64 {
        2e-4
    }
    fn size_limit(&self) -> f64 {
        2.0
    }
    fn numbers(&self, size: f64) -> Numbers {
        numbers([("response_late_s", self.sign * size)])
    }
    fn readout(&self, size: f64, scene: Scene, state: &mut State) {
        let sharp = state.reading.clone();
        for run in scene.history.runs() {
            for row in run.clone() {
                let then = scene.history.time[row] - self.sign * size;
                state.reading[row] = at(&scene.history.time, &sharp, run.clone(), then);
            }
        }
    }
}

/// `values` at `then`, linear between the rows of `run`.
pub(crate) fn at(time: &[f64], values: &[f64], run: Range<usize>, then: f64) -> f64 {
    let after = run.start + time[run.clone()].partition_point(|t| *t < then);
    if after == run.start {
        return values[run.start];
    }
    if after == run.end {
        return values[run.end - 1];
    }
    let share = (then - time[after - 1]) / (time[after] - time[after - 1]);
    values[after - 1] + share * (values[after] - values[after - 1])
}
