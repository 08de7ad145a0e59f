//! Channels that stop following: one value for many rows, while what they should follow moves.
//!
//! Limits: exactly one value; a channel that follows nothing but its own noise is found as a misfit, not here.

use crate::{
    data::problem::Problem,
    quality::{
        notice::{Notice, NoticeKind},
        rows::{Rows, drivers, equal_stretches, moved, standing_still},
    },
    stats::spread,
    text::Scale,
};
use std::ops::Range;
use truegap_core::Inputs;

/// Fewest rows of one value.
const FEWEST: usize = 20;
/// Share of all rows, at least.
const SHARE: f64 = 0.02;
/// Share of its range that a driver (or the reading) must cross meanwhile.
const CROSSED: f64 = 0.3;
/// Share of neighbouring values that are equal elsewhere, at most.
const COARSE: f64 = 0.2;

/// Long stretches of one value, while `others` move, in a column that does not stand still elsewhere.
fn stuck(column: &[f64], runs: &[Range<usize>], meanwhile: impl Fn(&Range<usize>) -> f64) -> Vec<Range<usize>> {
    let stretches = equal_stretches(column, runs);
    let longest = FEWEST.max((SHARE * column.len() as f64) as usize);
    if standing_still(&stretches, longest) > COARSE {
        return Vec::new();
    }
    stretches.into_iter().filter(|s| s.len() >= longest && meanwhile(s) > CROSSED).collect()
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
fn inputs_of(inputs: &Inputs) -> Vec<(&'static str, &'static str, &[f64])> {
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
        let value = column[longest.start];
        let says = format!(
            "the {name} stays at exactly {} in {}, {} rows, while the reading moves by {:.0} % of its range: the column is dead or hangs. Check \
             its logger, and record again or leave these rows out",
            Scale::of(unit, value.abs()).text(value),
            rows.places(longest),
            longest.len(),
            100.0 * reading_moves(longest)
        );
        Some(Notice { kind: NoticeKind::DeadInput, says, rows: rows.numbers(found.iter()), withholds: true })
    };
    inputs_of(problem.inputs).into_iter().filter_map(notice).collect()
}
