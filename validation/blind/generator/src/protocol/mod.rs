//! Protocols: what is done to the sensor, run after run.
//!
//! Limits: between runs the sensor rests unloaded for fifteen minutes; drawn protocols vary levels, rates and lengths, not their idea.

use crate::draws::Draws;
use crate::history::History;
use std::f64::consts::TAU;

pub mod kind;
pub mod piece;
pub mod plans;
mod unplanned;

pub use kind::Kind;

/// Rest between two runs, s.
const REST: f64 = 900.0;

impl Kind {
    /// The history that this kind gives; `vary` draws levels, rates and lengths, otherwise they are those of the open recordings.
    pub fn history(self, vary: bool, draws: &mut Draws) -> History {
        let runs = plans::plan(self, vary, draws);
        let mut history = History::default();
        let mut clock = 0.0;
        for (number, run) in runs.iter().enumerate() {
            for row in 0..run.rows() {
                history.run.push(number as u32 + 1);
                history.time.push(to_milliseconds(clock + run.time[row]));
                history.force.push(run.force[row]);
                history.temperature.push(run.temperature[row]);
            }
            clock += run.time.last().copied().unwrap_or(0.0) + REST;
        }
        history.humidity = humidity(&history.time, draws);
        history
    }
}

/// Time on the grid of the recordings.
fn to_milliseconds(time: f64) -> f64 {
    (time * 1000.0).round() / 1000.0
}

/// Relative humidity of the room, %: two slow tones about a mean.
fn humidity(time: &[f64], draws: &mut Draws) -> Vec<f64> {
    let mean = draws.between(40.0, 58.0);
    let tones: Vec<(f64, f64, f64)> = [(4.0, 14.0, 150.0, 500.0), (3.0, 8.0, 600.0, 6000.0)]
        .into_iter()
        .map(|(low, high, short, long)| (draws.between(low, high), draws.log_between(short, long), draws.between(0.0, TAU)))
        .collect();
    let tone = |t: f64| tones.iter().map(|(height, period, phase)| height * (TAU * t / period + phase).sin()).sum::<f64>();
    time.iter().map(|&t| mean + tone(t)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn unvaried_protocols_have_the_rows_of_the_open_recordings() {
        for (kind, rows) in [(Kind::Full, 7120), (Kind::Thermal, 4440), (Kind::Mechanical, 4400)] {
            assert_eq!(kind.history(false, &mut Draws::of(1, "rows")).rows(), rows);
        }
    }

    #[test]
    fn every_protocol_stays_in_range_and_runs_forward() {
        for seed in 0..20 {
            for kind in Kind::ALL.into_iter().chain(Kind::WILD) {
                let history = kind.history(true, &mut Draws::of(seed, "range"));
                assert!(history.time.windows(2).all(|w| w[1] > w[0]), "{kind:?}");
                assert!(history.force.iter().all(|f| (0.0..=4.5 + 1e-9).contains(f)), "{kind:?}");
                assert!(history.temperature.iter().all(|t| (5.0..=60.0).contains(t)), "{kind:?}");
                assert!(history.humidity.iter().all(|h| (5.0..=95.0).contains(h)), "{kind:?}");
                assert!(history.rows() >= 150);
            }
        }
    }
}
