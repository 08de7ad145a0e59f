//! A tone in the reading: interference of a constant frequency, too weak in any one stretch to be seen, added up over all runs.
//!
//! Limits: runs sampled evenly and at the same pace as the longest; the lowest frequencies belong to the smooth tests.

use crate::adequacy::interference::steady::Rows;
use crate::adequacy::tuning::{AROUND, EVEN, LOWEST_CYCLES, SHORTEST_RUN, TONE_LEVEL};
use crate::text::rounded;
use rustfft::{FftPlanner, num_complex::Complex};
use statrs::distribution::{ContinuousCDF, Gamma};
use std::ops::Range;

/// Frequency below which a tone is told by its period, Hz.
const SLOW_HZ: f64 = 0.01;

/// The strongest tone.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize)]
pub struct Tone {
    /// frequency, cycles a row
    pub per_row: f64,
    /// the same in Hz; `None` where the recording has no time
    pub frequency_hz: Option<f64>,
    /// amplitude in the whitened residual, in units of the noise
    pub amplitude: f64,
    /// probability of one as strong in noise, with all frequencies counted
    pub p_value: f64,
    /// whether all parts of the runs hold it alike, in strength and phase: a signal of the electronics
    pub steady: bool,
}

impl Tone {
    /// No tone.
    const NONE: Self = Self { per_row: 0.0, frequency_hz: None, amplitude: 0.0, p_value: 1.0, steady: false };

    /// The strongest tone in a whitened residual; `time` in s.
    ///
    /// **Source:** periodogram and its distribution in noise, Scargle, Astrophys. J. 263 (1982) 835; sums over runs have a gamma distribution.
    /// **Accuracy:** frequency to half a cycle of the longest run, amplitude to four deviations of `sqrt(2 / rows)`, `a_faint_tone_is_found_at_its_frequency_and_noise_is_none_even_where_it_is_coloured`.
    pub fn strongest(residual: &[f64], time: Option<&[f64]>, runs: &[Range<usize>]) -> Self {
        let (alike, step) = of_one_pace(time, runs);
        let Some(longest) = alike.iter().max_by_key(|r| r.len()) else { return Self::NONE };
        // twice as fine as the longest run: a tone between two of its frequencies loses little
        let size = (2 * longest.len()).next_power_of_two();
        let power = added_up(residual, &alike, size);
        let cycle = size / longest.len();
        let first = LOWEST_CYCLES * cycle;
        let count = (power.len().saturating_sub(first) / cycle).max(1) as f64 * 2.0;
        let Ok(noise) = Gamma::new(alike.len() as f64, 1.0) else { return Self::NONE };
        let surrounding = surroundings(&power, cycle);
        let level = |line: usize| (surrounding[line] / alike.len() as f64).max(f64::MIN_POSITIVE);
        // every line has the same distribution: the rarest stands highest above what surrounds it, also where its probability is too small for a number
        let height = |line: usize| power[line] / level(line);
        let higher = |best: usize, line: usize| if height(line) > height(best) { line } else { best };
        let Some(rarest) = (first..power.len()).reduce(higher) else { return Self::NONE };
        let p_value = (noise.sf(height(rarest)) * count).min(1.0);
        if p_value >= 1.0 {
            return Self::NONE;
        }
        let per_row = rarest as f64 / size as f64;
        let rows: usize = alike.iter().map(|r| r.len()).sum();
        let amplitude = (4.0 * (power[rarest] - surrounding[rarest]).max(0.0) / rows as f64).sqrt();
        let found = Self { per_row, frequency_hz: time.map(|_| per_row / step), amplitude, p_value, steady: false };
        let rows = Rows { residual, time: time.map(|time| (time, step)), runs: &alike };
        let steady = found.is_significant() && rows.hold_it_alike(rows.nearest(per_row), level(rarest));
        Self { steady, ..found }
    }

    /// Squares of the noise that a tone takes from a whitened residual, a phase and an amplitude for each run of its pace.
    pub fn power_in(&self, residual: &[f64], time: Option<&[f64]>, runs: &[Range<usize>]) -> f64 {
        let (alike, step) = of_one_pace(time, runs);
        let rows = Rows { residual, time: time.map(|time| (time, step)), runs: &alike };
        rows.power(rows.nearest(self.per_row))
    }

    /// Where it is and how loud, as a part of a sentence.
    pub fn says(&self) -> String {
        let at = match self.frequency_hz {
            None => format!("a tone at {:.4} cycles a row", self.per_row),
            Some(hz) if hz < SLOW_HZ => format!("a cycle of {}", rounded(hz.recip(), "s")),
            Some(hz) => format!("a tone at {hz:.4} Hz"),
        };
        format!("{at} (as sampled; it may be a faster one), {:.2} times as large as the noise", self.amplitude)
    }

    /// Whether it is there.
    pub fn is_significant(&self) -> bool {
        self.p_value < TONE_LEVEL
    }
}

/// Runs that are sampled evenly at the pace of the longest, and their step in s.
fn of_one_pace<'r>(time: Option<&[f64]>, runs: &'r [Range<usize>]) -> (Vec<&'r Range<usize>>, f64) {
    let long = runs.iter().filter(|r| r.len() >= SHORTEST_RUN);
    let paced: Vec<(&Range<usize>, f64)> = long.filter_map(|r| pace(time, r).map(|pace| (r, pace))).collect();
    let step = paced.iter().max_by_key(|(r, _)| r.len()).map_or(1.0, |(_, step)| *step);
    (paced.iter().filter(|(_, s)| (s / step - 1.0).abs() < EVEN).map(|(r, _)| *r).collect(), step)
}

/// Median step of a run, s (1 where there is no time); `None` where its steps are not even.
fn pace(time: Option<&[f64]>, run: &Range<usize>) -> Option<f64> {
    let Some(time) = time else { return Some(1.0) };
    let mut steps: Vec<f64> = time[run.clone()].windows(2).map(|w| w[1] - w[0]).collect();
    steps.sort_by(f64::total_cmp);
    let (median, tenth, ninth) = (steps[steps.len() / 2], steps[steps.len() / 10], steps[steps.len() * 9 / 10]);
    (median > 0.0 && ninth - tenth < EVEN * median).then_some(median)
}

/// Periodograms of the runs at the frequencies `k / size`, up to half a cycle a row, added up; each has mean 1 for unit white noise.
fn added_up(residual: &[f64], runs: &[&Range<usize>], size: usize) -> Vec<f64> {
    let transform = FftPlanner::<f64>::new().plan_fft_forward(size);
    let mut sum = vec![0.0; size / 2];
    for run in runs {
        let mut values: Vec<Complex<f64>> = residual[(*run).clone()].iter().map(|v| (*v).into()).collect();
        values.resize(size, Complex::default());
        transform.process(&mut values);
        sum.iter_mut().zip(&values).for_each(|(s, v)| *s += v.norm_sqr() / run.len() as f64);
    }
    sum
}

/// Mean of the spectrum around each frequency, the line itself left out; `cycle` is one cycle of the longest run, in entries.
fn surroundings(power: &[f64], cycle: usize) -> Vec<f64> {
    let mut sums = vec![0.0];
    for p in power {
        sums.push(sums.last().copied().unwrap_or(0.0) + p);
    }
    let (wide, gap) = (AROUND.0 * cycle, AROUND.1 * cycle);
    let between = |line: usize, half: usize| {
        let (low, high) = (line.saturating_sub(half), (line + half + 1).min(power.len()));
        (sums[high] - sums[low], (high - low) as f64)
    };
    let mean = |line: usize| {
        let ((all, entries), (near, left_out)) = (between(line, wide), between(line, gap));
        (all - near) / (entries - left_out).max(1.0)
    };
    (0..power.len()).map(mean).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use rand::SeedableRng;
    use rand_chacha::ChaCha8Rng;
    use rand_distr::{Distribution, StandardNormal};

    const RUNS: [Range<usize>; 3] = [0..1200, 1200..1700, 1700..4000];

    fn noise(seed: u64, correlation: f64) -> Vec<f64> {
        let random = &mut ChaCha8Rng::seed_from_u64(seed);
        let mut state = 0.0;
        (0..4000)
            .map(|_| {
                let push: f64 = StandardNormal.sample(random);
                state = correlation * state + (1.0f64 - correlation * correlation).sqrt() * push;
                state
            })
            .collect()
    }

    /// Amplitude 0.3: 13 noise units in 4000 rows, a twentieth of the variance.
    #[test]
    fn a_faint_tone_is_found_at_its_frequency_and_noise_is_none_even_where_it_is_coloured() {
        let time: Vec<f64> = (0..4000).map(|i| 0.2 * f64::from(i)).collect();
        for seed in 0..10 {
            for correlation in [0.0, 0.5] {
                let found = Tone::strongest(&noise(seed, correlation), Some(&time), &RUNS);
                assert!(!found.is_significant(), "{seed} {found:?}");
            }
            let hum = |i: usize| 0.3 * (0.731 * i as f64 + 0.4).sin();
            let residual: Vec<f64> = noise(seed, 0.0).iter().enumerate().map(|(i, v)| v + hum(i)).collect();
            let found = Tone::strongest(&residual, Some(&time), &RUNS);
            // half a cycle of the longest run; the amplitude to four standard deviations of sqrt(2 / rows)
            assert!(
                found.is_significant() && found.steady && (found.per_row - 0.731 / std::f64::consts::TAU).abs() < 0.5 / 2300.0,
                "{found:?}"
            );
            approx::assert_abs_diff_eq!(found.amplitude, 0.3, epsilon = 0.09);
            approx::assert_relative_eq!(found.frequency_hz.unwrap_or(0.0), found.per_row / 0.2, max_relative = 1e-9);
        }
    }

    /// Both have no probability that a number can hold; the weaker one has the lower frequency.
    #[test]
    fn the_strongest_of_tones_beyond_all_numbers_is_told() {
        let wave = |i: usize, per_row: f64| (std::f64::consts::TAU * per_row * i as f64).sin();
        let tones = |i: usize| 3.0 * wave(i, 0.11) + 9.0 * wave(i, 0.32);
        let residual: Vec<f64> = noise(6, 0.0).iter().enumerate().map(|(i, v)| v + tones(i)).collect();
        let found = Tone::strongest(&residual, None, &RUNS);
        assert!(found.p_value == 0.0 && (found.per_row - 0.32).abs() < 0.5 / 2300.0, "{found:?}");
    }

    #[test]
    fn runs_on_random_moments_are_not_listened_to() {
        let time: Vec<f64> = (0..4000).map(|i| f64::from(i) + if i % 3 == 0 { 0.3 } else { 0.0 }).collect();
        assert_eq!(Tone::strongest(&noise(1, 0.0), Some(&time), &RUNS), Tone::NONE);
    }
}
