//! Rows of several recordings that stand behind one another.
//!
//! Limits: counts only; runs and clocks are carried on by [`super::request::together`].

use std::ops::Range;
use truegap_core::Recording;

/// The rows of each recording among those of all.
pub(super) fn rows_of_each(parts: &[Recording]) -> Vec<Range<usize>> {
    let mut first = 0;
    let rows = |part: &Recording| {
        let rows = first..first + part.len();
        first = rows.end;
        rows
    };
    parts.iter().map(rows).collect()
}
