//! Parts of a recording in which something happens once: when it does, other rows cannot foretell.
//!
//! A fit without such a part knows the reading before it and after it, and nothing of the moment between. Its error there is that of a moment that was made up, as large as the change, so that no change
//! would be borne out by rows left out. Such a part says nothing of any model that is compared with the one that changes in it. The first part and the last one are predicted all the same: on one side of a change
//! in them no other row tells what was there, so that nothing bears it out, and a law that errs at the ends would be spared there.
//!
//! Limits: where the fit of all rows has put the change.

use crate::{effects::memory::elapsed_s, fit::model::Model, text::listed, validation::cross_validation::Part};
use std::ops::Range;
use truegap_core::Inputs;

/// Which of the parts hold a change of the model at `z`; `inputs` are those of the rows that the parts count.
pub(crate) fn unforetold(model: &Model<'_>, z: &[f64], inputs: &Inputs, parts: &[Part]) -> Vec<bool> {
    let values = model.values(z);
    let changes = model.effects.iter().enumerate().filter_map(|(i, effect)| effect.happens(&values[model.range_of(i)]));
    let changes: Vec<Range<f64>> = changes.collect();
    parts.iter().map(|part| changes.iter().any(|change| hides(part, inputs, change))).collect()
}

/// Those parts for a reader; empty where there are none.
pub(crate) fn without_saying(parts: &[Part], unforetold: &[bool]) -> String {
    let held: Vec<&str> = parts.iter().zip(unforetold).filter(|(_, held)| **held).map(|(part, _)| part.name.as_str()).collect();
    if held.is_empty() {
        String::new()
    } else {
        format!("; {} not predicted, since something happens there once", listed(&held, "and"))
    }
}

/// Whether a part hides a change: it sees it, and other parts tell what was before and what is after.
fn hides(part: &Part, inputs: &Inputs, change: &Range<f64>) -> bool {
    let is_inner = part.rows.iter().all(|rows| rows.start > 0 && rows.end < inputs.len());
    is_inner && part.rows.iter().any(|rows| is_within(inputs, rows, change))
}

/// Whether these rows see the change: one of them is read while it goes on, or there are rows before and after it.
fn is_within(inputs: &Inputs, rows: &Range<usize>, change: &Range<f64>) -> bool {
    let mut when = rows.clone().map(|row| elapsed_s(inputs, row));
    let Some(first) = when.next() else { return false };
    let last = when.next_back().unwrap_or(first);
    first < change.end && last > change.start
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A row a second: a change between two parts is foretold from both sides, one inside a part is not, and one that takes longer is in each part that sees some of it. In the first part and in the last nothing bears
    /// a change out.
    #[test]
    fn a_part_hides_a_change_that_only_its_rows_see() {
        let inputs = Inputs { time_s: Some((0..40).map(f64::from).collect()), run: vec![1; 40], ..Inputs::default() };
        let part = |rows: Range<usize>| Part { name: format!("from {}", rows.start), rows: vec![rows] };
        let parts = [part(0..10), part(10..20), part(20..30), part(30..40)];
        let hidden = |change: Range<f64>| parts.each_ref().map(|part| hides(part, &inputs, &change));
        assert_eq!(hidden(19.2..19.8), [false; 4]);
        assert_eq!(hidden(14.2..14.3), [false, true, false, false]);
        assert_eq!(hidden(18.5..19.5), [false, true, false, false]);
        assert_eq!(hidden(8.0..31.0), [false, true, true, false]);
        assert_eq!(hidden(19.0..20.0), [false; 4]);
        assert_eq!((hidden(4.0..5.0), hidden(34.0..35.0)), ([false; 4], [false; 4]));
        assert_eq!(
            without_saying(&parts, &hidden(18.0..21.0)),
            "; from 10 and from 20 not predicted, since something happens there once"
        );
        assert_eq!(without_saying(&parts, &[false; 4]), "");
    }
}
