//! Richer laws by the same name: a curve with more turns. They are tried where rows left out bear them out, and all is searched once more with them.
//!
//! A number more takes from other causes what it can follow. While a curve with five weights was offered from the start, 8 of 63 real recordings were foretold better and 5 worse, since a second or third cause was lost to it.
//!
//! Limits: numbers that their effect names as such; the model stood behind is asked, or the likeliest one that holds such an effect.

use crate::{
    data::{context::Number, error::DiagnoseError},
    pipeline::{
        judged::{self, Told},
        prepare::Prepared,
    },
    selection::{candidates::Tried, examine::Examined},
    validation::{
        cross_validation::{HeldOutFit, compared},
        held_numbers::fitted_from_nothing,
        tuning::{CLEARLY_WORSE, FELT},
    },
};
use std::sync::atomic::Ordering;

/// What is examined with richer laws, which `prepared` then holds open; `None` where rows left out do not bear them out, or what would be stood behind with them foretells those worse.
///
/// # Errors
/// Those of the simulator.
pub(crate) fn richer(
    prepared: &mut Prepared<'_>,
    examined: &Examined,
    told: &Told<'_>,
) -> Result<Option<Examined>, DiagnoseError> {
    let Some(held) = borne_out(prepared, examined, told) else { return Ok(None) };
    let before = stood_behind(prepared, examined, told);
    let simple = std::mem::replace(&mut prepared.context.held, held);
    let again = judged::examined_on_means(prepared, told)?;
    let worse = |[before, after]: [f64; 2]| after > CLEARLY_WORSE * before;
    if compared(&before, &stood_behind(prepared, &again, told)).is_none_or(|both| worse(both.rmse)) {
        prepared.context.held = simple;
        return Ok(None);
    }
    Ok(Some(again))
}

/// The numbers that are still held where the others are opened; `None` where rows left out are not foretold clearly better for it.
fn borne_out(prepared: &Prepared<'_>, examined: &Examined, told: &Told<'_>) -> Option<Vec<Number>> {
    let searched = prepared.searched();
    let search = &prepared.search(&searched, told.progress, told.stop);
    let numbers = |tried: &Tried| {
        let effects = tried.effects.iter().map(|e| search.library[*e]);
        let all = effects.flat_map(|effect| effect.may_be_more().iter().map(move |name| (effect.id(), *name)));
        all.filter(|(id, name)| search.context.holds(*id, name)).collect::<Vec<Number>>()
    };
    let selection = &examined.selection;
    let chosen = std::iter::once(&selection.models[examined.decision.model]);
    let tried = chosen.chain(&selection.models).find(|tried| !numbers(tried).is_empty())?;
    if told.stop.load(Ordering::Relaxed) {
        return None;
    }
    let opened = numbers(tried);
    let kept: Vec<Number> = search.context.held.iter().filter(|number| !opened.contains(number)).copied().collect();
    let context = search.context.holding(kept.clone());
    let wider = &search.within(&context);
    let richer = fitted_from_nothing(wider, tried, &opened)?;
    let both = compared(&prepared.foretold(search, tried), &prepared.foretold(wider, &richer))?;
    both.better_by(FELT).then_some(kept)
}

/// What the model that is stood behind foretells of rows left out.
fn stood_behind(prepared: &Prepared<'_>, examined: &Examined, told: &Told<'_>) -> HeldOutFit {
    let searched = prepared.searched();
    let search = &prepared.search(&searched, told.progress, told.stop);
    prepared.foretold(search, &examined.selection.models[examined.decision.model])
}
