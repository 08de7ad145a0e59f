//! Tones in a misfit, taken out before noise is read from it: a daily or yearly cycle of a dozen rows is no noise that lasts.
//!
//! Limits: even clocks; up to three tones a run with their second harmonics, each far above what stands beside it in the spectrum.

use crate::noise::tuning::{BESIDE_A_LINE, FEWEST_CYCLES, LINE_STANDS_OUT, LONG_RUN, MOST_TONES};
use nalgebra::{DMatrix, DVector};
use rustfft::{FftPlanner, num_complex::Complex};
use std::ops::Range;
use truegap_core::Inputs;

/// The misfit without the tones of each run.
pub(crate) fn without_tones(inputs: &Inputs, mut misfit: Vec<f64>) -> Vec<f64> {
    if inputs.time_s.is_none() {
        return misfit;
    }
    let steps = inputs.steps_s();
    for run in inputs.runs() {
        let own = &steps[run.start + 1..run.end];
        let (least, most) = own.iter().fold((f64::INFINITY, 0.0), |(l, m): (f64, f64), s| (l.min(*s), m.max(*s)));
        // months differ by a tenth
        if run.len() >= LONG_RUN && most <= 1.15 * least {
            take_out(&mut misfit[run]);
        }
    }
    misfit
}

fn take_out(misfit: &mut [f64]) {
    for _ in 0..MOST_TONES {
        let Some(cycles) = strongest(misfit) else { return };
        let (_, followed) = around(misfit, cycles);
        misfit.iter_mut().zip(followed.iter()).for_each(|(m, f)| *m -= f);
    }
}

/// Cycles of the strongest tone, where it stands out.
fn strongest(misfit: &[f64]) -> Option<usize> {
    let n = misfit.len();
    let mean = misfit.iter().sum::<f64>() / n as f64;
    // a window, so that a slow course does not leak into the lines
    let window = |row: usize| (std::f64::consts::PI * (row as f64 + 0.5) / n as f64).sin().powi(2);
    let mut values: Vec<Complex<f64>> = misfit.iter().enumerate().map(|(row, m)| ((m - mean) * window(row)).into()).collect();
    FftPlanner::<f64>::new().plan_fft_forward(n).process(&mut values);
    let power: Vec<f64> = values[..n / 2].iter().map(Complex::norm_sqr).collect();
    let line = (FEWEST_CYCLES..power.len()).max_by(|a, b| power[*a].total_cmp(&power[*b]))?;
    // the window spreads a line over its neighbours
    let beside: Vec<f64> = near(line, 3, power.len()).map(|k| power[k]).collect();
    let floor = beside.iter().sum::<f64>() / beside.len().max(1) as f64;
    (!beside.is_empty() && power[line] > LINE_STANDS_OUT * floor).then_some(line)
}

/// Lines on both sides of one, from `from` lines off.
fn near(line: usize, from: usize, all: usize) -> impl Iterator<Item = usize> {
    let range: Range<usize> = line.saturating_sub(BESIDE_A_LINE).max(1)..(line + BESIDE_A_LINE + 1).min(all);
    range.filter(move |k| k.abs_diff(line) >= from)
}

/// What is left without a tone of about so many cycles and its harmonic, and the tone.
fn around(misfit: &[f64], cycles: usize) -> (f64, DVector<f64>) {
    let n = misfit.len();
    let target = DVector::from_column_slice(misfit);
    let fitted = |cycles: f64| {
        let turn = std::f64::consts::TAU * cycles / n as f64;
        let waves = DMatrix::from_fn(n, 5, |row, k| match k {
            0 => 1.0,
            _ if k % 2 == 1 => (turn * (k / 2 + 1) as f64 * row as f64).sin(),
            _ => (turn * (k / 2) as f64 * row as f64).cos(),
        });
        let normal = waves.tr_mul(&waves);
        let shares = normal.cholesky().map(|factor| factor.solve(&waves.tr_mul(&target))).unwrap_or_else(|| DVector::zeros(5));
        let mut only = shares.clone();
        only[0] = 0.0;
        ((&target - &waves * &shares).norm_squared(), &waves * only)
    };
    let tried = (-20..=20).map(|k| fitted(cycles as f64 + 0.05 * f64::from(k)));
    tried.min_by(|a, b| a.0.total_cmp(&b.0)).unwrap_or_else(|| (target.norm_squared(), DVector::zeros(n)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::stats::rms;
    use rand::SeedableRng;
    use rand_chacha::ChaCha8Rng;
    use rand_distr::{Distribution, StandardNormal};

    fn months(misfit: impl Fn(f64, f64) -> f64) -> (Inputs, Vec<f64>) {
        let random = &mut ChaCha8Rng::seed_from_u64(4);
        let inputs = Inputs { time_s: Some((0..360).map(f64::from).collect()), run: vec![1; 360], ..Inputs::default() };
        let column = (0..360).map(|row| misfit(f64::from(row), StandardNormal.sample(random))).collect();
        (inputs, column)
    }

    fn size(column: &[f64]) -> f64 {
        rms(column.iter().copied())
    }

    #[test]
    fn a_yearly_cycle_of_twelve_rows_is_taken_out() {
        let year = |row: f64| {
            3.0 * (row * std::f64::consts::TAU / 12.17).sin() + 0.8 * (row * 2.0 * std::f64::consts::TAU / 12.17).cos()
        };
        let (inputs, misfit) = months(|row, noise| year(row) + 0.3 * noise + 1e-4 * (row - 180.0).powi(2));
        let left = without_tones(&inputs, misfit);
        let slow: Vec<f64> = (0..360).map(|row| left[row] - 1e-4 * (row as f64 - 180.0).powi(2)).collect();
        let mean = slow.iter().sum::<f64>() / 360.0;
        let rest: Vec<f64> = slow.iter().map(|v| v - mean).collect();
        // the slow course gives up a little of itself to the waves
        assert!((0.25..0.4).contains(&size(&rest)), "{}", size(&rest));
    }

    #[test]
    fn noise_of_any_colour_stays() {
        let (inputs, white) = months(|_, noise| noise);
        assert_eq!(without_tones(&inputs, white.clone()), white);
        let mut state = 0.0;
        let red: Vec<f64> = white
            .iter()
            .map(|w| {
                state = 0.9 * state + w;
                state
            })
            .collect();
        assert_eq!(without_tones(&inputs, red.clone()), red);
    }
}
