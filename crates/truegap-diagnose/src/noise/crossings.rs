//! A slow course that was written down in steps: where the column goes from one value to the next, the truth was halfway between them.
//!
//! A thermometer in steps of 0.5 K shows a warming room as stairs; a model driven by stairs asks for a lag that smooths them. Between two crossings in one direction the course is
//! a straight line; at a turn and at an end it goes on with the last slope until the middle of the step, and a hold stays at its value.
//!
//! Limits: crossings by one step; where a column jumps further, it is taken as it is.

use crate::noise::tuning::HOLD;
use std::ops::Range;

/// A crossing: when, in rows, and the value halfway.
#[derive(Clone, Copy)]
struct Crossing {
    at: f64,
    value: f64,
}

/// The course behind a column that is written in steps of `step`.
pub fn course(column: &[f64], runs: &[Range<usize>], step: f64) -> Vec<f64> {
    let mut out = column.to_vec();
    for run in runs {
        let jumps = (run.start + 1..run.end).filter(|row| (column[*row] - column[*row - 1]).abs() > 1.5 * step);
        let mut first = run.start;
        for end in jumps.chain(std::iter::once(run.end)) {
            within(column, first..end, step, &mut out);
            first = end;
        }
    }
    out
}

fn within(column: &[f64], rows: Range<usize>, step: f64, out: &mut [f64]) {
    let crossings = crossings(column, &rows, step);
    let Some(last) = crossings.len().checked_sub(1) else { return };
    let gap = |k: usize| crossings[k + 1].at - crossings[k].at;
    let slope = |k: usize| {
        let rise = crossings[k + 1].value - crossings[k].value;
        let beside = [k.checked_sub(1), Some(k + 1).filter(|next| *next < last)].into_iter().flatten().map(gap);
        let hold = beside.reduce(f64::max).is_some_and(|beside| gap(k) > HOLD * beside);
        (rise.abs() > 0.5 * step && !hold).then(|| rise / gap(k))
    };
    let slopes: Vec<Option<f64>> = (0..last).map(slope).collect();
    for row in rows {
        let x = row as f64;
        let next = crossings.partition_point(|c| c.at < x);
        if let Some(slope) = next.checked_sub(1).and_then(|k| slopes.get(k).copied().flatten()) {
            out[row] = crossings[next - 1].value + slope * (x - crossings[next - 1].at);
            continue;
        }
        // the nearer crossing whose other side has a slope
        let before = next.checked_sub(1).and_then(|k| Some((crossings[k], slopes[k.checked_sub(1)?]?)));
        let after = crossings.get(next).and_then(|c| Some((*c, slopes.get(next).copied().flatten()?)));
        let nearer = match (before, after) {
            (Some(a), Some(b)) => Some(if x - a.0.at < b.0.at - x { a } else { b }),
            (a, b) => a.or(b),
        };
        if let Some((crossing, slope)) = nearer {
            let (least, most) = (column[row].min(crossing.value), column[row].max(crossing.value));
            out[row] = (crossing.value + slope * (x - crossing.at)).clamp(least, most);
        }
    }
}

/// Crossings of a stretch without jumps; those to and fro between two values are one, in their middle.
fn crossings(column: &[f64], rows: &Range<usize>, step: f64) -> Vec<Crossing> {
    let mut found: Vec<(Crossing, f64)> = Vec::new();
    for row in rows.start + 1..rows.end {
        if (column[row] - column[row - 1]).abs() > 0.5 * step {
            let one = Crossing { at: row as f64 - 0.5, value: 0.5 * (column[row] + column[row - 1]) };
            match found.last_mut() {
                Some((crossing, count)) if (crossing.value - one.value).abs() < 0.5 * step => {
                    crossing.at += (one.at - crossing.at) / (*count + 1.0);
                    *count += 1.0;
                }
                _ => found.push((one, 1.0)),
            }
        }
    }
    found.into_iter().map(|(crossing, _)| crossing).collect()
}

#[cfg(test)]
#[allow(clippy::single_range_in_vec_init)]
mod tests {
    use super::*;

    fn written(truth: &[f64], step: f64) -> Vec<f64> {
        truth.iter().map(|t| (t / step).round() * step).collect()
    }

    #[test]
    fn a_ramp_in_steps_is_a_ramp_again() {
        let truth: Vec<f64> = (0..600).map(|i| 20.13 + 0.017 * f64::from(i)).collect();
        let found = course(&written(&truth, 0.5), &[0..600], 0.5);
        let worst = found[30..570].iter().zip(&truth[30..570]).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        // a crossing is known to half a row, 9 mK
        assert!(worst < 0.01, "{worst}");
    }

    #[test]
    fn holds_jumps_and_single_values_stay_as_they_are() {
        let holds: Vec<f64> = (0..400).map(|i| if i < 200 { 20.0 } else { 40.0 }).collect();
        assert_eq!(course(&holds, &[0..400], 0.5), holds);
        // up in 0.017 K a row to a hold at 25.2 K, written as 25.0 K
        let truth: Vec<f64> = (0..1000).map(|i| (20.0 + 0.017 * f64::from(i)).min(25.2)).collect();
        let found = course(&written(&truth, 0.5), &[0..1000], 0.5);
        assert!(found[400..].iter().all(|v| (v - 25.0).abs() < 1e-9), "{:?}", &found[395..405]);
    }
}
