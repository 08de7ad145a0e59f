//! A mechanism composed of words that says what an effect of the library says is told by that effect's name, where the effect foretells rows left out as well.
//!
//! A computed or derived equation is worth more than a composed one, and its name is what a reader knows. Where its richer law foretells worse than the composed one, the simple law that it
//! holds as a special case is asked.
//!
//! So is one whose law predicts worse, while it removes nine tenths of what the composed one removes: the law is a matter of form then, and the composed one stands beside the answer.
//!
//! Only where the noise was not measured: one that was has weighed a law of the library against the composed one by what tells the two apart.
//!
//! Limits: an answer with one mechanism; effects that follow the same driver in the same way at the same place.

use crate::{
    adequacy::lack_of_fit::Adequacy,
    data::context::{Context, Number},
    discovery::same_words::with_followed_driver,
    effects::composed::words::InWords,
    pipeline::{
        judged::{Judged, Told},
        prepare::Prepared,
        simple_laws::{Simple, simple},
    },
    selection::{
        candidates::{Search, Tried},
        detectability::detectability,
        tuning::VISIBLE,
        verdict::{Decision, removed_by},
    },
    validation::{
        cross_validation::{HeldOutFit, compared},
        main_causes::removed,
        tuning::{CLEARLY_WORSE, MAIN_SHARE},
        veto::Unseen,
    },
};

/// An effect of the library in the place of a mechanism.
pub(crate) struct ByName {
    /// the model with it, the last of its effects
    tried: Tried,
    /// numbers of its law that are held at nothing
    held: Vec<Number>,
    /// what it foretells of rows left out
    unseen: HeldOutFit,
    /// root-mean-square error there
    rmse: f64,
    /// what it leaves over
    after: Adequacy,
}

/// The effect that says the same as the mechanism of an answer and foretells as well; `None` where there is none.
pub(crate) fn by_name(prepared: &Prepared<'_>, told: &Told<'_>, judged: &Judged) -> Option<ByName> {
    // a noise that was measured has weighed both already
    let composition = judged.composition.as_ref().filter(|_| !prepared.noise_is_known())?;
    let [mechanism] = composition.mechanisms.as_slice() else { return None };
    let (selection, place) = (&judged.examined.selection, prepared.testable.len());
    let chosen = &selection.models[judged.predicted.decision.model];
    let others: Vec<usize> = chosen.effects.iter().copied().filter(|e| *e != place).collect();
    if others.len() == chosen.effects.len() {
        return None;
    }
    let searched = prepared.searched();
    let search = &prepared.search(&searched, told.progress, told.stop);
    let words = with_followed_driver(mechanism.effect.sentence.in_words(), search.context);
    let alike: Vec<usize> = (0..place).filter(|e| !others.contains(e) && says(search, *e).as_ref() == Some(&words)).collect();
    let from = selection.with(&others)?;
    let found = search.add_each(from, &alike, alike.len(), "by name");
    let asked = found.iter().filter_map(|tried| asked(prepared, search, judged, tried));
    // beside the effect the mechanism has to prove itself, as any further effect
    let as_well = |own: &ByName| {
        let composed = (judged.predicted.unseen.stood_behind().clone(), &chosen.fit);
        Unseen::of((own.unseen.clone(), &own.tried.fit), composed).against(false, || false).is_some()
    };
    // another law of the same place, driver and kinetics is a matter of form
    let base = &judged.by_base.unseen;
    let composed = removed(base, judged.predicted.unseen.stood_behind());
    let most_of_it =
        |own: &ByName| removed(base, &own.unseen).zip(composed).is_some_and(|(own, composed)| own >= MAIN_SHARE * composed);
    asked.filter(|own| as_well(own) || most_of_it(own)).min_by(|a, b| a.rmse.total_cmp(&b.rmse))
}

fn says(search: &Search<'_>, effect: usize) -> Option<InWords> {
    Some(with_followed_driver(search.library[effect].in_words(search.context)?, search.context))
}

/// A model with an effect of the library last, fitted to the end and asked for rows left out; `None` where the effect does not stand out of the noise.
fn asked(prepared: &Prepared<'_>, search: &Search<'_>, judged: &Judged, tried: &Tried) -> Option<ByName> {
    let tried = search.polished(tried)?;
    let Simple { tried, held, unseen } = simple(prepared, search, &judged.by_base, &tried, CLEARLY_WORSE)?;
    let context: Context<'_> = search.context.holding(held.clone());
    if detectability(&search.within(&context), &tried, tried.effects.len() - 1).is_some_and(|d| d < VISIBLE) {
        return None;
    }
    let (rmse, after) = (compared(&judged.by_base.unseen, &unseen)?.rmse[1], prepared.lack_of_fit.adequacy(&tried.fit));
    Some(ByName { held, tried, unseen, rmse, after })
}

impl Judged {
    /// The same with an effect of the library named in the place of the mechanism.
    pub(crate) fn told_by(self, name: ByName) -> Self {
        let ByName { tried, held, unseen, after, .. } = name;
        let (place, selection) = (self.predicted.decision.model, &self.examined.selection);
        let explained = tried.fit.explains_beyond(&selection.base().fit);
        let removed = removed_by(explained, &after);
        let sets = self.predicted.decision.sets_of(&selection.models[place].effects, &tried.effects);
        let verdict = Decision::of_sets(sets.iter(), removed, &after);
        self.stands_behind(tried, held, unseen, after, |model, base| Decision {
            model,
            sets,
            removed,
            ..Decision::nothing(verdict, base)
        })
    }
}
