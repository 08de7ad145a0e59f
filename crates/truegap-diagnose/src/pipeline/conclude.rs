//! From what was examined to the answer: recovery bank, hidden column, interference, and what takes the verdict back.
//!
//! Limits: the last stage of the pipeline; nothing is changed after it.

use crate::{
    adequacy::{interference::every_row::Interference, lack_of_fit::LackOfFitTests},
    answer::{Found, Known, Outcome, Reserved, outcome},
    data::error::DiagnoseError,
    discovery::{
        compose::{Composition, compose},
        discover::with_mechanisms,
    },
    explain::hidden_input::slow_input::SlowInput,
    fit::model::Model,
    pipeline::{
        alone::alone,
        options::Options,
        predicted::{Predicted, predicted},
        prepare::Prepared,
    },
    selection::{
        candidates::{Progress, Search},
        examine::{Examined, judge},
        posterior::Selection,
        verdict::{Decision, Verdict, interrupted},
        weak_effects::widened,
    },
    validation::{
        cross_validation::AllRows,
        recovery::{
            confusion::Bank,
            fill::{Whole, fill},
        },
        selected_again::selected_again,
    },
};
use std::{
    sync::atomic::{AtomicBool, Ordering},
    time::Instant,
};

/// What the caller tells a diagnosis, and is told by it.
pub(crate) struct Told<'a> {
    /// what the caller chose
    pub options: &'a Options,
    /// told what is tried
    pub progress: &'a (dyn Fn(Progress) + Sync),
    /// set by the caller to end early
    pub asked: &'a AtomicBool,
    /// the same for the search, which is not begun where nothing may be named
    pub stop: &'a AtomicBool,
}

/// The answer.
///
/// # Errors
/// Those of the simulator.
pub(crate) fn conclude(
    prepared: &Prepared<'_>,
    examined: Examined,
    composition: Option<Composition>,
    told: &Told<'_>,
    known: Known,
    started: Instant,
) -> Result<Outcome, DiagnoseError> {
    let searched = prepared.searched();
    let search = &prepared.search(&searched, told.progress, told.stop);
    let bank = bank(prepared, search, &examined, told.options)?;
    let (examined, composition) = match &bank {
        Some(bank) => {
            let sharpened = judge(search, &prepared.lack_of_fit, examined.selection.sharpened(bank.power));
            let composition = composed(prepared, &sharpened, told);
            (sharpened, composition)
        }
        None => (examined, composition),
    };
    let mechanisms = composition.as_ref().map_or(&[][..], |c| c.mechanisms.as_slice());
    let search = &with_mechanisms(search, mechanisms);
    let examined = match &composition {
        Some(composition) => counted(composition, examined, &prepared.lack_of_fit),
        None => examined,
    };
    let selection = &examined.selection;
    let hidden = told.options.hidden.first();
    let slow = hidden.and_then(|hidden| Some((SlowInput::of(search, selection)?, hidden)));
    let (interference, decision) = with_interference(prepared, search, &examined)?;
    let (decision, kept_back) = reserved(decision, selection, slow.as_ref().map(|(slow, _)| slow), told.options);
    let all = AllRows { problem: prepared.problem, first: prepared.averages.as_ref().map(|t| t.first.as_slice()) };
    let missing = decision.verdict != Verdict::Agrees;
    let alone = missing.then(|| alone(prepared, search, all, selection.base())).flatten();
    let Predicted { unseen, decision, after, vetoed, left_out } =
        predicted(prepared, search, all, selection, decision, alone.as_ref());
    let base = alone.as_ref().map_or(selection.base(), |alone| &alone.tried);
    let mut told_of = vec![base];
    for tried in [&selection.models[decision.model]].into_iter().chain(composition.as_ref().map(|c| &c.tried)) {
        if told_of.iter().all(|known| known.effects != tried.effects) {
            told_of.push(tried);
        }
    }
    let widened = told_of.into_iter().map(|tried| (tried, widened(search, selection, tried))).collect();
    let again = told.options.select_in_folds && told.options.withheld.is_none();
    let again = again.then(|| {
        selected_again(&prepared.search(&searched, told.progress, told.stop), &prepared.searched_noise, &prepared.directions, all)
    });
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
        slow: slow.as_ref().map(|(slow, hidden)| (slow, *hidden)),
        mechanisms,
        widened,
        selected_again: again,
        interrupted: told.asked.load(Ordering::Relaxed),
    };
    outcome(&found, known, prepared.not_testable.clone(), started)
}

/// Mechanisms from outside the library, where anything may be named at all.
pub(crate) fn composed(prepared: &Prepared<'_>, examined: &Examined, told: &Told<'_>) -> Option<Composition> {
    let Told { options, progress, stop, .. } = told;
    let free = options.compose && options.withheld.is_none() && options.restricted.is_none();
    let searched = prepared.searched();
    let search = &prepared.search(&searched, progress, stop);
    free.then(|| compose(search, &examined.selection, &examined.decision, &examined.after, &prepared.lack_of_fit)).flatten()
}

/// What was examined, with the mechanisms among its models and in its decision.
fn counted(composition: &Composition, examined: Examined, lack_of_fit: &LackOfFitTests) -> Examined {
    let key = examined.selection.models[examined.decision.model].key();
    let selection = composition.counted_in(examined.selection);
    // the order of the models has changed
    let stood_behind = selection.models.iter().position(|m| m.key() == key);
    let decision = Decision { model: stood_behind.unwrap_or(selection.base), ..examined.decision };
    let (decision, after) = composition.decide(&selection, decision, lack_of_fit);
    Examined { selection, decision, after: after.unwrap_or(examined.after), ..examined }
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

/// Bursts and a tone in what the model stood behind leaves of every row, and the decision with them counted.
fn with_interference(
    prepared: &Prepared<'_>,
    search: &Search<'_>,
    examined: &Examined,
) -> Result<(Interference, Decision), DiagnoseError> {
    let Examined { selection, decision, .. } = examined;
    let stood_behind = &selection.models[decision.model];
    let effects = stood_behind.effects.iter().map(|e| search.library[*e]).collect();
    let model = Model::new(prepared.problem, search.context, effects);
    let interference = Interference::in_what_is_left(&model, &stood_behind.fit.z, &prepared.noise, prepared.lack_of_fit.slack())?;
    let explained = 2.0 * (selection.base().fit.objective() - stood_behind.fit.objective());
    let decision = match interference.is_anything() {
        true => decision.clone().with_interference(selection.base, explained, interference.excess()),
        false => decision.clone(),
    };
    Ok((interference, decision))
}

/// The decision, taken back where the recording may not be trusted or an input is missing that was hidden on purpose; with the reason.
fn reserved(
    decision: Decision,
    selection: &Selection,
    slow: Option<&SlowInput>,
    options: &Options,
) -> (Decision, Option<Reserved>) {
    let missing = slow.filter(|slow| slow.is_missing());
    let reserved = |says: String| Reserved { says, withheld: options.withheld.is_some(), input_missing: missing.is_some() };
    if let Some(why) = &options.withheld {
        return (interrupted(selection), Some(reserved(why.clone())));
    }
    match missing {
        Some(slow) => (Decision { verdict: Verdict::Unexplained, ..interrupted(selection) }, Some(reserved(slow.says()))),
        None => (decision, None),
    }
}
