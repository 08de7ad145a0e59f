//! Recorded inputs without their noise: straight lines over the longest stretch that is consistent with one.
//!
//! A model driven by a noisy input has an error that any effect with a threshold or a rate can seem to explain (a play filters noise); driven by
//! the straight parts of the profile it has not.
//!
//! Limits: noise is white with a known standard deviation; a corner is kept where the noise lets it be seen.

use crate::{
    noise::tuning::{LONGEST_LINE, OFF_THE_LINE, SHORT_LINE},
    stats::median,
};
use std::ops::Range;

/// A column without noise, and the share of the noise's variance that is left in each row.
pub struct Denoised {
    /// values
    pub column: Vec<f64>,
    /// variance left over the variance of the noise, row by row
    pub left: Vec<f64>,
}

/// Takes white noise of standard deviation `sd` out of a column; `time` orders the rows of each run.
pub fn denoise(column: &[f64], time: Option<&[f64]>, runs: &[Range<usize>], sd: f64) -> Denoised {
    let mut out = Denoised { column: column.to_vec(), left: vec![1.0; column.len()] };
    if sd <= 0.0 {
        out.left.fill(0.0);
        return out;
    }
    for run in runs {
        for row in run.clone() {
            if let Some((value, left)) = best_line(column, time, run, row, sd) {
                out.column[row] = value;
                out.left[row] = left;
            }
        }
    }
    out
}

/// Value at `row` of the consistent line with the least variance there, over stretches that reach back, ahead, or both.
fn best_line(column: &[f64], time: Option<&[f64]>, run: &Range<usize>, row: usize, sd: f64) -> Option<(f64, f64)> {
    let mut best: Option<(f64, f64)> = None;
    for (back, ahead) in [(1, 1), (1, 0), (0, 1)] {
        let mut reach = 3;
        while reach <= LONGEST_LINE {
            let from = row.saturating_sub(back * reach).max(run.start);
            let to = (row + ahead * reach + 1).min(run.end);
            if to - from < 4 {
                break;
            }
            let Some((value, left)) = line(column, time, from..to, row, sd) else { break };
            if best.is_none_or(|b| left < b.1) {
                best = Some((value, left));
            }
            reach = reach * 3 / 2 + 1;
        }
    }
    best
}

/// A least-squares line about a row.
pub(super) struct Line {
    /// value at the row
    pub value: f64,
    /// change per unit of time, or per row
    pub slope: f64,
    /// share of the noise's variance in it
    leverage: f64,
    /// greatest distance of a row, in standard deviations of the noise
    pub farthest: f64,
    /// squares of the distances over the variance of the noise
    squares: f64,
    freedom: f64,
}

/// Value and leverage of the line over `rows` at `row`; `None` where a row leaves it or the scatter is more than noise.
fn line(column: &[f64], time: Option<&[f64]>, rows: Range<usize>, row: usize, sd: f64) -> Option<(f64, f64)> {
    let line = fitted(column, time, rows, row, sd);
    let alike = line.squares < line.freedom + 3.0 * (2.0 * line.freedom).sqrt();
    (alike && line.farthest <= OFF_THE_LINE).then_some((line.value, line.leverage))
}

/// The line over `rows` about `row`; against the rows themselves where there is no `time`.
pub(super) fn fitted(column: &[f64], time: Option<&[f64]>, rows: Range<usize>, row: usize, sd: f64) -> Line {
    let at = |i: usize| time.map_or(i as f64 - row as f64, |t| t[i] - t[row]);
    let n = rows.len() as f64;
    let mx = rows.clone().map(at).sum::<f64>() / n;
    let my = column[rows.clone()].iter().sum::<f64>() / n;
    let (mut sxx, mut sxy) = (0.0, 0.0);
    for i in rows.clone() {
        sxx += (at(i) - mx).powi(2);
        sxy += (at(i) - mx) * (column[i] - my);
    }
    let slope = if sxx > 0.0 { sxy / sxx } else { 0.0 };
    let (mut squares, mut farthest) = (0.0, 0.0f64);
    for i in rows {
        let off = (column[i] - my - slope * (at(i) - mx)) / sd;
        farthest = farthest.max(off.abs());
        squares += off * off;
    }
    let leverage = 1.0 / n + mx * mx / sxx.max(1e-300);
    Line { value: my - slope * mx, slope, leverage, farthest, squares, freedom: n - 2.0 }
}

/// Scatter about the best of three lines over seven rows (before a row, about it, after it), over the variance of the noise, in the middle of all rows: about 0.5
/// where most of a column lies on straight lines, however short, and more where it bends all the time.
pub fn crookedness(column: &[f64], time: Option<&[f64]>, runs: &[Range<usize>], sd: f64) -> f64 {
    let inner = runs
        .iter()
        .filter(|r| r.len() > 4 * SHORT_LINE)
        .flat_map(|r| (r.start + 2 * SHORT_LINE..r.end - 2 * SHORT_LINE).step_by(SHORT_LINE));
    let best = |row: usize| {
        let stretches = [row - 2 * SHORT_LINE..row + 1, row - SHORT_LINE..row + SHORT_LINE + 1, row..row + 2 * SHORT_LINE + 1];
        let scatter = stretches.map(|rows| {
            let line = fitted(column, time, rows, row, sd);
            line.squares / line.freedom
        });
        scatter.into_iter().fold(f64::INFINITY, f64::min)
    };
    median(&inner.map(best).collect::<Vec<f64>>())
}

#[cfg(test)]
#[allow(clippy::single_range_in_vec_init)]
mod tests {
    use super::*;
    use crate::stats::rms;
    use rand::SeedableRng;
    use rand_distr::Distribution;

    #[test]
    fn a_staircase_with_ramps_loses_its_noise_and_keeps_its_corners() {
        let mut rng = rand_chacha::ChaCha8Rng::seed_from_u64(3);
        let normal = rand_distr::Normal::new(0.0, 0.005).unwrap();
        let clean: Vec<f64> = (0..1200)
            .map(|i| if i % 200 < 100 { f64::from(i / 200) } else { f64::from(i / 200) + f64::from(i % 200 - 100) / 100.0 })
            .collect();
        let noisy: Vec<f64> = clean.iter().map(|c| c + normal.sample(&mut rng)).collect();
        let found = denoise(&noisy, None, &[0..1200], 0.005);
        let off = |a: &[f64]| rms(a.iter().zip(&clean).map(|(x, c)| x - c));
        // a line over up to 65 rows leaves a tenth of the variance or less in most rows
        assert!(off(&found.column) < 0.5 * off(&noisy), "{} of {}", off(&found.column), off(&noisy));
        let worst = found.column.iter().zip(&clean).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        assert!(worst < 5.0 * 0.005, "{worst}");
    }

    #[test]
    fn stairs_are_straight_however_short_and_a_wandering_load_is_not() {
        let mut rng = rand_chacha::ChaCha8Rng::seed_from_u64(8);
        let (noise, push) = (rand_distr::Normal::new(0.0, 0.005).unwrap(), rand_distr::Normal::new(0.0, 0.02).unwrap());
        let stairs: Vec<f64> = (0..900).map(|i| f64::from(i / 10 % 5) + noise.sample(&mut rng)).collect();
        let (mut load, mut speed) = (2.0, 0.0);
        let wandering: Vec<f64> = (0..900)
            .map(|_| {
                speed = 0.95 * speed + push.sample(&mut rng);
                load += speed;
                load + noise.sample(&mut rng)
            })
            .collect();
        let of = |column: &[f64]| crookedness(column, None, &[0..900], 0.005);
        assert!(of(&stairs) < 0.9 && of(&wandering) > 2.0, "{} {}", of(&stairs), of(&wandering));
    }
}
