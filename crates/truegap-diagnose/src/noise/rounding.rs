//! Columns written down in steps: the step is seen in the column itself, and what it makes of every row is an error that stays as long as the column does.
//!
//! A load of 1.012 N that is written as 1.00 N errs by 12 mN in every row of the hold: the mean of many rows knows it no better than one. A staircase somebody commanded
//! looks the same, but its reading jumps with it; a rounded ramp's does not.
//!
//! Limits: one step for a whole column; holds on one level err alike, ramps through the same steps count as independent.
//!
//! **Source:** Widrow and Kollar, Quantization Noise (2008), sections 4.1 (variance of a step, `q^2 / 12`) and 5.4 (noise before rounding makes its error independent).

use crate::{
    noise::tuning::{
        ALL_ALIKE, COARSE, COMMANDED, FEWEST_FLICKERS, FEWEST_LEVELS, LONGER_PLATEAU, MEMORIES_IN_A_HOLD, MEMORIES_ON_A_COURSE,
        MOST_LEVELS, OFF_GRID, ONE_LEVEL, REAL_CHANGE,
    },
    stats::median,
};
use std::ops::Range;

/// Error of a rounded column, row by row.
#[derive(Clone, Debug, PartialEq)]
pub struct Rounded {
    /// step of the column
    pub step: f64,
    /// variance of the error that is independent from row to row where the column stands still, in its unit squared
    pub white: f64,
    /// the same on the row's own plateau, row by row: on the edge of a step a column flickers all the time, in its middle never
    pub flicker: Vec<f64>,
    /// variance of the error that stays, row by row
    pub held: Vec<f64>,
    /// correlation of the held error with the row before
    pub memory: Vec<f64>,
    /// standard deviation of the error that holds on one level have in common, row by row; a column for each level that is held again
    pub same: Vec<Vec<f64>>,
    /// plateaus on which what was rounded held still, each with the mean of the column
    pub holds: Vec<(f64, Range<usize>)>,
}

impl Rounded {
    /// Gives each hold its mean. On the edge of a step a column flickers while what was rounded stands still: the error of a row is then known from the row itself, and
    /// whatever follows the recorded value seems to explain it.
    pub fn level_holds(&self, column: &mut [f64]) {
        for (mean, hold) in self.holds.iter().filter(|(_, hold)| self.flicker[hold.start] > 0.0) {
            column[hold.clone()].fill(*mean);
        }
    }

    /// The same in units of `unit`.
    #[must_use]
    pub fn over(mut self, unit: f64) -> Self {
        self.step /= unit;
        self.white /= unit * unit;
        self.holds.iter_mut().for_each(|(mean, _)| *mean /= unit);
        self.held.iter_mut().chain(&mut self.flicker).for_each(|v| *v /= unit * unit);
        self.same.iter_mut().flatten().for_each(|v| *v /= unit);
        self
    }

    /// Variance of the error that stays, in this row.
    pub fn stays(&self, row: usize) -> f64 {
        self.held[row] + self.same.iter().map(|level| level[row] * level[row]).sum::<f64>()
    }
}

/// What the steps of a column make of it, where it is written in steps; `answer` is what follows it, `small` a step that nobody commands.
pub fn rounded(column: &[f64], runs: &[Range<usize>], answer: Option<&[f64]>, small: f64) -> Option<Rounded> {
    let step = grid(column, runs, small)?;
    let same = |a: f64, b: f64| (a - b).abs() < 0.5 * step;
    let pairs: Vec<usize> = runs.iter().flat_map(|r| r.start + 1..r.end).collect();
    let still = pairs.iter().filter(|row| same(column[**row], column[**row - 1])).count();
    if (still as f64) < COARSE * pairs.len() as f64 || on_exact_lines(column, runs, step) {
        return None;
    }
    if answer.is_some_and(|answer| jumps_with(column, runs, step, answer)) {
        return None;
    }
    let flickers = flickers(column, runs, step);
    let white = flickers.iter().map(|(_, variance)| variance).sum::<f64>() / flickers.len().max(1) as f64;
    let mut flicker = vec![0.0; column.len()];
    flickers.into_iter().for_each(|(plateau, variance)| flicker[plateau].fill(variance));
    let stays = step * step * bias(white / (step * step));
    let (mut held, mut memory) = (vec![0.0; column.len()], vec![0.0; column.len()]);
    let mut holds = Vec::new();
    for run in runs {
        let all = plateaus(column, run, step);
        for (k, plateau) in all.iter().enumerate() {
            let jumps = |row: usize| row == run.start || row == run.end || (column[row] - column[row - 1]).abs() > 2.5 * step;
            let came = jumps(plateau.start);
            let beside =
                [k.checked_sub(1), Some(k + 1)].into_iter().flatten().filter_map(|k| all.get(k)).map(ExactSizeIterator::len);
            let longer = plateau.len() > LONGER_PLATEAU * beside.max().unwrap_or(0);
            let held_still = longer || (came && jumps(plateau.end));
            held[plateau.clone()].fill(if plateau.len() > 2 { stays } else { 0.0 });
            // on a slow course the error runs from one end of a step to the other while the column stands; in a hold it stays
            let changes = if held_still { MEMORIES_IN_A_HOLD } else { MEMORIES_ON_A_COURSE };
            memory[plateau.clone()].fill((-changes / plateau.len() as f64).exp());
            if came || longer {
                memory[plateau.start] = 0.0;
            }
            if held_still && plateau.len() > 2 {
                let mean = column[plateau.clone()].iter().sum::<f64>() / plateau.len() as f64;
                holds.push((mean, plateau.clone()));
            }
        }
    }
    let same = of_one_level(holds.clone(), step, (0.5 * stays).sqrt(), column.len());
    same.iter().for_each(|level| held.iter_mut().zip(level).for_each(|(held, sd)| *held -= sd * sd));
    Some(Rounded { step, white, flicker, held, memory, same, holds })
}

/// Columns of the error of holds on one level: what was rounded was about the same each time, and so was the error. Half of its variance is taken for common, half
/// for each hold's own: two holds in one step need not be at one place in it.
fn of_one_level(mut holds: Vec<(f64, Range<usize>)>, step: f64, sd: f64, rows: usize) -> Vec<Vec<f64>> {
    holds.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut levels = holds.chunk_by(|a, b| b.0 - a.0 < ONE_LEVEL * step).filter(|level| level.len() > 1).collect::<Vec<_>>();
    let length = |level: &&[(f64, Range<usize>)]| level.iter().map(|(_, rows)| rows.len()).sum::<usize>();
    levels.sort_by_key(|level| std::cmp::Reverse(length(level)));
    let column = |level: &[(f64, Range<usize>)]| {
        let mut column = vec![0.0; rows];
        level.iter().for_each(|(_, rows)| column[rows.clone()].fill(sd));
        column
    };
    levels.into_iter().take(MOST_LEVELS).map(column).collect()
}

/// Plateaus of more than two rows, and the variance of what noise makes of each where it stands between two values, by changes to and fro. Each stands somewhere else in a step: the noise of a
/// column is the mean over them, since one long plateau on the edge of a step flickers all the time and says nothing of the others.
fn flickers(column: &[f64], runs: &[Range<usize>], step: f64) -> Vec<(Range<usize>, f64)> {
    let of = |plateau: Range<usize>| {
        let changes: Vec<f64> =
            column[plateau.clone()].windows(2).map(|w| w[1] - w[0]).filter(|c| c.abs() > 0.5 * step).collect();
        let to_and_fro = changes.windows(2).filter(|w| w[0] * w[1] < 0.0).map(|w| 0.5 * w[1] * w[1]).sum::<f64>();
        let variance = to_and_fro / plateau.len() as f64;
        (plateau, variance)
    };
    runs.iter().flat_map(|run| plateaus(column, run, step)).filter(|plateau| plateau.len() > 2).map(of).collect()
}

/// Variance of the part of the error of rounding that stays, in steps squared, where noise before rounding makes `white` of it independent from row to row.
///
/// Over all places in a step the mean of the rounded column departs from what was rounded by a sawtooth, whose harmonics the noise damps; the whole error has the
/// variance of the noise and of a step (sections 4.1 and 5.4).
fn bias(white: f64) -> f64 {
    use std::f64::consts::PI;
    let sawtooth = |sd: f64| {
        let harmonic = |k: u32| (-(2.0 * PI * f64::from(k) * sd).powi(2)).exp() / (2.0 * (PI * f64::from(k)).powi(2));
        (1..200).map(harmonic).sum::<f64>()
    };
    let (mut low, mut high) = (0.0, 1.0);
    for _ in 0..40 {
        let sd: f64 = 0.5 * (low + high);
        if sd * sd + 1.0 / 12.0 - sawtooth(sd) < white { low = sd } else { high = sd }
    }
    sawtooth(low)
}

/// Stretches of a run within two neighbouring values.
fn plateaus(column: &[f64], run: &Range<usize>, step: f64) -> Vec<Range<usize>> {
    let mut found = Vec::new();
    let (mut first, mut low, mut high) = (run.start, f64::INFINITY, f64::NEG_INFINITY);
    for row in run.clone() {
        let (lower, higher) = (low.min(column[row]), high.max(column[row]));
        if higher - lower > 1.5 * step {
            found.push(first..row);
            (first, low, high) = (row, column[row], column[row]);
        } else {
            (low, high) = (lower, higher);
        }
    }
    found.push(first..run.end);
    found
}

/// The spacing of the values of a column, where all lie on a grid of it and the column visits many of them, goes to and fro between two of them as no command does, or it is
/// too `small` to have been commanded.
fn grid(column: &[f64], runs: &[Range<usize>], small: f64) -> Option<f64> {
    let mut values = column.to_vec();
    values.sort_by(f64::total_cmp);
    let greatest = values.iter().fold(0.0f64, |m, v| m.max(v.abs()));
    values.dedup_by(|a, b| (*a - *b).abs() <= 1e-9 * greatest);
    let gaps: Vec<f64> = values.windows(2).map(|w| w[1] - w[0]).collect();
    let least = gaps.iter().copied().fold(f64::INFINITY, f64::min);
    // a step written with few digits has spacings that differ in the last of them
    let alike: Vec<f64> = gaps.iter().copied().filter(|g| *g < 1.3 * least).collect();
    let step = median(&alike);
    let whole = |gap: &&f64| (**gap / step - (**gap / step).round()).abs() < OFF_GRID;
    let many = values.len() >= FEWEST_LEVELS || (values.len() >= 2 && step <= small);
    let wide = values[values.len() - 1] - values[0] > step * FEWEST_LEVELS as f64;
    let on_grid = step > 0.0 && gaps.iter().filter(whole).count() * 100 >= 98 * gaps.len();
    (on_grid && ((many && alike.len() * 4 >= gaps.len()) || (wide && goes_to_and_fro(column, runs, step)))).then_some(step)
}

/// Rows of a run at which a column takes another value.
fn changes(column: &[f64], run: &Range<usize>, step: f64) -> Vec<usize> {
    (run.start + 1..run.end).filter(|row| (column[*row] - column[*row - 1]).abs() > 0.5 * step).collect()
}

/// Whether a column often goes by one step and back by the same, now sooner and now later.
fn goes_to_and_fro(column: &[f64], runs: &[Range<usize>], step: f64) -> bool {
    let mut lengths = Vec::new();
    for run in runs {
        let change = |row: usize| (column[row] - column[row - 1]) / step;
        let changes = changes(column, run, step);
        let back = |w: &&[usize]| (change(w[0]) + change(w[1])).abs() < 0.5 && change(w[0]).abs() < 1.5;
        lengths.extend(changes.windows(2).filter(back).map(|w| w[1] - w[0]));
    }
    lengths.len() >= FEWEST_FLICKERS && lengths.iter().any(|length| *length != lengths[0])
}

/// Whether moving rows lie on exact lines: nobody's hand or thermometer does that, a program does.
fn on_exact_lines(column: &[f64], runs: &[Range<usize>], step: f64) -> bool {
    let (mut moving, mut exact) = (0usize, 0usize);
    for run in runs {
        for w in column[run.clone()].windows(4) {
            let changes = [w[1] - w[0], w[2] - w[1], w[3] - w[2]];
            if (w[3] - w[0]).abs() > 1.5 * step {
                moving += 1;
                exact += usize::from(changes.iter().all(|c| (c - changes[0]).abs() < 0.5 * step));
            }
        }
    }
    moving >= 20 && exact as f64 > COMMANDED * moving as f64
}

/// Whether what follows a column changes where the column does, by one step between longer stretches, and not on the way there.
fn jumps_with(column: &[f64], runs: &[Range<usize>], step: f64, answer: &[f64]) -> bool {
    let (mut at_once, mut squares, mut in_all, mut found) = (0.0, 0.0f64, 0.0, 0usize);
    for run in runs {
        let changes = changes(column, run, step);
        for (k, row) in changes.iter().enumerate() {
            let before = row - if k > 0 { changes[k - 1] } else { run.start };
            let after = changes.get(k + 1).copied().unwrap_or(run.end) - row;
            let reach = before.min(after) / 2;
            let change = column[*row] - column[*row - 1];
            if reach >= 4 && change.abs() < 1.5 * step {
                // means on either side, near and far: a jump has the difference of the far ones between the near ones
                let mean = |rows: Range<usize>| answer[rows.clone()].iter().sum::<f64>() / rows.len() as f64;
                let near = reach.div_ceil(4);
                let jump = change.signum() * (mean(*row..row + near) - mean(row - near..*row));
                (at_once, squares) = (at_once + jump, squares + jump * jump);
                in_all += change.signum() * (mean(row + reach - near..row + reach) - mean(row - reach..row - reach + near));
                found += 1;
            }
        }
    }
    // where the column flickers between two values, what follows it does one thing and another
    found >= 4 && in_all != 0.0 && at_once / in_all > REAL_CHANGE && at_once > ALL_ALIKE * (found as f64 * squares).sqrt()
}

#[cfg(test)]
#[allow(clippy::single_range_in_vec_init)]
mod tests {
    use super::*;
    use rand::SeedableRng;
    use rand_distr::{Distribution, Normal};

    fn written(truth: &[f64], step: f64, noise: f64, seed: u64) -> Vec<f64> {
        let mut rng = rand_chacha::ChaCha8Rng::seed_from_u64(seed);
        let normal = Normal::new(0.0, noise).unwrap();
        truth.iter().map(|t| ((t + normal.sample(&mut rng)) / step).round() * step).collect()
    }

    /// Holds at loads that no step hits, and ramps between them.
    fn holds() -> Vec<f64> {
        (0..1200)
            .map(|i| {
                let (k, within) = (i / 100, f64::from(i % 100));
                let level = |k: i32| 0.313 * f64::from(if k < 7 { k } else { 13 - k });
                level(k) + (level(k + 1) - level(k)) * (within / 20.0).min(1.0)
            })
            .collect()
    }

    #[test]
    fn a_hold_in_steps_errs_alike_in_all_its_rows() {
        let truth = holds();
        let column = written(&truth, 0.05, 0.005, 1);
        let found = rounded(&column, &[0..1200], Some(&truth), 0.0).unwrap();
        approx::assert_relative_eq!(found.step, 0.05, max_relative = 1e-6);
        // noise of a tenth of a step leaves two thirds of the error as it is (section 5.4: exp(-0.39))
        let held = found.stays(90) / (0.05f64.powi(2) / 12.0);
        assert!((0.5..1.0).contains(&held), "{held}");
        assert!((40..100).all(|row| found.memory[row] > 0.99));
        // all levels but the highest are held on the way up and on the way down
        assert_eq!(found.same.len(), 5);
        assert!(found.same.iter().any(|level| level[90] > 0.0 && level[1190] > 0.0 && level[250] == 0.0));
    }

    /// A column that rests on the edge of a step flickers there; that does not make its other holds err less.
    #[test]
    fn one_hold_on_an_edge_does_not_speak_for_the_others() {
        let level = |hold: usize| if hold == 3 { 1.025 } else { 0.313 * hold as f64 };
        let truth: Vec<f64> = (0..4000).map(|row| level(if row < 3000 { 3 } else { row / 100 % 10 })).collect();
        let found = rounded(&written(&truth, 0.05, 0.002, 5), &[0..4000], Some(&truth), 0.0).unwrap();
        // two more of the ten flicker now and then
        let held = found.stays(3910) / (0.05f64.powi(2) / 12.0);
        assert!((0.3..1.0).contains(&held), "{held}");
    }

    /// Two holds under one noise: on the edge of a step every other row is another value, in its middle none is.
    #[test]
    fn each_plateau_flickers_by_itself() {
        let truth: Vec<f64> = (0..2000).map(|row| [1.025, 1.3, 1.6, 1.9][row / 500]).collect();
        let found = rounded(&written(&truth, 0.05, 0.004, 6), &[0..2000], Some(&truth), 1.0).unwrap();
        // of independent rows on an edge half are one value and half the other: q^2 / 4; a change to and fro in half of the pairs
        approx::assert_relative_eq!(found.flicker[250], 0.05f64.powi(2) / 4.0, max_relative = 0.3);
        assert_eq!((found.flicker[750], found.flicker[1750]), (0.0, 0.0));
        approx::assert_relative_eq!(found.white, found.flicker[250] / 4.0, max_relative = 1e-9);
    }

    #[test]
    fn the_error_that_stays_is_that_of_a_sawtooth_damped_by_noise() {
        approx::assert_relative_eq!(bias(0.0), 1.0 / 12.0, max_relative = 0.01);
        // drawn: noise of a quarter of a step, over all places in the step
        let places: Vec<f64> = (0..400).map(|k| (f64::from(k) + 0.5) / 400.0).collect();
        let (mut stays, mut white) = (0.0, 0.0);
        for (k, place) in places.iter().enumerate() {
            let column = written(&[*place; 4000], 1.0, 0.25, k as u64);
            let mean = column.iter().sum::<f64>() / 4000.0;
            stays += (mean - place).powi(2) / 400.0;
            white += column.iter().map(|v| (v - mean).powi(2)).sum::<f64>() / 4000.0 / 400.0;
        }
        // 4000 rows leave 0.14 / 4000 of the independent part in each mean, 1 % of what stays
        approx::assert_relative_eq!(bias(white), stays, max_relative = 0.05);
    }

    /// On the edge of a step the column says one value and the next in turn, while the load holds still.
    #[test]
    fn a_hold_on_an_edge_is_one_level_and_a_ramp_is_none() {
        let truth: Vec<f64> = holds().iter().map(|load| load * 0.625 / 0.626).collect();
        let column = written(&truth, 0.05, 0.004, 7);
        let found = rounded(&column, &[0..1200], Some(&truth), 0.0).unwrap();
        let mut levelled = column.clone();
        found.level_holds(&mut levelled);
        // 0.625 N is the edge between two values: rows 120 to 200 flicker
        assert!(column[130..190].windows(2).any(|w| w[0] < w[1]) && levelled[130..190].windows(2).all(|w| w[0] == w[1]));
        approx::assert_abs_diff_eq!(levelled[160], 0.625, epsilon = 0.01);
        let on_the_way = 105..115;
        assert_eq!(levelled[on_the_way.clone()], column[on_the_way]);
    }

    /// Seven values of a load cell: that it goes by 50 mN to and fro says in which steps it is written.
    #[test]
    fn few_levels_are_a_grid_where_one_of_them_flickers() {
        let levels = [0.0, 1.125, 2.16, 3.13, 4.5];
        let truth: Vec<f64> = (0..2000).map(|row| levels[row / 100 % 5]).collect();
        let step =
            |noise: f64, truth: &[f64]| rounded(&written(truth, 0.05, noise, 8), &[0..2000], Some(truth), 0.0).map(|r| r.step);
        approx::assert_relative_eq!(step(0.004, &truth).unwrap(), 0.05, max_relative = 1e-6);
        let commanded: Vec<f64> = truth.iter().map(|load| if *load == 1.125 { 1.1 } else { *load }).collect();
        assert_eq!(step(0.0, &commanded), None);
        // a valve that somebody opens and shuts at random
        let valve: Vec<f64> = (0..2000).map(|row| f64::from(u8::from((row * row) % 17 < 8))).collect();
        assert_eq!(rounded(&valve, &[0..2000], None, 0.0), None);
    }

    #[test]
    fn what_somebody_commanded_in_steps_is_no_rounding() {
        let stairs: Vec<f64> = (0..1200).map(|i| 0.1 * f64::from(i / 50)).collect();
        assert_eq!(rounded(&stairs, &[0..1200], Some(&stairs), 0.0), None);
        let ramp: Vec<f64> = (0..1200).map(|i| 0.125 * f64::from((i % 100).min(30))).collect();
        assert_eq!(rounded(&ramp, &[0..1200], Some(&ramp), 0.0), None);
        // set points alone say nothing of a step
        let points: Vec<f64> = (0..1200).map(|i| f64::from(i / 100 % 5)).collect();
        assert_eq!(rounded(&points, &[0..1200], Some(&points), 0.0), None);
    }

    #[test]
    fn a_slow_ramp_in_steps_is_rounding_and_noise_of_a_step_is_none() {
        let truth: Vec<f64> = (0..1200).map(|i| 20.0 + 0.02 * f64::from(i)).collect();
        let coarse = written(&truth, 0.5, 0.03, 2);
        let found = rounded(&coarse, &[0..1200], Some(&truth), 1.0).unwrap();
        approx::assert_relative_eq!(found.step, 0.5, max_relative = 1e-6);
        // text with three decimals
        let text: Vec<f64> = written(&truth, 0.0625, 0.02, 3).iter().map(|v| (v * 1e3).round() / 1e3).collect();
        let found = rounded(&text, &[0..1200], Some(&truth), 1.0).unwrap();
        approx::assert_relative_eq!(found.step, 0.0625, max_relative = 0.02);
        let dithered = written(&truth, 0.05, 0.1, 4);
        assert_eq!(rounded(&dithered, &[0..1200], Some(&truth), 1.0), None);
    }
}
