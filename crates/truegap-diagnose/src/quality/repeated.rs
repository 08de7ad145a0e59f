//! Rows that repeat the one before them: a logger that was not ready wrote the last reading again.
//!
//! Such rows hold no new measurement, and their noise is that of the row before: they are left out.
//!
//! A reading in steps that are coarser than its noise is equal in neighbouring rows as long as what it follows stands still: nothing repeats there.
//!
//! Limits: recordings with a clock; readings fine enough that noise hardly ever gives the same value twice; short repeats only, longer ones are a dead channel, and at the ends of the range a
//! clipped one.

use crate::{
    data::problem::Problem,
    quality::tuning::{A_FEW_REPEATS, FINE_STEPS, LONGEST_REPEAT, MORE_THAN_CHANCE, MOST_REPEATED},
    quality::{
        notice::{Notice, NoticeKind},
        rows::{Rows, ends, equal_stretches},
    },
    stats::{median, resolution},
};
use std::ops::Range;

/// A notice, and the rows that are to be left out.
pub fn repeated(problem: &Problem<'_>, rows: &Rows<'_>) -> Option<(Notice, Vec<usize>)> {
    // a table without a clock may hold what was found again and again
    problem.inputs.time_s.as_ref()?;
    let (response, runs) = (problem.response, problem.inputs.runs());
    let step = resolution(response);
    let pairs: Vec<usize> = runs.iter().flat_map(|run| run.start + 1..run.end).collect();
    let change = |row: &usize| (response[*row] - response[*row - 1]).abs();
    let changes: Vec<f64> = pairs.iter().map(change).filter(|d| *d > 0.5 * step).collect();
    if step <= 0.0 || median(&changes) < FINE_STEPS * step {
        return None;
    }
    let inputs = problem.inputs;
    let columns = [&inputs.force_n, &inputs.pressure_pa, &inputs.gap_m, &inputs.temperature_c, &inputs.simulated];
    let drivers = |row: usize| inputs.drivers.iter().all(|driver| driver.values[row] == driver.values[row - 1]);
    let whole = |row: usize| columns.iter().all(|c| c.as_ref().is_none_or(|c| c[row] == c[row - 1])) && drivers(row);
    let still: Vec<f64> = pairs.iter().filter(|row| whole(**row)).map(change).filter(|d| *d > 0.5 * step).collect();
    let coarse_at_rest = !still.is_empty() && median(&still) < FINE_STEPS * step;
    let counted = |row: usize| !(coarse_at_rest && whole(row));
    let (lowest, highest) = ends(response, 0..response.len());
    let stretches: Vec<_> = equal_stretches(response, &runs)
        .into_iter()
        .filter(|s| s.len() > 1 && s.len() <= LONGEST_REPEAT && response[s.start] != lowest && response[s.start] != highest)
        .map(|s| s.start + 1..s.end)
        .filter(|stretch| stretch.clone().all(counted))
        .collect();
    // rows that repeat in every column are hardly ever chance; a reading alone may repeat while the inputs go on
    let by_one = |counts: &dyn Fn(usize) -> bool| {
        pairs.iter().filter(|r| counted(**r) && counts(**r) && (change(r) / step).round() == 1.0).count()
    };
    let again = |counts: &dyn Fn(usize) -> bool| {
        let rows: Vec<usize> = stretches.iter().flat_map(Clone::clone).filter(|row| counts(*row)).collect();
        let by_chance = MORE_THAN_CHANCE * by_one(counts) + A_FEW_REPEATS;
        (rows.len() > by_chance && rows.len() as f64 <= MOST_REPEATED * response.len() as f64).then_some(rows)
    };
    let many = again(&|_| true).or_else(|| again(&whole));
    let again = many.or_else(|| {
        too_long(response, step, &runs, &stretches).filter(|rows| rows.len() as f64 <= FEW_ROWS * response.len() as f64)
    })?;
    let says = format!(
        "{} rows repeat the reading of the row before, the first is {}: the logger wrote old values again. They were left out; look whether it polls faster than the \
         converter converts",
        again.len(),
        rows.place(again[0])
    );
    let notice = Notice { kind: NoticeKind::RepeatedRows, says, rows: rows.numbers_of(&again), withholds: false };
    Some((notice, again))
}

/// Rows on either side by which it is judged how often neighbours are equal.
const BESIDE: usize = 100;
/// Expected number of such stretches by chance in the whole recording, at most.
const BY_CHANCE: f64 = 0.01;
/// Share of rows in stretches that are too long, at most: more is a reading that does not change.
const FEW_ROWS: f64 = 0.02;

/// Rows on either side by which the noise of a reading that stands is judged.
const CLOSE: usize = 10;
/// Noises of the reading by which one that stands differs from row to row, at most.
const WITHIN_NOISE: f64 = 4.0;
/// Rows by which it is judged how fast a reading goes on.
const ONWARD: usize = 3;
/// Steps of those rows that the first one may be.
const STARTS_AS_FAST: f64 = 1.5;
/// Share of equal neighbours where a reading stands and its noise is far below its step, at most.
const ALL_BUT_ALWAYS: f64 = 0.9;

/// Noise of the reading about a smooth course close to a stretch, in steps: from second differences, which a steady motion leaves at 0.
fn noise_in_steps(response: &[f64], step: f64, run: &Range<usize>, stretch: &Range<usize>) -> f64 {
    let before = run.start.max((stretch.start - 1).saturating_sub(CLOSE))..stretch.start;
    let after = stretch.end..run.end.min(stretch.end + CLOSE);
    let bends = [before, after].into_iter().flat_map(|rows| response[rows].windows(3).map(|w| (w[0] - 2.0 * w[1] + w[2]).abs()));
    let bends: Vec<f64> = bends.collect();
    // mean size of a Gaussian of variance 6: sqrt(12 / pi)
    let sd = bends.iter().sum::<f64>() / bends.len().max(1) as f64 / (12.0 / std::f64::consts::PI).sqrt();
    (sd / step).max(1.0 / 12f64.sqrt())
}

/// Chance that neighbours are equal where the reading stands with this noise, in steps: the density of their difference at 0.
fn equal_where_it_stands(noise: f64) -> f64 {
    (0.5 / (noise * std::f64::consts::PI.sqrt())).min(ALL_BUT_ALWAYS)
}

/// Rows of stretches longer than equal neighbours would make by chance, as often as they are equal nearby; `None` where there are none.
///
/// A reading that was held jumps when it comes back: the chance counts how rare such a step is as well. One that comes back within its noise, or starts to move, may have stood, as
/// friction makes it although the input moves: then neighbours are equal as often as noise and step make them.
fn too_long(response: &[f64], smallest: f64, runs: &[Range<usize>], stretches: &[Range<usize>]) -> Option<Vec<usize>> {
    let step = |row: usize| (response[row] - response[row - 1]).abs();
    let mut steps: Vec<f64> = runs.iter().flat_map(|run| run.start + 1..run.end).map(step).collect();
    steps.sort_by(f64::total_cmp);
    let as_large = |jump: f64| (steps.len() - steps.partition_point(|s| *s < jump)).max(1) as f64 / steps.len().max(1) as f64;
    let improbable = |stretch: &&Range<usize>| {
        let Some(run) = runs.iter().find(|run| run.contains(&stretch.start)) else { return false };
        let before = run.start.max(stretch.start.saturating_sub(BESIDE)) + 1..stretch.start;
        let after = stretch.end + 1..run.end.min(stretch.end + BESIDE);
        let pairs = before.len() + after.len();
        let equal = before.chain(after).filter(|row| response[*row] == response[*row - 1]).count();
        let often = (equal + 1) as f64 / (pairs + 2) as f64;
        let noise = noise_in_steps(response, smallest, run, stretch);
        let back = if stretch.end < run.end { step(stretch.end) } else { 0.0 };
        // one that was held makes up for all rows that it missed; one that stood starts as fast as it goes on
        let onward: Vec<f64> = (stretch.end + 1..run.end.min(stretch.end + 1 + ONWARD)).map(step).collect();
        let onward = if onward.is_empty() { 0.0 } else { median(&onward) };
        let may_stand = back < smallest * (WITHIN_NOISE * noise).max(1.5) + STARTS_AS_FAST * onward;
        let often = if may_stand { often.max(equal_where_it_stands(noise)) } else { often };
        let jump = if stretch.end < run.end { as_large(back) } else { 1.0 };
        response.len() as f64 * often.powi(stretch.len() as i32) * jump < BY_CHANCE
    };
    let rows: Vec<usize> = stretches.iter().filter(improbable).flat_map(Clone::clone).collect();
    (!rows.is_empty()).then_some(rows)
}
