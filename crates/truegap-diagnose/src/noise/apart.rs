//! How far each row of a misfit stands from the rows about it.
//!
//! Limits: runs longer than twice the rows that are compared with.

use crate::{noise::tuning::BESIDE, stats::median};
use std::ops::Range;

/// How far a row stands from its neighbours.
#[derive(Clone, Copy, Default)]
pub(crate) struct Apart {
    /// from the middle of those on both sides
    pub about: f64,
    /// from the nearer side, 0 where it lies between the two
    pub least: f64,
}

/// Each row beside its neighbours; 0 in runs that have none.
pub(crate) fn apart(misfit: &[f64], runs: &[Range<usize>]) -> Vec<Apart> {
    let mut all = vec![Apart::default(); misfit.len()];
    for run in runs.iter().filter(|r| r.len() > 2 * BESIDE) {
        for row in run.clone() {
            let before = &misfit[row.saturating_sub(BESIDE).max(run.start)..row];
            let after = &misfit[row + 1..(row + 1 + BESIDE).min(run.end)];
            let both: Vec<f64> = before.iter().chain(after).copied().collect();
            let about = misfit[row] - median(&both);
            let sides = [before, after].map(|side| if side.len() > 1 { misfit[row] - middle(side) } else { about });
            let least = if sides[0] * sides[1] > 0.0 { sides[0].abs().min(sides[1].abs()) * sides[0].signum() } else { 0.0 };
            all[row] = Apart { about, least };
        }
    }
    all
}

/// Median of a few values, between the middle two of an even number.
fn middle(values: &[f64]) -> f64 {
    let mut sorted = values.to_vec();
    sorted.sort_by(f64::total_cmp);
    0.5 * (sorted[(sorted.len() - 1) / 2] + sorted[sorted.len() / 2])
}
