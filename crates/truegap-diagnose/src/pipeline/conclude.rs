//! From what was examined to the answer: recovery bank, what is stood behind, deviations with what is not named counted in.
//!
//! Limits: the last stage of the pipeline; nothing is changed after it.

use crate::{
    answer::{Found, Known, Outcome, Rival, outcome},
    data::error::DiagnoseError,
    discovery::{compose::Composition, discover::with_mechanisms},
    pipeline::{
        alone::by_squares,
        beside_a_mean::beside_a_mean,
        by_a_mean::{Mean, by_a_mean},
        by_name::by_name,
        by_rows_left_out::{Chosen, by_rows_left_out},
        carried::with_carried,
        described::described,
        judged::{Judged, Told, composed, judged, judged_again},
        lasting_noise::beside_lasting_noise,
        laws_not_told_apart::laws_not_told_apart,
        laws_on_limits::laws_on_limits,
        noise_that_lasts::noise_alone,
        options::Options,
        permuted_searches::permuted_searches,
        predicted::Predicted,
        prepare::Prepared,
        simple_laws::told_simply,
        wanders::beside_a_walk,
        words_beside::words_beside,
    },
    selection::{
        candidates::{Search, Tried},
        examine::Examined,
        rival_sets::in_place_of,
        weak_effects::widened,
    },
    validation::{
        moved_numbers::{by_parts, by_parts_alone},
        recovery::{
            confusion::Bank,
            fill::{Whole, fill},
        },
        selected_again::selected_again,
    },
};
use std::{sync::atomic::Ordering, time::Instant};

/// The answer.
///
/// # Errors
/// Those of the simulator.
pub(crate) fn conclude(
    mut prepared: Prepared<'_>,
    examined: Examined,
    composition: Option<Composition>,
    told: &Told<'_>,
    known: Known,
    started: Instant,
) -> Result<Outcome, DiagnoseError> {
    let (bank, examined, composition) = sharpened(&prepared, examined, composition, told)?;
    let first = judged(&prepared, told, examined, composition)?;
    // where nothing is named, a mean goes before what rows left out choose: it needs no cause
    let by_a_mean = |judged: &Judged| by_a_mean(&prepared, told, judged);
    let mean = if first.names_something() { Mean::Nothing } else { by_a_mean(&first) };
    let judged = match mean {
        Mean::Instead(mean) => first.taken_back(mean),
        Mean::Nothing => in_the_end(&prepared, told, first, true),
        Mean::Better => in_the_end(&prepared, told, first, false),
    };
    let judged = words_beside(&prepared, told, judged);
    let mean = if judged.names_something() { by_a_mean(&judged) } else { Mean::Nothing };
    let judged = match mean {
        Mean::Instead(mean) => judged.taken_back(mean),
        Mean::Nothing | Mean::Better => judged,
    };
    let (judged, open) = beside_a_walk(&prepared, told, judged)?;
    let judged = beside_lasting_noise(&prepared, told, judged)?;
    let beside_walk = judged.stood_behind().key();
    let judged = described(&prepared, told, judged)?;
    let Judged { examined, composition, slow, interference, kept_back, by_base, predicted, held, smoothed } = judged;
    prepared.context.held = held;
    let prepared = &prepared;
    let searched = prepared.searched();
    let search = &prepared.search(&searched, told.progress, told.stop);
    let Predicted { unseen, decision, after, vetoed, mut left_out, .. } = predicted;
    let mechanisms = composition.as_ref().map_or(&[][..], |c| c.mechanisms.as_slice());
    let in_other_words = composition.as_ref().filter(|c| c.in_other_words);
    // other words for what is explained are no effect more that may act beside it
    let of_names = search;
    let search = &with_mechanisms(of_names, mechanisms);
    let (selection, all) = (&examined.selection, prepared.all_rows());
    let by_odds = composition.as_ref().is_none_or(|composition| composition.by_odds);
    let decision = with_carried(prepared, search, selection, (decision, unseen.stood_behind()), &by_base, by_odds);
    let chosen = &selection.models[decision.model];
    let (decision, smooths) = beside_a_mean(prepared, search, chosen, (decision, unseen.stood_behind()), &by_base);
    left_out.extend(smooths);
    // described in words since, it is another answer
    let decision = if selection.models[decision.model].key() == beside_walk { decision.with_open(&open) } else { decision };
    let (decision, says) = laws_on_limits(of_names, &selection.models[decision.model], decision);
    left_out.extend(says);
    let base = by_base.alone.as_ref().map_or(selection.base(), |alone| &alone.tried);
    let mut told_of = vec![base];
    for tried in [&selection.models[decision.model]].into_iter().chain(composition.as_ref().map(|c| &c.tried)) {
        if told_of.iter().all(|known| known.effects != tried.effects) {
            told_of.push(tried);
        }
    }
    let chosen = &selection.models[decision.model];
    // of models with plates the numbers are those of the fit that weighed them
    let squares = unseen.stood_behind().least_squares && !chosen.effects.is_empty() && !search.context.has_plates();
    let nearest = |tried: &Tried| squares.then(|| by_squares(prepared, search, all, tried)).flatten();
    let (by_squares, sd_by_squares) = nearest(chosen).unzip();
    let moved = |tried: &Tried, i: usize| match &by_squares {
        Some(squares) if squares.effects == tried.effects => squares.fit.z[i] - tried.fit.z[i],
        _ => 0.0,
    };
    let beside_names = |tried: &Tried| in_other_words.is_some_and(|c| c.tried.effects != tried.effects);
    let searched_for = |tried: &Tried| if beside_names(tried) { of_names } else { search };
    // a fit and its like without one part have to be calibrated in one way
    let by_parts_of = |tried: &Tried| {
        let Tried { fit, effects } = tried;
        if effects.is_empty() {
            return by_parts((&fit.z, &fit.sd), &unseen.without().refits);
        }
        if *effects != chosen.effects {
            return fit.sd.clone();
        }
        let predicted = unseen.stood_behind();
        match (&by_squares, &sd_by_squares) {
            (Some(squares), Some(sd)) => {
                let told = by_parts((&squares.fit.z, sd), &predicted.refits);
                told.into_iter().zip(&fit.sd).map(|(told, sd)| told.max(*sd)).collect()
            }
            _ if predicted.least_squares => by_parts_alone(&fit.sd, &predicted.refits),
            _ => by_parts((&fit.z, &fit.sd), &predicted.refits),
        }
    };
    let told_sd = |tried: &Tried| {
        let sd = widened(searched_for(tried), selection, tried, &by_parts_of(tried));
        sd.into_iter().enumerate().map(|(i, sd)| sd.hypot(moved(tried, i))).collect::<Vec<_>>()
    };
    let widened: Vec<(&Tried, Vec<f64>)> = told_of.into_iter().map(|tried| (tried, told_sd(tried))).collect();
    let sd = widened.iter().find(|(tried, _)| tried.effects == chosen.effects).map_or(&chosen.fit.sd, |(_, sd)| sd);
    let decision = laws_not_told_apart(search, by_squares.as_ref().unwrap_or(chosen), sd, decision);
    let rival = |(instead_of, effect): (usize, usize)| {
        let tried = in_place_of(selection, decision.model, instead_of, effect)?;
        Some(Rival { instead_of, effect, tried: nearest(tried).map_or_else(|| tried.clone(), |(tried, _)| tried) })
    };
    let rivals: Vec<Rival> = decision.rivals().filter_map(rival).collect();
    let again = told.options.select_in_folds && told.options.withheld.is_none();
    let again = again.then(|| {
        selected_again(&prepared.search(&searched, told.progress, told.stop), &prepared.searched_noise, &prepared.directions, all)
    });
    let permuted = match told.options.permuted_searches {
        wanted if wanted > 0 && told.options.withheld.is_none() => permuted_searches(prepared, selection, told, wanted)?,
        _ => None,
    };
    let found = Found {
        search,
        noise: &prepared.noise,
        searched_noise: &prepared.searched_noise,
        all,
        selection,
        decision: &decision,
        bank: bank.as_ref(),
        before: examined.before,
        after: after.unwrap_or(examined.after),
        base_alone: base,
        left_out,
        interference,
        unseen,
        lack_of_fit: &prepared.lack_of_fit,
        directions: &prepared.directions,
        reserved: kept_back.or(vetoed),
        slow: slow.as_ref().zip(told.options.hidden.first()),
        smoothed,
        mechanisms,
        by_squares,
        rivals,
        in_other_words: in_other_words.is_some(),
        log_odds_of_mechanisms: composition.as_ref().map_or(f64::NEG_INFINITY, |c| c.log_odds),
        widened,
        selected_again: again,
        permuted_searches: permuted,
        interrupted: told.asked.load(Ordering::Relaxed),
    };
    outcome(&found, known, prepared.not_testable.clone(), started)
}

/// What is stood behind in the end: by the name that a mechanism has in the library, or by what rows left out choose, and with simple laws where those foretell as well. Where nothing foretells
/// them, nor a mean (`no_mean`), it may be noise.
fn in_the_end(prepared: &Prepared<'_>, told: &Told<'_>, judged: Judged, no_mean: bool) -> Judged {
    let judged = match by_name(prepared, told, &judged) {
        Some(name) => judged.told_by(name),
        None => match by_rows_left_out(prepared, told, &judged) {
            // its laws are the simple ones already
            Chosen::Better(better) => return judged.told_by_rows_left_out(*better),
            Chosen::Nothing if no_mean => match noise_alone(prepared, told, &judged) {
                Some(interference) => return judged.told_as_noise(prepared, interference),
                None => judged,
            },
            Chosen::Nothing | Chosen::AsItIs => judged,
        },
    };
    match told_simply(prepared, told, &judged) {
        Some((simple, decision)) => judged.with_simple_laws(prepared, simple, decision),
        None => judged,
    }
}

/// The recovery bank, and what was examined and composed with the probabilities that it bears out.
fn sharpened(
    prepared: &Prepared<'_>,
    examined: Examined,
    composition: Option<Composition>,
    told: &Told<'_>,
) -> Result<(Option<Bank>, Examined, Option<Composition>), DiagnoseError> {
    let searched = prepared.searched();
    let search = &prepared.search(&searched, told.progress, told.stop);
    let Some(bank) = bank(prepared, search, &examined, told.options)? else { return Ok((None, examined, composition)) };
    let sharpened = judged_again(prepared, search, examined.selection.sharpened(bank.power))?;
    let composition = composed(prepared, &sharpened, told);
    Ok((Some(bank), sharpened, composition))
}

/// The recovery bank, where it is wanted; where nothing may be named, there is nothing to be right or wrong about.
fn bank(
    prepared: &Prepared<'_>,
    search: &Search<'_>,
    examined: &Examined,
    options: &Options,
) -> Result<Option<Bank>, DiagnoseError> {
    let Some(wanted) = options.bank.as_ref().filter(|_| options.withheld.is_none()) else { return Ok(None) };
    let whole = Whole { problem: prepared.problem, noise: &prepared.noise };
    Ok(Some(fill(search, whole, examined, wanted)?))
}
