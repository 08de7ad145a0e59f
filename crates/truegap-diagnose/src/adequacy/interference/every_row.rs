//! Interference on every row of a recording, where means of rows would take it out: bursts, and a tone.
//!
//! Neither is anything that a model lacks, so they take no part in naming; where nothing else is found, they are what there is to say.
//! Where the noise was not measured, nobody knows how loud it is: rows that are louder than the rest are noise then, and only a tone counts.
//!
//! Limits: judged on what one model leaves.

use crate::{
    adequacy::{
        interference::{burst::Burst, tone::Tone},
        lack_of_fit::Adequacy,
    },
    stats::excess_of,
};
use std::ops::Range;
use truegap_core::Inputs;

/// The loudest of each.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Interference {
    /// rows that are louder than the noise
    pub burst: Burst,
    /// interference of a constant frequency
    pub tone: Tone,
    /// what is known of the noise
    pub level: Level,
}

/// What is known of how loud the noise is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Level {
    /// factor by which its variance may be larger than taken
    pub slack: f64,
    /// root mean square, in noise of a row, that rows may have by the steps of the reading alone
    pub steps: f64,
    /// whether it was measured apart from what a model leaves
    pub is_known: bool,
}

impl Interference {
    /// In the whitened residual of every row of a recording.
    pub fn of(residual: &[f64], inputs: &Inputs, runs: &[Range<usize>], level: Level) -> Self {
        let tone = Tone::strongest(residual, inputs.time_s.as_deref(), runs);
        Self { burst: Burst::loudest(residual, runs, level.slack), tone, level }
    }

    /// How much the stronger of the two holds, in units of the noise variance; the burst alone where the tone is `told_apart`.
    pub fn excess(&self, told_apart: bool) -> f64 {
        let burst = if self.bursts() { self.burst.rows as f64 * (self.burst.loudness.powi(2) - 1.0) } else { 0.0 };
        let tone = if self.tone.is_significant() && !told_apart { excess_of(self.tone.p_value) } else { 0.0 };
        burst.max(tone)
    }

    /// Whether it is what there is to say of a recording in which nothing is named, `before` the adequacy of the base model: a mismatch that other tests see is
    /// louder in some rows, too.
    pub fn is_the_matter(&self, before: &Adequacy) -> bool {
        self.tone.is_significant() || (self.bursts() && !before.fires())
    }

    /// Whether there is any.
    pub fn is_anything(&self) -> bool {
        self.bursts() || self.tone.is_significant()
    }

    /// Whether rows are louder than a noise that is known, and than steps of the reading make them.
    fn bursts(&self) -> bool {
        self.level.is_known && self.burst.is_significant() && self.burst.loudness > self.level.steps
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn interference(noise_is_known: bool, loudness: f64, tone: f64) -> Interference {
        let burst = Burst { row: 40, rows: 8, loudness, p_value: if loudness > 2.0 { 1e-12 } else { 0.5 } };
        let tone = Tone { per_row: 0.1, frequency_hz: None, amplitude: 0.2, p_value: tone, steady: false };
        Interference { burst, tone, level: Level { slack: 1.0, steps: 0.0, is_known: noise_is_known } }
    }

    /// A log of a flight: rows in a turn are thirteen times as loud as those between. Where nothing but the log says how loud the noise is, that is noise; a tone is none in either case.
    #[test]
    fn loud_rows_count_where_the_noise_was_measured() {
        let measured = interference(true, 13.0, 1.0);
        assert!(measured.is_anything());
        approx::assert_relative_eq!(measured.excess(false), 8.0 * 168.0, max_relative = 1e-12);
        let taken_from_the_rest = interference(false, 13.0, 1.0);
        assert!(!taken_from_the_rest.is_anything());
        assert_eq!(taken_from_the_rest.excess(false), 0.0);
        assert!(interference(false, 13.0, 1e-12).is_anything() && interference(false, 13.0, 1e-12).excess(false) > 0.0);
        assert_eq!(interference(false, 13.0, 1e-12).excess(true), 0.0);
    }

    /// A reading in coarse steps errs by half of one in all rows of a hold.
    #[test]
    fn rows_within_half_a_step_of_the_reading_are_no_burst() {
        let found = interference(true, 3.6, 1.0);
        let in_steps = |steps: f64| Interference { level: Level { steps, ..found.level }, ..found };
        assert!(in_steps(3.0).is_anything() && !in_steps(4.9).is_anything());
    }
}
