//! Effects that mean something only beside another one: a changed coefficient needs the coefficient.
//!
//! Limits: effects say for themselves what they need.

use crate::{
    data::context::Number,
    effects::numbers::free_to_be_nothing,
    selection::{
        candidates::{Search, Tried},
        refitted::fitted_from_nothing,
    },
};

/// The model, or its fit by the simplest laws of its effects, where one of them needs what it changes; `None` where that does as well.
pub(crate) fn whole(search: &Search<'_>, model: Tried) -> Option<Tried> {
    if is_whole(search, &model) {
        return Some(model);
    }
    let effects = model.effects.iter().map(|e| search.library[*e]);
    let bends: Vec<Number> = effects.flat_map(|effect| free_to_be_nothing(effect, search.context)).collect();
    fitted_from_nothing(search, &model, &bends).filter(|simple| is_whole(search, simple))
}

/// Whether every effect that changes another one has that beside it, where the library holds it.
pub(crate) fn is_whole(search: &Search<'_>, model: &Tried) -> bool {
    let is = |e: &usize, id: &str| search.library[*e].id().0 == id;
    let held = |id: &str| !(0..search.library.len()).any(|e| is(&e, id)) || model.effects.iter().any(|e| is(e, id));
    let fitted = search.model(&model.effects);
    let values = fitted.values(&model.fit.z);
    let changed = |(index, e): (usize, &usize)| search.library[*e].beside(&values[fitted.range_of(index)], search.context);
    model.effects.iter().enumerate().filter_map(changed).all(held)
}
