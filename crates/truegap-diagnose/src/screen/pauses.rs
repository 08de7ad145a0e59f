//! Pauses inside runs, of which nothing was recorded.
//!
//! Limits: only with a clock; what happened in a pause cannot be known.

use super::Rows;
use crate::notice::{Notice, NoticeKind};
use crate::number::Scale;
use crate::problem::Problem;
use truegap_core::Inputs;

/// Usual steps beyond which a step is a pause.
const STEPS: f64 = 30.0;

/// The usual step, s, and the rows before which time jumps inside a run; `None` without a clock.
pub(crate) fn after_pauses(inputs: &Inputs) -> Option<(f64, Vec<usize>)> {
    inputs.time_s.as_ref()?;
    let steps = inputs.steps_s();
    let mut sorted: Vec<f64> = steps.iter().copied().filter(|s| *s > 0.0).collect();
    let middle = sorted.len() / 2;
    let usual = *sorted.get_mut(..).filter(|s| !s.is_empty())?.select_nth_unstable_by(middle, f64::total_cmp).1;
    Some((usual, (0..steps.len()).filter(|row| steps[*row] > STEPS * usual).collect()))
}

/// A notice where time jumps inside a run.
pub fn pauses(problem: &Problem<'_>, rows: &Rows<'_>) -> Option<Notice> {
    let steps = problem.inputs.steps_s();
    let (usual, found) = after_pauses(problem.inputs)?;
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
