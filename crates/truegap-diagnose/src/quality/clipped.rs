//! Readings that end at exactly one value where the inputs go on.
//!
//! Limits: a rail without noise; readings that bend over near the end of a range are for the effect `saturation` to find.

use crate::{
    data::problem::Problem,
    quality::tuning::{CLIP_COARSE, CLIP_CROSSED, CLIP_ORDINARY, FEWEST_CLIPPED, PASSING, SHARE_CLIPPED},
    quality::{
        notice::{Notice, NoticeKind},
        rows::{Rows, drivers, ends, equal_stretches, moved, standing_still},
    },
    stats::spread,
};
use std::ops::Range;

/// Share of all rows at the rail above which they are left in: the rail is what is read as a rule, and hardly anything is known without it.
const MOST: f64 = 0.5;

/// A notice where readings are clipped, and the rows at the rail, which say no more than that the true reading lies beyond it: they are to be left out.
pub fn clipped_rows(problem: &Problem<'_>, rows: &Rows<'_>) -> Option<(Notice, Vec<usize>)> {
    let (notice, out) = found(problem, rows)?;
    let says = format!(
        "{}; these rows were left out, for they say no more than that the true reading lies beyond. Widen the range and record again",
        notice.says
    );
    (out.len() as f64 <= MOST * problem.response.len() as f64)
        .then_some((Notice { kind: NoticeKind::ClippedRows, says, ..notice }, out))
}

/// A notice where readings are clipped.
pub fn clipped(problem: &Problem<'_>, rows: &Rows<'_>) -> Option<Notice> {
    let (notice, _) = found(problem, rows)?;
    let says = format!(
        "{}. Widen the range and record again, or leave these rows out; until then nothing but saturation is looked for",
        notice.says
    );
    Some(Notice { says, ..notice })
}

fn found(problem: &Problem<'_>, rows: &Rows<'_>) -> Option<(Notice, Vec<usize>)> {
    let runs = problem.inputs.runs();
    let stretches = equal_stretches(problem.response, &runs);
    let (least, greatest) = ends(problem.response, 0..problem.response.len());
    let rails = [(greatest, "never goes above"), (least, "never goes below")];
    let found: Vec<Rail<'_>> = rails.into_iter().filter_map(|(rail, words)| at(problem, rows, &stretches, rail, words)).collect();
    if found.is_empty() {
        return None;
    }
    let places = found.iter().map(|rail| rail.says.as_str()).collect::<Vec<_>>().join(", and ");
    let says = format!("the reading {places}; it is clipped by the range of the converter or the software");
    let on_rails = || found.iter().flat_map(|rail| rail.stretches.iter().copied());
    let notice = Notice { kind: NoticeKind::Clipped, says, rows: rows.numbers(on_rails()), withholds: false };
    let mut out: Vec<usize> = on_rails().flat_map(|stretch| stretch.clone()).collect();
    // rows are looked for among them by halves
    out.sort_unstable();
    Some((notice, out))
}

/// One end of the range of a converter, with the stretches of rows that lie on it.
struct Rail<'a> {
    stretches: Vec<&'a Range<usize>>,
    says: String,
}

fn at<'a>(problem: &Problem<'_>, rows: &Rows<'_>, stretches: &'a [Range<usize>], rail: f64, words: &str) -> Option<Rail<'a>> {
    let on_rail: Vec<&Range<usize>> = stretches.iter().filter(|s| problem.response[s.start] == rail).collect();
    let count: usize = on_rail.iter().map(|s| s.len()).sum();
    let long = on_rail.iter().map(|s| s.len()).max().unwrap_or(0);
    let enough = count >= FEWEST_CLIPPED && count as f64 >= SHARE_CLIPPED * problem.response.len() as f64 && long >= 4;
    let met = || a_driver_goes_on(problem, &on_rail) || runs_into_it(problem, &on_rail);
    if !enough || standing_still(stretches, 4) > CLIP_COARSE || !met() {
        return None;
    }
    let first = on_rail.iter().max_by_key(|s| s.len())?;
    let says =
        format!("{words} {}: {count} rows lie exactly there, the longest stretch {}", rows.reading(rail), rows.places(first));
    Some(Rail { stretches: on_rail, says })
}

/// Whether the reading runs into the rail and off it without a jump, while a driver moves: a channel that hangs jumps when it comes back, wherever the reading
/// has gone meanwhile. The reading may lag behind what drives it, so that the same input is met on the rail and elsewhere.
fn runs_into_it(problem: &Problem<'_>, on_rail: &[&Range<usize>]) -> bool {
    let response = problem.response;
    let runs = problem.inputs.runs();
    let inside = |row: usize| on_rail.iter().any(|s| s.contains(&row));
    let step = |row: usize| (response[row] - response[row - 1]).abs();
    let pairs = || runs.iter().flat_map(|run| run.start + 1..run.end);
    let mut steps: Vec<f64> = pairs().filter(|row| !inside(*row) && !inside(row - 1)).map(step).collect();
    steps.sort_by(f64::total_cmp);
    let Some(ordinary) = steps.get(CLIP_ORDINARY * steps.len() / 100).copied() else { return false };
    let drivers = drivers(problem);
    let mut edges = pairs().filter(|row| inside(*row) != inside(row - 1)).map(step).peekable();
    edges.peek().is_some()
        && edges.all(|edge| edge <= ordinary)
        && on_rail.iter().any(|s| s.len() >= 4 && moved(&drivers, s) > CLIP_CROSSED)
}

/// Whether a driver crosses part of its range on the rail, and hardly any other row lies in that part: the rail is what is read there.
fn a_driver_goes_on(problem: &Problem<'_>, on_rail: &[&Range<usize>]) -> bool {
    let mut inside = vec![false; problem.response.len()];
    on_rail.iter().for_each(|s| inside[(*s).clone()].fill(true));
    drivers(problem).iter().any(|driver| {
        // the middle nine tenths of the rows on the rail: noise at its edge aside
        let mut at: Vec<f64> = (0..inside.len()).filter(|row| inside[*row]).map(|row| driver[row]).collect();
        at.sort_by(f64::total_cmp);
        let (low, high) = (at[at.len() / 20], at[at.len() - 1 - at.len() / 20]);
        let others = (0..inside.len()).filter(|row| !inside[*row] && (low..=high).contains(&driver[*row])).count();
        high - low > CLIP_CROSSED * spread(driver) && (others as f64) < PASSING * at.len() as f64
    })
}
