//! Single readings far from their neighbours while nothing was done to the sensor.
//!
//! Limits: at most three rows together; slower bursts are left to the noise model.

use crate::{
    data::{context::load_column, problem::Problem},
    quality::tuning::{OUTLIER_BEYOND, OUTLIER_FAR, OUTLIERS_NAMED, OUTLIERS_TOGETHER, TOO_MANY_OUTLIERS},
    quality::{
        notice::{Notice, NoticeKind},
        rows::Rows,
    },
    stats::{resolution, sd_of_differences},
};
use std::ops::Range;

/// A notice, and the rows that are to be left out; none are where there are too many.
pub fn outliers(problem: &Problem<'_>, rows: &Rows<'_>) -> Option<(Notice, Vec<usize>)> {
    let runs = problem.inputs.runs();
    let response = problem.response;
    let sd = white_sd(response, &runs).max(resolution(response));
    let load = load_column(problem.inputs, problem.simulator);
    let still: Vec<&[f64]> = [load.as_deref(), problem.inputs.temperature_c.as_deref()].into_iter().flatten().collect();
    let drivers = problem.inputs.drivers.iter().map(|driver| driver.values.as_slice());
    let still: Vec<&[f64]> = still.into_iter().chain(drivers).collect();
    let found =
        groups(&runs, |group| stands_out(response, group, OUTLIER_FAR * sd) && still.iter().all(|c| !stands_out(c, group, 0.0)));
    let out: Vec<usize> = found.iter().flat_map(Clone::clone).collect();
    if out.is_empty() {
        return None;
    }
    let too_many = out.len() as f64 > TOO_MANY_OUTLIERS * response.len() as f64;
    let notice = Notice {
        kind: NoticeKind::Outliers,
        says: says(&found, out.len(), too_many, response, rows),
        rows: rows.numbers(found.iter()),
        withholds: too_many,
    };
    Some((notice, if too_many { Vec::new() } else { out }))
}

fn says(found: &[Range<usize>], count: usize, too_many: bool, response: &[f64], rows: &Rows<'_>) -> String {
    let one = |group: &Range<usize>| {
        let beside = response[group.start - 1];
        format!("{} reads {}, {} beside it", rows.place(group.start), rows.reading(response[group.start]), rows.reading(beside))
    };
    let named = first_of(found, one);
    let (what, fix) = match count {
        1 => ("1 reading stands far outside its neighbours".to_owned(), "it was"),
        _ => (format!("{count} readings stand far outside their neighbours"), "they were"),
    };
    let end = if too_many {
        "that is too many for a channel that works: look for interference or a loose contact and record again".to_owned()
    } else {
        format!("{fix} left out; look for interference or a loose contact")
    };
    format!("{what} while nothing was done: {named}; {end}")
}

/// Up to [`OUTLIERS_TOGETHER`] rows together that are outliers, from the beginning of each run on.
pub(super) fn groups(runs: &[Range<usize>], is_one: impl Fn(&Range<usize>) -> bool) -> Vec<Range<usize>> {
    let mut found = Vec::new();
    for run in runs {
        let mut row = run.start + 2;
        while row + 2 < run.end {
            let lengths = (1..=OUTLIERS_TOGETHER).filter(|length| row + length + 2 <= run.end);
            let group = lengths.map(|length| row..row + length).find(&is_one);
            row = group.as_ref().map_or(row + 1, |g| g.end);
            found.extend(group);
        }
    }
    found
}

/// The first [`OUTLIERS_NAMED`] of them, and how many more there are.
pub(super) fn first_of(found: &[Range<usize>], one: impl Fn(&Range<usize>) -> String) -> String {
    let named = found.iter().take(OUTLIERS_NAMED).map(one).collect::<Vec<_>>().join("; ");
    match found.len().saturating_sub(OUTLIERS_NAMED) {
        0 => named,
        more => format!("{named}; and {more} more"),
    }
}

/// Whether all rows of `group` lie on one side of the two rows before and after, by more than `least` and several times their range.
pub(super) fn stands_out(column: &[f64], group: &Range<usize>, least: f64) -> bool {
    let beside = [group.start - 2, group.start - 1, group.end, group.end + 1];
    if beside[3] >= column.len() {
        return false;
    }
    let (low, high) = crate::quality::rows::ends(column, beside.into_iter());
    let reach = (OUTLIER_BEYOND * (high - low)).max(least);
    let (lowest, highest) = crate::quality::rows::ends(column, group.clone());
    lowest > high + reach || highest < low - reach
}

/// White noise from second differences, deaf to corners and spikes.
pub(super) fn white_sd(column: &[f64], runs: &[Range<usize>]) -> f64 {
    let second: Vec<f64> =
        runs.iter().flat_map(|run| column[run.clone()].windows(3).map(|w| (w[0] - 2.0 * w[1] + w[2]).abs())).collect();
    sd_of_differences(&second, 6.0)
}
