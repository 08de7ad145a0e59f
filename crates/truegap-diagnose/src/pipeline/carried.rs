//! Which effects of the model stood behind are causes, and which it only carries: told with their numbers, not claimed by name.
//!
//! A right cause whose equation is slightly off leaves a rest, and another effect can follow a part of that. It is small beside what the cause explains, and tests still see the other part.
//! So unless the whole model leaves nothing but a noise that was measured, the causes are the fewest effects that remove most of what it removes on rows left out. The model keeps the others, for
//! they predict. Where the noise was measured and tests see nothing beside effects of the library, their equations hold, and each effect that was named is a cause. That nothing is left beside a
//! mechanism composed of words says nothing of equations: it was composed to follow whatever there is.
//!
//! Beside mechanisms that stand by what they foretell, and not by their odds, the causes among the names are those that they have without them, and the mechanisms are carried where they are the smaller part: they were found among thousands,
//! and an equation with a name is worth more than a composed one.
//!
//! Small beside the largest cause may still be far out of the noise: a lag that takes what a fast clock leaves from fifty times the noise down to it, or a drift beside a supply that sags. So where tests see
//! nothing in what equations of the library leave together, but something without a part, that part is a cause as well, doubted or not: where rows left out are predicted twice as badly without it, or worse in most
//! parts, and nothing may stand both in its place and in that of another cause.
//!
//! Causes that have to run to a limit of a law to do without another part stand for that part: they are too few. That is not asked where the other part is the same memory of the same driver (a friction, and a loop
//! that saturates beside it): one of two laws of one cause is slightly off.
//!
//! Where tests see nothing beside what is carried, and the causes leave little more than all together, nothing is wrong with their form that one would see: that is told as an explanation.
//!
//! Effects are left out together as well as one by one: a late clock and a lag of the reading may undo one another, and then each looks needed beside the other.
//!
//! Nor is a name after the first claimed that would more often be wrong than right, as names in other people's recordings were (`answer/stated.rs`): of ten clocks that run fast one was right, of ten changes of a gain none. A name after the first that would be right three times of four is claimed where rows left out bear it out beside all the others, however large what the first leaves is.
//!
//! Not for a base model with plates: the equations of its effects are derived from sizes, and what tests see beside them is there. Other equations only describe.
//!
//! Limits: mechanisms that were composed together are one part; a number for whatever happens foretells nothing, and nothing is carried beside it.

use crate::{
    answer::stated::{Place, stated},
    effects::composed::words::Kinetics,
    pipeline::{
        calibrated::{ByBase, predictions},
        prepare::Prepared,
    },
    selection::{
        candidates::{Search, Tried},
        posterior::Selection,
        verdict::Decision,
    },
    validation::{
        cross_validation::{HeldOutFit, compared},
        main_causes::{Asked, Whole, fewest, names_first, removed, with_sure, without_doubted},
        tuning::{CLAIMED_FROM, MAIN_SHARE, SURE_FROM},
    },
};

/// The decision with the effects that are only carried; `named` are the predictions of rows left out by its model. Mechanisms stand `by_odds` against the library, or by what they foretell beside it.
pub(crate) fn with_carried(
    prepared: &Prepared<'_>,
    search: &Search<'_>,
    selection: &Selection,
    (decision, named): (Decision, &HeldOutFit),
    by_base: &ByBase,
    by_odds: bool,
) -> Decision {
    let chosen = &selection.models[decision.model];
    let parts = parts(&chosen.effects, prepared.testable.len());
    let foretells = chosen.effects.iter().all(|e| !search.library[*e].free_form());
    let derived = search.context.has_plates();
    let after = prepared.lack_of_fit.adequacy(&chosen.fit);
    let equations = chosen.effects.iter().all(|e| *e < prepared.testable.len());
    let holds = prepared.noise_is_known() && !after.fires() && equations;
    if derived || holds || parts.len() < 2 || !foretells {
        return decision;
    }
    let model = |kept: &[usize]| {
        let effects: Vec<usize> = kept.iter().flat_map(|part| parts[*part].clone()).collect();
        selection.with(&effects).cloned().or_else(|| search.part_of(chosen, &effects))
    };
    let squares = |kept: &[usize]| removed(&by_base.unseen, &predictions(prepared, search, by_base, &model(kept)?));
    let hold = |kept: &[usize]| model(kept).is_some_and(|tried| !prepared.lack_of_fit.adequacy(&tried.fit).fires());
    let Some(whole) = removed(&by_base.unseen, named) else { return decision };
    let before = compared(&by_base.unseen, named).map_or(whole, |both| both.rmse[0].powi(2));
    let whole = Whole { before, whole, holds: equations && !after.fires() };
    let sets: Vec<Vec<usize>> = parts.iter().map(|part| decision.sets_of(&chosen.effects, part).concat()).collect();
    let borne_out = |kept: &[usize]| {
        let others = || Some(predictions(prepared, search, by_base, &model(kept)?));
        let missed = || compared(&others()?, named).map(|both| both.mostly_better());
        has_a_place_of_its_own(&sets, kept) && missed().unwrap_or(false)
    };
    let of_library: Vec<Vec<usize>> = parts.iter().filter(|part| part[0] < prepared.testable.len()).cloned().collect();
    let strained = |kept: &[usize]| {
        let beside = |tried: &Tried, part: usize| laws_on_limits(search, tried, &parts[part]);
        let runs_there = |tried: &Tried| kept.iter().any(|part| beside(tried, *part) && !beside(chosen, *part));
        !rest_is_alike(&of_library, kept, |a, b| is_one_memory(search, a, b))
            && model(kept).is_some_and(|tried| runs_there(&tried))
    };
    let needs_no_more = |kept: &[usize], squares: f64| whole.needs_no_more(squares, || hold(kept), || borne_out(kept));
    let enough = |kept: &[usize], squares: f64| squares >= MAIN_SHARE * whole.whole && needs_no_more(kept, squares);
    let asked = Asked { removed: squares, strained };
    let composed = !by_odds && parts.last().is_some_and(|part| part.iter().all(|e| *e >= prepared.testable.len()));
    let (causes, share) = match composed.then(|| names_first(parts.len() - 1, whole.whole, &asked)).flatten() {
        Some(named) => named,
        None => fewest(parts.len(), whole.whole, enough, &asked),
    };
    let doubted = |part: usize| is_doubted(search, selection, &decision, &parts[part]);
    let sure = |part: usize| is_sure(search, selection, &parts[part]);
    // that most parts are predicted better is too little for a name that is more often wrong than right
    let needless = |kept: &[usize], share: f64| whole.needs_no_more(share * whole.whole, || hold(kept), || false);
    let share_of = |kept: &[usize]| (asked.removed)(kept).map(|kept| kept / whole.whole);
    let (causes, share) = without_doubted((causes, share), needless, share_of, doubted);
    let (causes, share) = with_sure((causes, share), parts.len(), share_of, |part, others| sure(part) && borne_out(others));
    let carried = (0..parts.len()).filter(|part| !causes.contains(part)).flat_map(|part| parts[part].clone()).collect();
    let near = whole.holds && whole.is_near(share * whole.whole);
    decision.carrying((carried, share, near), &chosen.effects, &after)
}

/// Whether two effects are in words the same memory of the same driver at the same place: what one of them leaves the other follows, be its equation slightly off.
fn is_one_memory(search: &Search<'_>, a: usize, b: usize) -> bool {
    let words = |effect: usize| search.library.get(effect).and_then(|effect| effect.in_words(search.context));
    words(a).is_some_and(|words| words.kinetics != Kinetics::Static) && words(a) == words(b)
}

/// Whether all of these parts beside those that are `kept` are the same physics as a kept one (`alike`).
fn rest_is_alike(parts: &[Vec<usize>], kept: &[usize], alike: impl Fn(usize, usize) -> bool) -> bool {
    let of_kept = |effect: &usize| kept.iter().filter_map(|part| parts.get(*part)).flatten().any(|other| alike(*effect, *other));
    let mut rest = (0..parts.len()).filter(|part| !kept.contains(part)).flat_map(|part| &parts[part]).peekable();
    rest.peek().is_some() && rest.all(of_kept)
}

/// Whether a part beside those that are `kept` has a place of its own: nothing that may stand there may stand in the place of a kept one as well, in which case one cause may be both.
fn has_a_place_of_its_own(sets: &[Vec<usize>], kept: &[usize]) -> bool {
    let taken = |effect: &usize| kept.iter().any(|part| sets[*part].contains(effect));
    (0..sets.len()).filter(|part| !kept.contains(part)).any(|part| !sets[part].iter().any(taken))
}

/// Whether a law of these effects has run to a limit of its numbers in a model: there it stands for something else. What only describes a curve has no law.
fn laws_on_limits(search: &Search<'_>, tried: &Tried, effects: &[usize]) -> bool {
    let is_law = |effect: usize| !search.library[effect].describes();
    (0..tried.effects.len()).any(|index| {
        let effect = tried.effects[index];
        effects.contains(&effect) && is_law(effect) && !search.on_limits(tried, index).is_empty()
    })
}

/// Whether the name of a part after the first would more often be wrong than right, and that of all that may stand in its place.
fn is_doubted(search: &Search<'_>, selection: &Selection, decision: &Decision, part: &[usize]) -> bool {
    let [_] = part else { return false };
    let rivals = decision.sets_of(&selection.models[decision.model].effects, part);
    part.iter().chain(rivals.iter().flatten()).all(|effect| after_the_first(search, selection, *effect) < CLAIMED_FROM)
}

/// Whether the name of a part after the first would be right three times of four.
fn is_sure(search: &Search<'_>, selection: &Selection, part: &[usize]) -> bool {
    matches!(part, [effect] if *effect < selection.effect_probability.len() && after_the_first(search, selection, *effect) >= SURE_FROM)
}

/// The probability that is stated of a name after the first.
fn after_the_first(search: &Search<'_>, selection: &Selection, effect: usize) -> f64 {
    stated(search.library[effect].id().0, selection.effect_probability[effect], Place::Later, false)
}

/// Effects one by one, and all mechanisms from behind the `library` together.
fn parts(effects: &[usize], library: usize) -> Vec<Vec<usize>> {
    let (own, composed): (Vec<usize>, Vec<usize>) = effects.iter().partition(|e| **e < library);
    own.into_iter().map(|e| vec![e]).chain(Some(composed).filter(|composed| !composed.is_empty())).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn two_laws_of_one_memory_are_one_cause() {
        let (friction, lag, loops) = (0, 1, 2);
        let alike = |a: usize, b: usize| a.min(b) == friction && a.max(b) == loops;
        let parts = [vec![friction], vec![loops], vec![lag]];
        assert!(rest_is_alike(&parts[..2], &[0], alike) && rest_is_alike(&parts, &[0, 2], alike));
        assert!(!rest_is_alike(&parts, &[0], alike) && !rest_is_alike(&parts[..2], &[0, 1], alike));
    }

    /// A curve and a lag in the place of one wrong scale: the scale may stand in the place of either.
    #[test]
    fn what_one_cause_may_be_together_is_no_second_cause() {
        let (clock, curve, lag, scale) = (0, 1, 2, 3);
        let sets = [vec![clock], vec![curve, scale], vec![lag, scale]];
        assert!(!has_a_place_of_its_own(&sets, &[0, 1]));
        assert!(has_a_place_of_its_own(&sets, &[1]) && has_a_place_of_its_own(&sets, &[0]));
        assert!(!has_a_place_of_its_own(&sets, &[0, 1, 2]));
    }
}
