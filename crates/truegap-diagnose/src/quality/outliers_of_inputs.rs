//! Single values of an input far from their neighbours, which the reading does not follow: an error value of a thermometer, a row that was lost.
//!
//! Such a value is no load. Its row is left out, or a base model that follows it would carry its error into every number.
//!
//! Limits: at most three rows together; of columns that stand still from row to row only those whose steps the reading follows at once, since a pulse that it does not follow may be a command to what is
//! slow; a value that is an error in every column at once is not seen.

use crate::{
    data::problem::Problem,
    quality::{
        dead::inputs_of,
        notice::{Notice, NoticeKind},
        outliers::{first_of, groups, stands_out, white_sd},
        rows::Rows,
        tuning::{AS_HIGH, FEWEST_STEPS, FOLLOWED, HALVES_BEYOND, JUMPS, OUTLIER_FAR, TOO_MANY_OUTLIERS},
    },
    stats::{median, resolution, spread},
    text::Scale,
};
use std::ops::Range;
use truegap_core::Inputs;

/// A notice, and the rows that are to be left out.
pub fn outliers_of_inputs(problem: &Problem<'_>, rows: &Rows<'_>) -> Option<(Notice, Vec<usize>)> {
    let response_sd = white_sd(problem.response, &problem.inputs.runs());
    let of_each = columns_of(problem.inputs).into_iter().filter(|column| !goes_round(column)).map(|column| {
        let groups = not_followed(problem, column.values, response_sd);
        (column, groups)
    });
    let found: Vec<_> = of_each.filter(|(_, groups)| !groups.is_empty()).collect();
    let mut out: Vec<usize> = found.iter().flat_map(|(_, groups)| groups.iter().flat_map(Clone::clone)).collect();
    out.sort_unstable();
    out.dedup();
    if out.is_empty() {
        return None;
    }
    let told: Vec<String> = found.iter().map(|(column, groups)| told(column, groups, rows)).collect();
    let each = if out.len() == 1 { "its row was" } else { "their rows were" };
    let says = format!(
        "{} while the reading did not move; {each} left out. Look for an error value of the logger or a loose contact",
        told.join("; ")
    );
    Some((Notice { kind: NoticeKind::Outliers, says, rows: rows.numbers_of(&out), withholds: false }, out))
}

/// A column that was recorded beside the reading.
struct Column<'a> {
    name: &'a str,
    unit: &'a str,
    values: &'a [f64],
}

fn columns_of(inputs: &Inputs) -> Vec<Column<'_>> {
    let others = [("humidity", "%", &inputs.humidity_pct), ("simulation", "", &inputs.simulated)];
    let others = others.into_iter().filter_map(|(name, unit, column)| column.as_deref().map(|values| (name, unit, values)));
    let drivers = inputs.drivers.iter().map(|d| (d.name.as_str(), d.unit.as_str(), d.values.as_slice()));
    let all = inputs_of(inputs).into_iter().chain(others).chain(drivers);
    all.map(|(name, unit, values)| Column { name, unit, values }).collect()
}

/// Whether a column is a direction that goes all the way round: it jumps by a turn where nothing happens.
fn goes_round(column: &Column<'_>) -> bool {
    let turn = match column.unit {
        "deg" | "°" => 360.0,
        "rad" => std::f64::consts::TAU,
        _ => return false,
    };
    let span = spread(column.values);
    span > 0.9 * turn && span <= turn
}

/// Rows of a column that stand out of their neighbours; none where so many do that they were done.
fn not_followed(problem: &Problem<'_>, column: &[f64], response_sd: f64) -> Vec<Range<usize>> {
    let runs = problem.inputs.runs();
    let moves = moves_as_a_rule(column, &runs);
    let far = OUTLIER_FAR * white_sd(column, &runs).max(resolution(column));
    let middle = median(column);
    let half = median(&column.iter().map(|value| (value - middle).abs()).collect::<Vec<f64>>());
    let least = far.max(HALVES_BEYOND * half);
    let answers =
        |group: &Range<usize>| (0..=1).any(|late| stands_out(problem.response, &(group.start + late..group.end + late), 0.0));
    let is_followed_elsewhere = |group: &Range<usize>| {
        let height = (column[group.start] - column[group.start - 1]).abs();
        let steps = runs.iter().flat_map(|run| run.start + 2..run.end.saturating_sub(2));
        let steps = steps
            .filter(|row| (column[*row] - column[row - 1]).abs() >= AS_HIGH * height && !(group.start..=group.end).contains(row));
        let steps: Vec<usize> = steps.collect();
        let jump = |row: &usize| {
            (0.5 * (problem.response[row + 1] + problem.response[row + 2]
                - problem.response[row - 1]
                - problem.response[row - 2]))
                .abs()
        };
        let followed = steps.iter().filter(|row| jump(row) > JUMPS * response_sd).count();
        steps.len() >= FEWEST_STEPS && followed as f64 >= FOLLOWED * steps.len() as f64
    };
    let found =
        groups(&runs, |group| stands_out(column, group, least) && !answers(group) && (moves || is_followed_elsewhere(group)));
    let count: usize = found.iter().map(ExactSizeIterator::len).sum();
    if count as f64 > TOO_MANY_OUTLIERS * column.len() as f64 { Vec::new() } else { found }
}

/// Whether at least half of the rows differ from the one before.
fn moves_as_a_rule(column: &[f64], runs: &[Range<usize>]) -> bool {
    let steps = || runs.iter().flat_map(|run| column[run.clone()].windows(2));
    2 * steps().filter(|pair| pair[0] != pair[1]).count() >= steps().count()
}

/// `1 value of the force stands far outside its neighbours: row 41 (t = 4.0 s) has 0 N, 312 N beside it`.
fn told(column: &Column<'_>, groups: &[Range<usize>], rows: &Rows<'_>) -> String {
    let text = |value: f64| Scale::of(column.unit, value.abs()).text(value);
    let one = |group: &Range<usize>| {
        let [value, beside] = [column.values[group.start], column.values[group.start - 1]].map(text);
        format!("{} has {value}, {beside} beside it", rows.place(group.start))
    };
    let count: usize = groups.iter().map(ExactSizeIterator::len).sum();
    let what = if count == 1 { "value" } else { "values" };
    let stand = if count == 1 { "stands far outside its neighbours" } else { "stand far outside their neighbours" };
    format!("{count} {what} of the {} {stand}: {}", column.name, first_of(groups, one))
}
