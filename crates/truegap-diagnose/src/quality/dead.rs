//! Channels that stop following: one value for many rows, while what they should follow moves.
//!
//! Limits: an input is called dead only where it is nearly certain: it was measured, not commanded, and nothing else that was recorded moved the reading; exactly one value; a channel that follows nothing but its own noise is found as a misfit, not here.

use crate::{
    data::problem::Problem,
    quality::tuning::{AT_FIRST, DEAD_COARSE, DEAD_CROSSED, DRIVEN, FEWEST_DEAD, JITTER_BENDS, JITTERS, SHARE_DEAD},
    quality::{
        notice::{Notice, NoticeKind},
        rows::{Rows, drivers, equal_stretches, moved, standing_still},
    },
    stats::spread,
    text::Scale,
};
use std::ops::Range;
use truegap_core::Inputs;

/// Long stretches of one value, while `others` move, in a column that does not stand still elsewhere.
fn stuck(column: &[f64], runs: &[Range<usize>], meanwhile: impl Fn(&Range<usize>) -> f64) -> Vec<Range<usize>> {
    let stretches = equal_stretches(column, runs);
    let longest = FEWEST_DEAD.max((SHARE_DEAD * column.len() as f64) as usize);
    if standing_still(&stretches, longest) > DEAD_COARSE {
        return Vec::new();
    }
    stretches.into_iter().filter(|s| s.len() >= longest && meanwhile(s) > DEAD_CROSSED).collect()
}

/// A notice where the reading hangs.
pub fn dead_channel(problem: &Problem<'_>, rows: &Rows<'_>) -> Option<Notice> {
    let drivers = drivers(problem);
    let found = stuck(problem.response, &problem.inputs.runs(), |rows| moved(&drivers, rows));
    let longest = found.iter().max_by_key(|s| s.len())?;
    let says = format!(
        "the reading stays at exactly {} in {}, {} rows, while the inputs move by {:.0} % of their range: the channel is dead or hangs. Check \
         the wiring and the logger, and record again or leave these rows out",
        rows.reading(problem.response[longest.start]),
        rows.places(longest),
        longest.len(),
        100.0 * moved(&drivers, longest)
    );
    Some(Notice { kind: NoticeKind::DeadChannel, says, rows: rows.numbers(found.iter()), withholds: true })
}

/// Columns that a dead logger leaves standing, with name and unit.
pub(super) fn inputs_of(inputs: &Inputs) -> Vec<(&'static str, &'static str, &[f64])> {
    let columns = [
        ("force", "N", &inputs.force_n),
        ("pressure", "Pa", &inputs.pressure_pa),
        ("gap", "m", &inputs.gap_m),
        ("temperature", "°C", &inputs.temperature_c),
    ];
    columns.into_iter().filter_map(|(name, unit, column)| column.as_deref().map(|c| (name, unit, c))).collect()
}

/// Notices for inputs that hang while the reading moves.
pub fn dead_inputs(problem: &Problem<'_>, rows: &Rows<'_>) -> Vec<Notice> {
    let runs = problem.inputs.runs();
    let range = spread(problem.response);
    let reading_moves = |rows: &Range<usize>| spread(&problem.response[rows.clone()]) / range;
    let notice = |(name, unit, column): (&str, &str, &[f64])| {
        let found = stuck(column, &runs, reading_moves);
        let longest = found.iter().max_by_key(|s| s.len())?;
        if !is_measured(column, &runs, &found) {
            return None; // a command stands still because it was given so
        }
        let certain = found.iter().any(|s| hangs(problem, column, s, &found));
        let value = column[longest.start];
        let judged = if certain {
            "the column is dead or hangs. Check its logger, and record again or leave these rows out"
        } else {
            "if it was held there, or is cut off at this value, nothing is wrong; if its logger hung, leave these rows out"
        };
        let says = format!(
            "the {name} stays at exactly {} in {}, {} rows, while the reading moves by {:.0} % of its range: {judged}",
            Scale::of(unit, value.abs()).text(value),
            rows.places(longest),
            longest.len(),
            100.0 * reading_moves(longest)
        );
        Some(Notice { kind: NoticeKind::DeadInput, says, rows: rows.numbers(found.iter()), withholds: certain })
    };
    inputs_of(problem.inputs).into_iter().filter_map(notice).collect()
}

/// Whether a column jitters outside of its long stretches, as what was measured does and what was commanded does not.
fn is_measured(column: &[f64], runs: &[Range<usize>], stuck: &[Range<usize>]) -> bool {
    let inside = |row: usize| stuck.iter().any(|s| s.contains(&row));
    let (mut all, mut bent, mut pairs, mut opposite) = (0, 0, 0, 0);
    for run in runs {
        let mut before = 0.0;
        for row in run.start + 2..run.end {
            let second = column[row] - 2.0 * column[row - 1] + column[row - 2];
            if (row - 2..=row).any(inside) {
                before = 0.0;
                continue;
            }
            all += 1;
            bent += usize::from(second != 0.0);
            pairs += usize::from(second * before != 0.0);
            opposite += usize::from(second * before < 0.0);
            before = second;
        }
    }
    all > 0 && bent as f64 > JITTER_BENDS * all as f64 && opposite as f64 > JITTERS * pairs.max(1) as f64
}

/// Whether a measured input hangs in a stretch: it is held at that value nowhere else, and the reading is driven there, by nothing else that was recorded, where
/// a reading that relaxes goes one way, and most of it at first.
fn hangs(problem: &Problem<'_>, column: &[f64], stretch: &Range<usize>, stuck: &[Range<usize>]) -> bool {
    let held_again = stuck.iter().any(|other| other != stretch && column[other.start] == column[stretch.start]);
    // the column itself stands still in the stretch
    let mut moving = inputs_of(problem.inputs).into_iter().map(|(_, _, other)| other).filter(|other| spread(other) > 0.0);
    let driven_otherwise = moving.any(|other| spread(&other[stretch.clone()]) / spread(other) > DEAD_CROSSED);
    !held_again && !driven_otherwise && !relaxes(&problem.response[stretch.clone()], spread(problem.response))
}

/// Whether a reading goes one way only, and most of it at first.
fn relaxes(reading: &[f64], range: f64) -> bool {
    let (mut highest, mut lowest, mut fall, mut rise) = (f64::NEG_INFINITY, f64::INFINITY, 0.0f64, 0.0f64);
    for value in reading {
        highest = highest.max(*value);
        lowest = lowest.min(*value);
        fall = fall.max(highest - value);
        rise = rise.max(value - lowest);
    }
    let third = &reading[..reading.len().div_ceil(3)];
    fall.min(rise) < DRIVEN * range && spread(third) > AT_FIRST * spread(reading)
}
