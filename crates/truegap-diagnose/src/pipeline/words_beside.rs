//! Mechanisms composed of words beside what the library names, where rows left out are predicted clearly better with them.
//!
//! Evidence weighs words against names by a noise that nobody measured and by equations that only describe. So what stands beside a name is asked as a further effect of the library is
//! ([`crate::pipeline::by_rows_left_out`]): it has to predict rows left out better by a tenth, in most parts. It is looked for beside the whole answer and beside its clearest effect alone: a second effect
//! may have followed what a mechanism outside the library does.
//!
//! Limits: not for a base model with plates, nor where the noise was measured; two mechanisms at most; only where tests still see something beside the answer.

use crate::{
    discovery::{
        compose::{Composition, compose_beside},
        discover::with_mechanisms,
        same_words::says_one_of,
    },
    pipeline::{
        calibrated::predictions,
        judged::{Judged, Told, may_compose},
        prepare::Prepared,
        richer_laws::promises,
    },
    selection::{
        candidates::{Search, Tried},
        verdict::Verdict,
    },
    validation::{
        cross_validation::{HeldOutFit, compared},
        main_causes::removed,
        tuning::{CLEARLY_WORSE, FELT, MAIN_SHARE},
    },
};
use std::sync::atomic::Ordering;

/// Mechanisms beside names of the library, and what they foretell together.
struct Beside {
    composition: Composition,
    unseen: HeldOutFit,
}

/// The same answer with mechanisms beside its names, where rows left out bear them out.
pub(crate) fn words_beside(prepared: &Prepared<'_>, told: &Told<'_>, judged: Judged) -> Judged {
    match found(prepared, told, &judged) {
        Some(beside) => judged.with_words(prepared, beside),
        None => judged,
    }
}

fn found(prepared: &Prepared<'_>, told: &Told<'_>, judged: &Judged) -> Option<Beside> {
    let chosen = judged.stood_behind();
    let of_library = !chosen.effects.is_empty() && chosen.effects.iter().all(|e| *e < prepared.testable.len());
    let derived = prepared.context.has_plates();
    let open = may_compose(told.options) && judged.kept_back.is_none() && !told.stop.load(Ordering::Relaxed);
    let one_recording = prepared.problem.simulator.joined().is_none();
    if derived || !of_library || !open || !one_recording || !prepared.lack_of_fit.adequacy(&chosen.fit).fires() {
        return None;
    }
    let searched = prepared.searched();
    let context = prepared.context.holding(judged.held.clone());
    let search = prepared.search(&searched, told.progress, told.stop);
    let search = &search.within(&context);
    let beside = |from: &Tried| beside(prepared, search, judged, from);
    let whole = beside(chosen);
    let told = whole.as_ref().map_or(judged.predicted.unseen.stood_behind(), |beside| &beside.unseen);
    // names are given up only for what foretells clearly better, and not for the same in other words
    let better = |alone: &Beside| {
        let gone: Vec<usize> = chosen.effects.iter().copied().filter(|e| !alone.composition.tried.effects.contains(e)).collect();
        let says_a_name = alone.composition.mechanisms.iter().any(|mechanism| says_one_of(search, &gone, mechanism));
        !says_a_name && compared(told, &alone.unseen).is_some_and(|both| both.better_by(FELT))
    };
    let alone = clearest(search, judged, chosen).and_then(|from| beside(&from)).filter(better);
    Some(without_unseen(prepared, search, judged, alone.or(whole)?))
}

/// The same without names of which nothing is seen beside the mechanisms: they had followed what a mechanism does. A name that a mechanism says in other words stays where its law is no more than a matter of form.
fn without_unseen(prepared: &Prepared<'_>, search: &Search<'_>, judged: &Judged, beside: Beside) -> Beside {
    let Beside { mut composition, mut unseen } = beside;
    let (mechanisms, library) = (&composition.mechanisms, prepared.testable.len());
    let with = &with_mechanisms(search, mechanisms);
    let names = |whole: &Tried| whole.effects.iter().copied().filter(|e| *e < library).collect::<Vec<_>>();
    let (said, others): (Vec<usize>, Vec<usize>) =
        names(&composition.tried).into_iter().partition(|name| mechanisms.iter().any(|m| says_one_of(search, &[*name], m)));
    let go = |name: &usize, whole: &mut Tried, told: &mut HeldOutFit| {
        if let Some(smaller) = without(prepared, with, judged, (whole, told), *name) {
            (*whole, *told) = smaller;
        }
    };
    others.iter().for_each(|name| go(name, &mut composition.tried, &mut unseen));
    if !said.is_empty() && !is_of_form(prepared, with, judged, (&composition.tried, &unseen), &names(&composition.tried)) {
        said.iter().for_each(|name| go(name, &mut composition.tried, &mut unseen));
    }
    Beside { composition, unseen }
}

/// A model without one name, and what that foretells, where nothing is seen of the name beside the others.
fn without(
    prepared: &Prepared<'_>,
    with: &Search<'_>,
    judged: &Judged,
    (whole, told): (&Tried, &HeldOutFit),
    name: usize,
) -> Option<(Tried, HeldOutFit)> {
    let others: Vec<usize> = whole.effects.iter().copied().filter(|e| *e != name).collect();
    let tried = with.part_of(whole, &others).filter(|tried| !promises(whole, tried))?;
    let unseen = predictions(prepared, with, &judged.by_base, &tried);
    let as_well = compared(&unseen, told).is_some_and(|both| both.rmse[0] <= CLEARLY_WORSE * both.rmse[1]);
    as_well.then_some((tried, unseen))
}

/// Whether the laws of these `names` alone remove most, on rows left out, of what the `whole` with mechanisms removes: a square of the speed is no matter of form where a gain that follows the speed removes 70 %.
fn is_of_form(
    prepared: &Prepared<'_>,
    with: &Search<'_>,
    judged: &Judged,
    (whole, told): (&Tried, &HeldOutFit),
    names: &[usize],
) -> bool {
    let base = &judged.by_base.unseen;
    let alone = with.part_of(whole, names).map(|tried| predictions(prepared, with, &judged.by_base, &tried));
    removes_most(base, alone.as_ref(), told)
}

/// Whether a model that foretells `by_names` removes most of what the whole removes; so it does where nothing is known of it.
fn removes_most(base: &HeldOutFit, by_names: Option<&HeldOutFit>, whole: &HeldOutFit) -> bool {
    let removed = |unseen: &HeldOutFit| removed(base, unseen);
    by_names.and_then(removed).zip(removed(whole)).is_none_or(|(by_names, whole)| by_names >= MAIN_SHARE * whole)
}

/// The part of a model that holds the one effect that explains most; `None` where that is all of it.
fn clearest(search: &Search<'_>, judged: &Judged, chosen: &Tried) -> Option<Tried> {
    if chosen.effects.len() < 2 {
        return None;
    }
    let base = judged.examined.selection.base();
    let alone = chosen.effects.iter().filter_map(|effect| search.part_of(chosen, &[*effect]));
    let best = alone.min_by(|a, b| a.fit.objective().total_cmp(&b.fit.objective()))?;
    (best.fit.explains_beyond(&base.fit) > 0.0).then_some(best)
}

/// Mechanisms beside `from`; `None` where rows left out are not predicted clearly better than by the answer.
fn beside(prepared: &Prepared<'_>, search: &Search<'_>, judged: &Judged, from: &Tried) -> Option<Beside> {
    let composition = compose_beside(search, &judged.examined.selection, from, &prepared.lack_of_fit)?;
    let with = with_mechanisms(search, &composition.mechanisms);
    let unseen = predictions(prepared, &with, &judged.by_base, &composition.tried);
    let both = compared(judged.predicted.unseen.stood_behind(), &unseen)?;
    both.better_by(FELT).then_some(Beside { composition, unseen })
}

impl Judged {
    fn with_words(mut self, prepared: &Prepared<'_>, beside: Beside) -> Self {
        let Beside { composition, unseen } = beside;
        let tried = composition.tried.clone();
        let after = prepared.lack_of_fit.adequacy(&tried.fit);
        let removed = self.share_removed_by(prepared, &tried, &unseen, &after);
        let chosen = self.stood_behind().key();
        let sets = self.predicted.decision.sets_of(&self.stood_behind().effects, &tried.effects);
        let sure = composition.sure();
        let (held, mechanisms, library) = (self.held.clone(), composition.mechanisms.len(), prepared.testable.len());
        self.examined = self.examined.with(|selection| selection.of_the_library(library, mechanisms));
        self.predicted.decision.model = self.examined.selection.place_of(chosen);
        self.composition = Some(composition);
        let mut told = self.told_by_sets(tried, held, unseen, after, (sets, removed));
        let decision = &mut told.predicted.decision;
        if !sure && decision.verdict == Verdict::Explained {
            decision.verdict = Verdict::Ambiguous;
        }
        told
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::validation::cross_validation::PartError;

    /// A gain that follows the speed leaves 0.25 of 0.46, and its square 0.03: the law is no matter of form. Of a loop 0.84 of 6.2 are left by its name alone.
    #[test]
    fn a_law_that_leaves_a_third_is_no_matter_of_form() {
        let errs = |error: f64| {
            let part = PartError { name: "run 1".into(), squares: Some(4.0 * error * error), rows: 4, score: None, warned: None };
            HeldOutFit { parts: vec![part], ..HeldOutFit::default() }
        };
        let of = |base: f64, by_names: f64, whole: f64| removes_most(&errs(base), Some(&errs(by_names)), &errs(whole));
        assert!(!of(0.46, 0.25, 0.03) && of(6.2, 0.84, 0.24));
        assert!(removes_most(&errs(0.46), None, &errs(0.03)));
    }
}
