//! The base model of a recording that names none.
//!
//! Limits: by roles of columns alone.

use super::{columns::Column, manifest::BaseSpec, note::Note};
use crate::inputs::Role;

/// The base model that the columns ask for; none, where a load was recorded: what it acted on cannot be seen in the columns.
pub(super) fn assumed_base(columns: &[Column], notes: &mut Vec<Note>) -> BaseSpec {
    let has = |role| columns.iter().any(|c| c.role == role);
    let (model, because) = if has(Role::Simulated) {
        ("external", "there is a column with a simulation")
    } else if has(Role::Gap) {
        ("gap-plate", "the gap was recorded")
    } else if has(Role::Pressure) || has(Role::Force) {
        return BaseSpec::default();
    } else {
        ("constant", "no load was recorded")
    };
    notes.push(Note::BaseAssumed { model: model.to_owned(), because: because.to_owned() });
    BaseSpec { model: model.to_owned(), ..BaseSpec::default() }
}
