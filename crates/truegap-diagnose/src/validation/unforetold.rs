//! Parts of a recording in which something happens once: when it does, other rows cannot foretell.
//!
//! A fit without such a part knows the reading before it and after it, and nothing of the moment between. Its error there is that of a moment that was made up, as large as the change, so that no change
//! would be borne out by rows left out. Such a part says nothing of any model that is compared with the one that changes in it. The first part and the last one are predicted all the same: on one side of a change
//! in them no other row tells what was there, so that nothing bears it out, and a law that errs at the ends would be spared there.
//!
//! A noise that lasts stands higher here and lower there, and bears out a level that changes once by about as much as it scatters: only a change that stands out of what is left beside it is hidden.
//!
//! Limits: where the fit of all rows has put the change.

use crate::{
    effects::{
        effect::{Effect, Once},
        memory::elapsed_s,
    },
    fit::model::Model,
    stats::rms,
    text::listed,
    validation::tuning::JUMPS_OUT,
};
use std::ops::Range;
use truegap_core::Inputs;

/// The changes of the model at `z` that stand out of what it leaves.
pub(crate) fn changes(model: &Model<'_>, z: &[f64]) -> Vec<Once> {
    let values = model.values(z);
    let happens = |(i, effect): (usize, &&dyn Effect)| effect.happens(&values[model.range_of(i)], model.context);
    let once: Vec<Once> = model.effects.iter().enumerate().filter_map(happens).collect();
    if once.is_empty() {
        return Vec::new();
    }
    let left = model.misfit(z).map_or(f64::INFINITY, |left| rms(left.iter().copied()));
    once.into_iter().filter(|once| once.change.abs() > JUMPS_OUT * left).collect()
}

/// The parts of these names that are not predicted, for a reader; empty where there are none.
pub(crate) fn not_predicted(names: &[&str]) -> String {
    if names.is_empty() {
        String::new()
    } else {
        format!("; {} not predicted, since something happens there once", listed(names, "and"))
    }
}

/// Whether a part of these rows hides one of the changes: it sees a moment, or all of what takes longer, and other parts tell what was before and what is after.
pub(crate) fn hides(part: &[Range<usize>], inputs: &Inputs, changes: &[Once]) -> bool {
    let is_inner = part.iter().all(|rows| rows.start > 0 && rows.end < inputs.len());
    is_inner && changes.iter().any(|change| part.iter().any(|rows| is_within(inputs, rows, change)))
}

/// Whether these rows see a moment: one of them is read while it goes on, or there are rows before and after it. Of a change that takes longer, whether they see it begin and end.
fn is_within(inputs: &Inputs, rows: &Range<usize>, change: &Once) -> bool {
    let mut when = rows.clone().map(|row| elapsed_s(inputs, row));
    let Some(first) = when.next() else { return false };
    let (last, Range { start, end }) = (when.next_back().unwrap_or(first), &change.when);
    if change.is_a_moment { first < *end && last > *start } else { first <= *start && last >= *end }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A row a second: a change between two parts is foretold from both sides, one inside a part is not, and one that takes longer is in each part that sees some of it. In the first part and in the last nothing bears
    /// a change out.
    #[test]
    fn a_part_hides_a_change_that_only_its_rows_see() {
        let inputs = Inputs { time_s: Some((0..40).map(f64::from).collect()), run: vec![1; 40], ..Inputs::default() };
        let parts = [0..10, 10..20, 20..30, 30..40];
        let hidden_of = |when: Range<f64>, is_a_moment: bool| {
            let once = Once { when, change: 1.0, is_a_moment };
            parts.clone().map(|rows| hides(&[rows], &inputs, std::slice::from_ref(&once)))
        };
        let hidden = |when: Range<f64>| hidden_of(when, true);
        assert_eq!(hidden(19.2..19.8), [false; 4]);
        assert_eq!(hidden(14.2..14.3), [false, true, false, false]);
        assert_eq!(hidden(18.5..19.5), [false, true, false, false]);
        assert_eq!(hidden(8.0..31.0), [false, true, true, false]);
        assert_eq!(hidden(19.0..20.0), [false; 4]);
        assert_eq!((hidden(4.0..5.0), hidden(34.0..35.0)), ([false; 4], [false; 4]));
        // of what takes longer no part is hidden that other rows see some of
        assert_eq!(hidden_of(12.0..17.0, false), [false, true, false, false]);
        assert_eq!((hidden_of(17.0..22.0, false), hidden_of(3.0..8.0, false)), ([false; 4], [false; 4]));
        assert_eq!(
            not_predicted(&["block 2", "block 3"]),
            "; block 2 and block 3 not predicted, since something happens there once"
        );
        assert_eq!(not_predicted(&[]), "");
    }
}
