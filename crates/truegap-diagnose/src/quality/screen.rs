//! What is wrong with a recording, before any physics is named: one kind of trouble a file.
//!
//! Limits: looks at one recording at a time; what is told here is certain or nearly so, doubts are told by [`crate::quality::preconditions`].

use crate::{
    data::problem::Problem,
    quality::{clipped, dead, notice::Notice, pauses, range, rows::Rows, wrong_sensor, wrong_unit},
};
/// Everything that is wrong, worst first; rows are counted from 0 here and from 1 in the words.
pub fn troubles(problem: &Problem<'_>, rows: &Rows<'_>) -> Vec<Notice> {
    let mut list = Vec::new();
    list.extend(wrong_sensor::wrong_sensor(problem));
    list.extend(wrong_unit::wrong_unit(problem));
    list.extend(range::out_of_range(problem, rows));
    let clipped = clipped::clipped(problem, rows);
    list.extend(dead::dead_channel(problem, rows).filter(|_| clipped.is_none()));
    list.extend(clipped);
    list.extend(dead::dead_inputs(problem, rows));
    list.extend(pauses::pauses(problem, rows));
    list
}
