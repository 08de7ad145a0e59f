//! Pauses inside runs, of which nothing was recorded.
//!
//! Limits: only with a clock; what happened in a pause cannot be known.

use crate::{
    data::{pauses::after_pauses, problem::Problem},
    quality::{
        notice::{Notice, NoticeKind},
        rows::Rows,
    },
    text::Scale,
};
/// A notice where time jumps inside a run.
pub fn pauses(problem: &Problem<'_>, rows: &Rows<'_>) -> Option<Notice> {
    let steps = problem.inputs.steps_s();
    let (usual, mut found) = after_pauses(problem.inputs)?;
    // where rows were left out the clock went on being recorded
    found.retain(|row| rows.given.is_none_or(|given| *row == 0 || given[*row] == given[row - 1] + 1));
    let longest = *found.iter().max_by(|a, b| steps[**a].total_cmp(&steps[**b]))?;
    let text = |s: f64| Scale::of("s", s).text(s);
    let says = format!(
        "time jumps by {} before {}, inside a run whose usual step is {}{}: what happened meanwhile is unknown to physics that remembers. \
         Start a new run there if the sensor was touched",
        text(steps[longest]),
        rows.place(longest),
        text(usual),
        if found.len() > 1 { format!(" ({} such pauses)", found.len()) } else { String::new() }
    );
    Some(Notice { kind: NoticeKind::Gap, says, rows: rows.numbers_of(&found), withholds: false })
}
