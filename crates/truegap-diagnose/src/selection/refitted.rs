//! Models fitted again where some of their numbers are at nothing, to begin with or for good.
//!
//! Limits: from the fit that there is; no other start.

use crate::{
    data::context::Number,
    fit::{levenberg_marquardt::FitOptions, maximum_a_posteriori::fit},
    selection::candidates::{Search, Tried},
};

/// A model fitted again where some of its numbers are held.
pub(crate) fn refitted(search: &Search<'_>, tried: &Tried) -> Option<Tried> {
    fitted_from_nothing(search, tried, &search.context.held)
}

/// A model fitted again with these numbers of its effects at nothing to begin with, whether they are held there or have been.
pub(crate) fn fitted_from_nothing(search: &Search<'_>, tried: &Tried, numbers: &[Number]) -> Option<Tried> {
    let model = search.model(&tried.effects);
    let mut start = tried.fit.z.clone();
    for (index, effect) in model.effects.iter().enumerate() {
        let is_one =
            |place: &usize| numbers.iter().any(|(id, name)| *id == effect.id() && *name == model.parameters[*place].name);
        model.range_of(index).filter(is_one).for_each(|place| start[place] = 0.0);
    }
    let fit = fit(&model, search.whitener, &start, &FitOptions::default()).ok()?;
    Some(Tried { effects: tried.effects.clone(), fit })
}
