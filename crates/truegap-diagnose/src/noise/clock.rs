//! A clock whose stamps were rounded goes evenly again, for the straight lines of an input.
//!
//! Rows every 0.045 s with stamps of two decimals seem to come after 0.04 s and 0.05 s in turn: a straight ramp is crooked against such a clock.
//!
//! Limits: stretches of one pace, of two ticks of the clock or more: where steps are one tick and two, a row may be lost; stamps that jitter by themselves stay as they are.

use crate::noise::{
    denoise::fitted,
    tuning::{COARSEST_TICK, EVEN_STAMPS, FEWEST_STAMPS},
};
use std::ops::Range;

/// Stamps, those of each stretch of one pace on a straight line where rounding alone keeps them off one.
pub fn even(time_s: &[f64], runs: &[Range<usize>]) -> Vec<f64> {
    let mut out = time_s.to_vec();
    for run in runs {
        let stamps = &time_s[run.clone()];
        let mut from = 0;
        while from + 1 < stamps.len() {
            let to = one_pace(stamps, from);
            if let Some(line) = unrounded(&stamps[from..to]) {
                out[run.start + from..run.start + to].copy_from_slice(&line);
            }
            from = to.max(from + 1);
        }
    }
    out
}

/// End of the stretch from a row on in which no step is more than twice as long as another.
fn one_pace(stamps: &[f64], from: usize) -> usize {
    let (mut short, mut long) = (f64::INFINITY, 0.0f64);
    for row in from + 1..stamps.len() {
        let step = stamps[row] - stamps[row - 1];
        let (least, most) = (short.min(step), long.max(step));
        if most > 2.0 * least {
            return row;
        }
        (short, long) = (least, most);
    }
    stamps.len()
}

/// The line of stamps that rounding alone keeps off it; `None` where they keep it already, or something else keeps them off.
fn unrounded(stamps: &[f64]) -> Option<Vec<f64>> {
    if stamps.len() < FEWEST_STAMPS {
        return None;
    }
    let steps = || stamps.windows(2).map(|w| w[1] - w[0]);
    let (short, long) = (steps().fold(f64::INFINITY, f64::min), steps().fold(0.0, f64::max));
    let (tick, slight) = (long - short, 1e-9 * stamps[stamps.len() - 1].abs());
    let on_two = |step: f64| (step - short).abs() <= slight || (step - long).abs() <= slight;
    if tick > COARSEST_TICK * short || tick <= 1e-3 * short || tick <= 4.0 * slight || !steps().all(on_two) {
        return None;
    }
    let line = fitted(stamps, None, 0..stamps.len(), 0, tick);
    (line.farthest <= EVEN_STAMPS).then(|| (0..stamps.len()).map(|row| line.value + line.slope * row as f64).collect())
}

#[cfg(test)]
#[allow(clippy::single_range_in_vec_init)]
mod tests {
    use super::*;

    fn rounded(truth: &[f64], tick: f64) -> Vec<f64> {
        truth.iter().map(|t| (t / tick).round() * tick).collect()
    }

    #[test]
    fn rounded_stamps_are_even_again_and_a_pause_stays() {
        let truth: Vec<f64> = (0..400).map(|row| 2974.0 + 0.045 * f64::from(row) + if row < 200 { 0.0 } else { 60.0 }).collect();
        let time = even(&rounded(&truth, 0.01), &[0..400]);
        // the row at the pause keeps its stamps' rounding, two halves of a tick
        assert!(time.windows(2).take(199).all(|t| (t[1] - t[0] - 0.045).abs() < 1e-4));
        assert!((time[200] - time[199] - 60.045).abs() < 0.01);
    }

    #[test]
    fn stamps_that_jitter_or_keep_a_pace_stay() {
        let even_ones: Vec<f64> = (0..100).map(|row| 0.1 * f64::from(row)).collect();
        let jitter: Vec<f64> = (0..100).map(|row| 0.1 * f64::from(row) + 0.004 * (f64::from(row) * 1.7).sin()).collect();
        // every other row is late by a tick: two steps in turn, and no line within half a tick of a late stamp and an early one
        let late: Vec<f64> = (0..100).map(|row| 0.1 * f64::from(row) + if row % 10 < 5 { 0.01 } else { 0.0 }).collect();
        // a row is lost
        let lost: Vec<f64> = (0..8).map(|row| 0.1 * f64::from(if row < 4 { row } else { row + 1 })).collect();
        for stamps in [even_ones, jitter, late, lost] {
            assert_eq!(even(&stamps, &[0..stamps.len()]), stamps);
        }
    }
}
