//! Richer laws by the same name: a curve with more turns. They are tried where rows left out bear them out, and all is searched once more with them.
//!
//! A number more takes from other causes what it can follow. While a curve with five weights was offered from the start, 8 of 63 real recordings were foretold better and 5 worse, since a second or third cause was lost to it.
//!
//! Limits: numbers that their effect names as such; the model stood behind is asked, or the likeliest one that holds such an effect.

use crate::{
    data::{context::Number, error::DiagnoseError},
    effects::{effect::Effect, numbers::here},
    pipeline::{
        judged::{self, Told},
        prepare::Prepared,
    },
    selection::{
        candidates::{Search, Tried},
        examine::Examined,
        refitted::fitted_from_nothing,
        tuning::VISIBLE,
    },
    validation::{
        cross_validation::{HeldOutFit, compared},
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
    let selection = &examined.selection;
    let chosen = std::iter::once(&selection.models[examined.decision.model]);
    let tried = chosen.chain(&selection.models).find(|tried| !laws_opened(search, tried).is_empty())?;
    if told.stop.load(Ordering::Relaxed) {
        return None;
    }
    let simple = prepared.foretold(search, tried);
    let errors = |opened: &[Number], held: &[Number]| {
        let context = search.context.holding(held.to_vec());
        let wider = &search.within(&context);
        let richer = fitted_from_nothing(wider, tried, &[opened, held].concat()).filter(|richer| promises(richer, tried))?;
        let both = compared(&simple, &prepared.foretold(wider, &richer))?;
        both.better_by(FELT).then_some(both.rmse[1])
    };
    let laws = laws_opened(search, tried).into_iter();
    let ways = laws.flat_map(|opened| opened_ways(search, tried, &opened).into_iter().map(move |held| (opened.clone(), held)));
    let borne_out = ways.filter_map(|(opened, held)| Some((errors(&opened, &held)?, held)));
    borne_out.min_by(|a, b| a.0.total_cmp(&b.0)).map(|(_, held)| held)
}

/// Whether what another model has and a simple one has not is seen in the rows that are fitted. Rows left out are asked for what is seen alone: that takes as many fits as there are parts.
pub(crate) fn promises(other: &Tried, simple: &Tried) -> bool {
    simple.fit.objective() - other.fit.objective() > 0.5 * VISIBLE * VISIBLE
}

/// Numbers of the laws of the effects of a model that are still held: those of all richer laws together, and those of each other law.
fn laws_opened(search: &Search<'_>, tried: &Tried) -> Vec<Vec<Number>> {
    let effects = || tried.effects.iter().map(|e| search.library[*e]);
    let richer: Vec<Number> = effects().flat_map(|effect| still_held(search, effect, effect.may_be_more())).collect();
    let others = effects().flat_map(|effect| other_laws_of(search, effect));
    std::iter::once(richer).filter(|numbers| !numbers.is_empty()).chain(others).collect()
}

/// Those of these numbers of an effect that are still held.
fn still_held(search: &Search<'_>, effect: &dyn Effect, names: &[&'static str]) -> Vec<Number> {
    let mut numbers = here(effect, names, search.context);
    numbers.retain(|(id, name)| search.context.holds(*id, name));
    numbers
}

/// Numbers of the other laws of one effect, as far as they are still held, a list for each law.
pub(crate) fn other_laws_of(search: &Search<'_>, effect: &dyn Effect) -> Vec<Vec<Number>> {
    let laws = effect.other_laws().iter().map(|law| still_held(search, effect, law));
    laws.filter(|numbers| !numbers.is_empty()).collect()
}

/// What is held where these numbers of richer laws are opened: what was held besides, and that with the numbers of the same effects that may be nothing.
pub(crate) fn opened_ways(search: &Search<'_>, tried: &Tried, opened: &[Number]) -> Vec<Vec<Number>> {
    let kept: Vec<Number> = search.context.held.iter().filter(|number| !opened.contains(number)).copied().collect();
    let effects = tried.effects.iter().map(|e| search.library[*e]).filter(|e| opened.iter().any(|(id, _)| *id == e.id()));
    let bends = effects.flat_map(|effect| here(effect, effect.may_be_nothing(), search.context));
    let bends: Vec<Number> = bends.filter(|number| !kept.contains(number) && !opened.contains(number)).collect();
    let both = [kept.as_slice(), &bends].concat();
    if bends.is_empty() { vec![kept] } else { vec![kept, both] }
}

/// What the model that is stood behind foretells of rows left out.
fn stood_behind(prepared: &Prepared<'_>, examined: &Examined, told: &Told<'_>) -> HeldOutFit {
    let searched = prepared.searched();
    let search = &prepared.search(&searched, told.progress, told.stop);
    prepared.foretold(search, &examined.selection.models[examined.decision.model])
}
