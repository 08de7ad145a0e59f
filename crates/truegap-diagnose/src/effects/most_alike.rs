//! By how much one column is late behind another: the shifts at which the two are most alike.
//!
//! **Source:** Knapp & Carter, The generalized correlation method for estimation of time delay, IEEE Trans. ASSP 24 (1976) 320.
//!
//! Limits: one run, on an even clock of as many rows; a column that is late and says something else as well is as late as most of it.

use crate::effects::memory::at_time;
use std::ops::Range;

/// Shifts that are given, the likest first: waves are alike again after each period.
const SHIFTS: usize = 4;

/// Rows of the even clock at most: the work goes with their square.
const MOST_ROWS: usize = 6000;

/// Times, s, by which `late` is behind `column` where the two are most alike, up or down, none further than `most_s` to either side.
pub(crate) fn most_alike_s(time_s: &[f64], run: &Range<usize>, [column, late]: [&[f64]; 2], most_s: f64) -> Vec<f64> {
    let rows = run.len().min(MOST_ROWS);
    let (first, length) = (time_s[run.start], time_s[run.end - 1] - time_s[run.start]);
    if rows < 3 || length <= 0.0 {
        return Vec::new();
    }
    let step = length / (rows - 1) as f64;
    let even = |column: &[f64]| {
        let mut even: Vec<f64> = (0..rows).map(|row| at_time(time_s, column, run, first + step * row as f64)).collect();
        let mean = even.iter().sum::<f64>() / rows as f64;
        even.iter_mut().for_each(|value| *value -= mean);
        even
    };
    let (x, y) = (even(column), even(late));
    let most = ((most_s / step) as usize).min(rows - 2) as isize;
    let alike = |by: isize| {
        let (behind, ahead) = (by.max(0) as usize, (-by).max(0) as usize);
        let (x, y) = (&x[ahead..rows - behind], &y[behind..rows - ahead]);
        let of = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
        (of(x, y) / (of(x, x) * of(y, y)).sqrt().max(f64::MIN_POSITIVE)).abs()
    };
    let found: Vec<f64> = (-most..=most).map(alike).collect();
    let mut tops: Vec<(f64, f64)> = (1..found.len().saturating_sub(1))
        .filter(|at| found[*at] > found[at - 1] && found[*at] >= found[at + 1])
        .map(|at| {
            // the top of the parabola through three shifts
            let [left, top, right] = [found[at - 1], found[at], found[at + 1]];
            let bend = 2.0 * top - left - right;
            let beside = if bend > 0.0 { 0.5 * (right - left) / bend } else { 0.0 };
            (top, step * (at as f64 - most as f64 + beside))
        })
        .collect();
    tops.sort_by(|a, b| b.0.total_cmp(&a.0));
    tops.into_iter().take(SHIFTS).map(|(_, shift)| shift).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A walk, each step of which is anew: it is like itself at no other shift, so that widths of it pass the right one by.
    #[test]
    fn a_rough_column_is_found_at_its_shift_and_upside_down_as_well() {
        let mut state = 7_u64;
        let mut step = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 11) as f64 / (1_u64 << 53) as f64 - 0.5
        };
        let mut at = 0.0;
        let walk: Vec<f64> = (0..900)
            .map(|_| {
                at = 0.98 * at + step();
                at
            })
            .collect();
        let time: Vec<f64> = (0..900).map(|row| 0.5 * f64::from(row)).collect();
        for (by, sign) in [(31_usize, 1.0), (31, -0.4), (0, 1.0)] {
            let late: Vec<f64> = (0..900).map(|row: usize| 3.0 + sign * walk[row.saturating_sub(by)]).collect();
            let found = most_alike_s(&time, &(0..900), [&walk, &late], 90.0);
            approx::assert_abs_diff_eq!(found[0], 0.5 * by as f64, epsilon = 0.1);
        }
    }
}
