//! Is a tone as strong and in step throughout? Then it is a signal of the electronics: what physics does has its own pace, and stops where nothing moves.
//!
//! Limits: runs sampled evenly; a clock that wanders by a part of the period makes a tone look unsteady.

use crate::adequacy::tuning::{FEWEST_ROWS_OF_A_PART, FREQUENCY_STEPS, PARTS_OF_A_RUN, STEADY_SHARE};
use rustfft::num_complex::Complex;
use std::{f64::consts::TAU, ops::Range};

/// Moments of the rows, in steps of the runs' common pace: those of a clock that counts every row where there is no time.
pub(crate) struct Rows<'a> {
    /// whitened residual
    pub residual: &'a [f64],
    /// times in s, and the common step
    pub time: Option<(&'a [f64], f64)>,
    /// runs of this pace
    pub runs: &'a [&'a Range<usize>],
}

impl Rows<'_> {
    fn moment(&self, row: usize) -> f64 {
        self.time.map_or(row as f64, |(time, step)| time[row] / step)
    }

    /// Complex amplitude of the wave `exp(i TAU per_row moment)` in rows.
    fn amplitude(&self, rows: &Range<usize>, per_row: f64) -> Complex<f64> {
        let sum: Complex<f64> =
            rows.clone().map(|row| Complex::from_polar(self.residual[row], -TAU * per_row * self.moment(row))).sum();
        sum * 2.0 / rows.len() as f64
    }

    /// Squares that waves of this frequency take from the residual, a phase and an amplitude for each run.
    pub(crate) fn power(&self, per_row: f64) -> f64 {
        self.runs.iter().map(|run| 0.5 * run.len() as f64 * self.amplitude(run, per_row).norm_sqr()).sum()
    }

    /// The frequency near `per_row` at which they take most.
    pub(crate) fn nearest(&self, per_row: f64) -> f64 {
        let longest = self.runs.iter().map(|run| run.len()).max().unwrap_or(1) as f64;
        let at = |step: i32| per_row + f64::from(step) / (FREQUENCY_STEPS as f64 * longest);
        let steps = FREQUENCY_STEPS as i32;
        let best = (-steps..=steps).map(|step| (step, self.power(at(step)))).max_by(|a, b| a.1.total_cmp(&b.1));
        best.map_or(per_row, |(step, _)| at(step))
    }

    /// Whether parts of the runs hold the tone of their run in strength and phase; `level` is the spectrum of what surrounds it, 1 for white noise.
    pub(crate) fn hold_it_alike(&self, per_row: f64, level: f64) -> bool {
        let (mut apart, mut freedom, mut parts_seen) = (0.0, 0.0, 0);
        for run in self.runs {
            let count = PARTS_OF_A_RUN.min(run.len() / FEWEST_ROWS_OF_A_PART);
            if count < 2 {
                continue;
            }
            let whole = self.amplitude(run, per_row);
            for part in 0..count {
                let rows = run.start + run.len() * part / count..run.start + run.len() * (part + 1) / count;
                apart += 0.5 * rows.len() as f64 * (self.amplitude(&rows, per_row) - whole).norm_sqr();
            }
            freedom += 2.0 * (count - 1) as f64;
            parts_seen += count;
        }
        // the noise alone sets parts apart by its level for each degree of freedom
        let by_noise = level * (freedom + 3.0 * (2.0 * freedom).sqrt());
        parts_seen >= 4 && apart <= by_noise + STEADY_SHARE * self.power(per_row)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use rand::SeedableRng;
    use rand_chacha::ChaCha8Rng;
    use rand_distr::{Distribution, StandardNormal};

    fn alike(seed: u64, tone: impl Fn(usize) -> f64) -> bool {
        let random = &mut ChaCha8Rng::seed_from_u64(seed);
        let noise = |random: &mut ChaCha8Rng| -> f64 { StandardNormal.sample(random) };
        let residual: Vec<f64> = (0..3000).map(|row| noise(random) + tone(row)).collect();
        let runs = [0..1800, 1800..3000];
        let runs: Vec<&Range<usize>> = runs.iter().collect();
        let rows = Rows { residual: &residual, time: None, runs: &runs };
        let per_row = rows.nearest(0.1237);
        rows.hold_it_alike(per_row, 1.0)
    }

    /// Mains in the reading: a phase for each run. A ripple that follows the reading stops where the reading stands, and changes its pace with it.
    #[test]
    fn a_tone_of_the_electronics_is_steady_and_what_follows_the_sensor_is_not() {
        let wave = |row: usize, per_row: f64| 0.8 * (TAU * per_row * row as f64).sin();
        for seed in 0..20 {
            assert!(alike(seed, |row| wave(row, 0.1236) * if row < 1800 { 1.0 } else { -1.0 }), "{seed}");
            assert!(!alike(seed, |row| if row % 600 < 300 { wave(row, 0.1236) } else { 0.0 }), "{seed}");
            assert!(!alike(seed, |row| wave(row, if row % 600 < 300 { 0.1236 } else { 0.121 })), "{seed}");
        }
    }

    /// Sizes 0.5 and 0.3 over 1000 rows: squares of 0.5 x 1000 x (0.25 + 0.09).
    #[test]
    fn a_tone_holds_half_its_square_a_row() {
        let residual: Vec<f64> =
            (0..2000).map(|row| if row < 1000 { 0.5 } else { 0.3 } * (TAU * 0.12 * f64::from(row) + 0.4).cos()).collect();
        let runs = [0..1000, 1000..2000];
        let runs: Vec<&Range<usize>> = runs.iter().collect();
        let rows = Rows { residual: &residual, time: None, runs: &runs };
        approx::assert_relative_eq!(rows.power(0.12), 170.0, max_relative = 1e-9);
        approx::assert_relative_eq!(rows.power(rows.nearest(0.1198)), 170.0, max_relative = 1e-2);
    }
}
