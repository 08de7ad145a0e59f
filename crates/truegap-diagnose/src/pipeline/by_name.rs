//! A mechanism composed of words that says what an effect of the library says is told by that effect's name, where the effect foretells rows left out as well.
//!
//! A computed or derived equation is worth more than a composed one, and its name is what a reader knows. Where its richer law foretells worse than the composed one, the simple law that it
//! holds as a special case is asked.
//!
//! Limits: an answer with one mechanism; effects that follow the same driver in the same way at the same place.

use crate::{
    adequacy::lack_of_fit::Adequacy,
    data::context::Context,
    effects::composed::words::InWords,
    pipeline::{
        judged::{Judged, Told},
        predicted::{Predicted, predictions},
        prepare::Prepared,
    },
    selection::{
        candidates::{Search, Tried},
        verdict::{Decision, Verdict, removed_by},
    },
    validation::{
        cross_validation::{HeldOutFit, compared},
        held_numbers::{not_borne_out, refitted},
        tuning::CLEARLY_WORSE,
        veto::Unseen,
    },
};
use truegap_core::EffectId;

/// An effect of the library in the place of a mechanism.
pub(crate) struct ByName {
    /// the model with it, the last of its effects
    tried: Tried,
    /// numbers of its law that are held at nothing
    held: Vec<(EffectId, &'static str)>,
    /// what it foretells of rows left out
    unseen: HeldOutFit,
    /// root-mean-square error there
    rmse: f64,
    /// what it leaves over
    after: Adequacy,
}

/// The effect that says the same as the mechanism of an answer and foretells as well; `None` where there is none.
pub(crate) fn by_name(prepared: &Prepared<'_>, told: &Told<'_>, judged: &Judged) -> Option<ByName> {
    let [mechanism] = judged.composition.as_ref()?.mechanisms.as_slice() else { return None };
    let (selection, place) = (&judged.examined.selection, prepared.testable.len());
    let chosen = &selection.models[judged.predicted.decision.model];
    let others: Vec<usize> = chosen.effects.iter().copied().filter(|e| *e != place).collect();
    if others.len() == chosen.effects.len() {
        return None;
    }
    let searched = prepared.searched();
    let search = &prepared.search(&searched, told.progress, told.stop);
    let words = mechanism.effect.sentence.in_words();
    let alike: Vec<usize> = (0..place).filter(|e| !others.contains(e) && says(search, *e).as_ref() == Some(&words)).collect();
    let from = selection.with(&others)?;
    let found = search.add_each(from, &alike, alike.len(), "by name");
    let asked = found.iter().filter_map(|tried| asked(prepared, search, judged, tried));
    let as_well = |own: &ByName| {
        let both = compared(judged.predicted.unseen.stood_behind(), &own.unseen);
        both.is_some_and(|both| both.rmse[1] <= CLEARLY_WORSE * both.rmse[0])
    };
    asked.filter(as_well).min_by(|a, b| a.rmse.total_cmp(&b.rmse))
}

fn says(search: &Search<'_>, effect: usize) -> Option<InWords> {
    search.library[effect].in_words(search.context)
}

/// A model with an effect of the library last, fitted to the end and asked for rows left out; `None` where those speak against it.
fn asked(prepared: &Prepared<'_>, search: &Search<'_>, judged: &Judged, tried: &Tried) -> Option<ByName> {
    let tried = search.polished(tried)?;
    let held = not_borne_out(search, &prepared.searched_noise, &tried, prepared.all_rows());
    let context: Context<'_> = search.context.holding([search.context.held.as_slice(), &held].concat());
    let simple = Search { context: &context, library: search.library.clone(), ..*search };
    let tried = if held.is_empty() { tried } else { refitted(&simple, &tried)? };
    let unseen = predictions(prepared, &simple, &judged.by_base, &tried);
    let base = &judged.by_base.unseen;
    let both = Unseen::of((base.clone(), &judged.examined.selection.base().fit), (unseen.clone(), &tried.fit));
    if both.against(prepared.noise_is_known()).is_some() {
        return None;
    }
    let (rmse, after) = (compared(base, &unseen)?.rmse[1], prepared.lack_of_fit.adequacy(&tried.fit));
    Some(ByName { held: context.held.clone(), tried, unseen, rmse, after })
}

impl Judged {
    /// The same with an effect of the library named in the place of the mechanism.
    pub(crate) fn told_by(mut self, name: ByName) -> Self {
        let ByName { tried, held, unseen, after, .. } = name;
        let (place, selection) = (self.predicted.decision.model, self.examined.selection);
        let explained = 2.0 * (selection.base().fit.objective() - tried.fit.objective());
        let removed = removed_by(explained, &after);
        let sets: Vec<Vec<usize>> =
            tried.effects.iter().map(|e| set_of(&selection.models[place], &self.predicted.decision, *e)).collect();
        let key = tried.key();
        let named = (unseen, &tried.fit);
        let unseen = Unseen::of((self.by_base.unseen.clone(), &selection.base().fit), named);
        let selection = selection.told_as(place, tried.clone());
        let model = selection.models.iter().position(|m| m.key() == key).unwrap_or(selection.base);
        let verdict = match sets.iter().any(|set| set.len() > 1) {
            true => Verdict::Ambiguous,
            false if Decision::adequate(removed, &after) => Verdict::Explained,
            false => Verdict::WrongForm,
        };
        let decision = Decision { verdict, model, sets, removed, unmodelled: None, unmodelled_rivals: false };
        self.examined.selection = selection;
        self.predicted = Predicted { unseen, decision, after: Some(after), ..self.predicted };
        self.held = held;
        self
    }
}

/// The set of rivals in which an effect stands already; itself alone where it is new.
fn set_of(chosen: &Tried, decision: &Decision, effect: usize) -> Vec<usize> {
    let place = chosen.effects.iter().position(|e| *e == effect);
    place.and_then(|place| decision.sets.get(place)).cloned().unwrap_or_else(|| vec![effect])
}
