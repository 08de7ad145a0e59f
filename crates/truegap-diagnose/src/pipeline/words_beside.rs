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
        verdict::{Decision, Verdict},
    },
    validation::{
        cross_validation::{HeldOutFit, compared},
        tuning::{CLEARLY_WORSE, FELT},
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

/// The same without names of which nothing is seen beside the mechanisms: they had followed what a mechanism does. A name that a mechanism says in other words stays.
fn without_unseen(prepared: &Prepared<'_>, search: &Search<'_>, judged: &Judged, mut beside: Beside) -> Beside {
    let with = with_mechanisms(search, &beside.composition.mechanisms);
    let names: Vec<usize> = beside.composition.tried.effects.iter().copied().filter(|e| *e < prepared.testable.len()).collect();
    for name in names {
        if beside.composition.mechanisms.iter().any(|mechanism| says_one_of(search, &[name], mechanism)) {
            continue;
        }
        let whole = &beside.composition.tried;
        let others: Vec<usize> = whole.effects.iter().copied().filter(|e| *e != name).collect();
        let Some(tried) = with.part_of(whole, &others).filter(|tried| !promises(whole, tried)) else { continue };
        let unseen = predictions(prepared, &with, &judged.by_base, &tried);
        if compared(&unseen, &beside.unseen).is_some_and(|both| both.rmse[0] <= CLEARLY_WORSE * both.rmse[1]) {
            beside.composition.tried = tried;
            beside.unseen = unseen;
        }
    }
    beside
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
        let verdict = match Decision::of_sets(sets.iter(), removed, &after) {
            Verdict::Explained if !composition.sure() => Verdict::Ambiguous,
            verdict => verdict,
        };
        let (held, mechanisms, library) = (self.held.clone(), composition.mechanisms.len(), prepared.testable.len());
        self.examined = self.examined.with(|selection| selection.of_the_library(library, mechanisms));
        self.predicted.decision.model = self.examined.selection.place_of(chosen);
        self.composition = Some(composition);
        self.stands_behind(tried, held, unseen, after, |model, base| Decision {
            model,
            sets,
            removed,
            ..Decision::nothing(verdict, base)
        })
    }
}
