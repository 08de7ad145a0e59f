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
    selection::{
        candidates::{Search, Tried},
        examine::Examined,
    },
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

/// The numbers that are held where richer laws are opened, with what bends the simple law or without: of two laws that bend, one may do; `None` where rows left out are not predicted clearly better for it.
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
    let simple = prepared.foretold(search, tried);
    let errors = |held: &[Number]| {
        let context = search.context.holding(held.to_vec());
        let wider = &search.within(&context);
        let richer = fitted_from_nothing(wider, tried, &[&opened, held].concat())?;
        let both = compared(&simple, &prepared.foretold(wider, &richer))?;
        both.better_by(FELT).then_some(both.rmse[1])
    };
    let borne_out = opened_ways(search, tried, &opened).into_iter().filter_map(|held| Some((errors(&held)?, held)));
    borne_out.min_by(|a, b| a.0.total_cmp(&b.0)).map(|(_, held)| held)
}

/// What is held where these numbers of richer laws are opened: what was held besides, and that with the numbers of the same effects that may be nothing.
pub(crate) fn opened_ways(search: &Search<'_>, tried: &Tried, opened: &[Number]) -> Vec<Vec<Number>> {
    let kept: Vec<Number> = search.context.held.iter().filter(|number| !opened.contains(number)).copied().collect();
    let effects = tried.effects.iter().map(|e| search.library[*e]).filter(|e| opened.iter().any(|(id, _)| *id == e.id()));
    let bends = effects.flat_map(|effect| effect.may_be_nothing().iter().map(move |name| (effect.id(), *name)));
    let bends: Vec<Number> = bends.filter(|number| !kept.contains(number)).collect();
    let both = [kept.as_slice(), &bends].concat();
    if bends.is_empty() { vec![kept] } else { vec![kept, both] }
}

/// What the model that is stood behind foretells of rows left out.
fn stood_behind(prepared: &Prepared<'_>, examined: &Examined, told: &Told<'_>) -> HeldOutFit {
    let searched = prepared.searched();
    let search = &prepared.search(&searched, told.progress, told.stop);
    prepared.foretold(search, &examined.selection.models[examined.decision.model])
}
