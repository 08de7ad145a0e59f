//! A mechanism composed of words that says what an effect of the library says is told by that effect's name, where the effect foretells rows left out as well.
//!
//! A computed or derived equation is worth more than a composed one, and its name is what a reader knows. Where its richer law foretells worse than the composed one, the simple law that it
//! holds as a special case is asked.
//!
//! So is one whose law predicts worse, while it removes nine tenths of what the composed one removes: the law is a matter of form then, and the composed one stands beside the answer.
//!
//! Only where the noise was not measured: one that was has weighed a law of the library against the composed one by what tells the two apart.
//!
//! Of several names that foretell nearly alike the one is told that is likeliest by evidence and beforehand, and those that foretell as well as it may stand in its place.
//!
//! Two mechanisms are told by two names, which foretell as well, or by none.
//!
//! Limits: effects that follow the same driver in the same way at the same place.

use crate::{
    adequacy::lack_of_fit::Adequacy,
    data::context::{Context, Number},
    discovery::{discover::Discovery, same_words::with_followed_driver},
    effects::composed::words::InWords,
    pipeline::{
        judged::{Judged, Told},
        prepare::Prepared,
        simple_laws::{Simple, simple},
    },
    selection::{
        candidates::{Search, Tried},
        detectability::detectability,
        prior::weight,
        tuning::VISIBLE,
        verdict::removed_by,
    },
    validation::{
        cross_validation::{HeldOutFit, compared},
        main_causes::removed,
        tuning::{CLEARLY_WORSE, FELT, MAIN_SHARE, MOST_NAMES},
        veto::Unseen,
    },
};

/// Effects of the library in the place of mechanisms.
pub(crate) struct ByName {
    /// the model with them, the last of its effects
    tried: Tried,
    /// numbers of their laws that are held at nothing
    held: Vec<Number>,
    /// what it foretells of rows left out
    unseen: HeldOutFit,
    /// root-mean-square error there
    rmse: f64,
    /// what may stand in the place of the last effect
    rivals: Vec<usize>,
    /// what it leaves over
    after: Adequacy,
}

/// The effects that say the same as the mechanisms of an answer, one for each, and foretell as well; `None` where there are none.
pub(crate) fn by_name(prepared: &Prepared<'_>, told: &Told<'_>, judged: &Judged) -> Option<ByName> {
    // a noise that was measured has weighed both already
    let composition = judged.composition.as_ref().filter(|_| !prepared.noise_is_known())?;
    let (selection, library) = (&judged.examined.selection, prepared.testable.len());
    let chosen = &selection.models[judged.predicted.decision.model];
    let others: Vec<usize> = chosen.effects.iter().copied().filter(|e| *e < library).collect();
    // a model that holds one of two mechanisms alone was not found with the other
    if others.len() + composition.mechanisms.len() != chosen.effects.len() {
        return None;
    }
    let searched = prepared.searched();
    let search = &prepared.search(&searched, told.progress, told.stop);
    let alike = |mechanism: &Discovery| -> Vec<usize> {
        let words = with_followed_driver(mechanism.effect.sentence.in_words(), search.context);
        (0..library).filter(|e| !others.contains(e) && says(search, *e).as_ref() == Some(&words)).collect()
    };
    // every choice of one name for each mechanism is fitted
    let two = composition.mechanisms.len() > 1;
    let most = if two { MOST_NAMES } else { library };
    let add = |from: &Tried, alike: &[usize]| search.add_each(from, alike, most, "by name");
    let found = every_choice(selection.with(&others)?.clone(), composition.mechanisms.iter().map(alike), add);
    let asked = found.iter().filter_map(|tried| asked(prepared, search, judged, (tried, others.len())));
    // beside the effects the mechanisms have to prove themselves, as any further effect
    let as_well = |own: &ByName| {
        let composed = (judged.predicted.unseen.stood_behind().clone(), &chosen.fit);
        Unseen::of((own.unseen.clone(), &own.tried.fit), composed).against(false, || false).is_some()
    };
    // another law of the same place, driver and kinetics is a matter of form; of two a small one would be nine tenths of nothing
    let base = &judged.by_base.unseen;
    let composed = removed(base, judged.predicted.unseen.stood_behind());
    let most_of_it =
        |own: &ByName| removed(base, &own.unseen).zip(composed).is_some_and(|(own, composed)| own >= MAIN_SHARE * composed);
    let told: Vec<ByName> = asked.filter(|own| as_well(own) || (!two && most_of_it(own))).collect();
    let weight = weight(selection.temper, library);
    let (own, others) = likeliest(told, |own| (own.rmse, weight(&own.tried)))?;
    let last = |other: &ByName| other.tried.effects.last().copied();
    Some(ByName { rivals: if two { Vec::new() } else { others.iter().filter_map(last).collect() }, ..own })
}

/// Of those that foretell with no more than [`FELT`] times the least error, as `of` tells of error and log weight, the one of the greatest weight, and the others whose error is not clearly larger than its own.
fn likeliest<N>(mut found: Vec<N>, of: impl Fn(&N) -> (f64, f64)) -> Option<(N, Vec<N>)> {
    let least = found.iter().map(|one| of(one).0).min_by(f64::total_cmp)?;
    let near = |error: f64| error <= FELT * least;
    let best = (0..found.len())
        .filter(|place| near(of(&found[*place]).0))
        .max_by(|a, b| of(&found[*a]).1.total_cmp(&of(&found[*b]).1))?;
    let best = found.swap_remove(best);
    let as_good = CLEARLY_WORSE * of(&best).0;
    found.retain(|other| of(other).0 <= as_good);
    Some((best, found))
}

/// Models with one name of each list more, every choice of them, as `add` gives them for one list; none where a list is empty.
fn every_choice<M>(from: M, lists: impl Iterator<Item = Vec<usize>>, add: impl Fn(&M, &[usize]) -> Vec<M>) -> Vec<M> {
    lists.fold(vec![from], |models, list| models.iter().flat_map(|from| add(from, &list)).collect())
}

fn says(search: &Search<'_>, effect: usize) -> Option<InWords> {
    Some(with_followed_driver(search.library[effect].in_words(search.context)?, search.context))
}

/// A model with effects of the library from a place `first` on, fitted to the end and asked for rows left out; `None` where one of these does not stand out of the noise.
fn asked(prepared: &Prepared<'_>, search: &Search<'_>, judged: &Judged, (tried, first): (&Tried, usize)) -> Option<ByName> {
    let tried = search.polished(tried)?;
    let Simple { tried, held, unseen } = simple(prepared, search, &judged.by_base, &tried, CLEARLY_WORSE)?;
    let context: Context<'_> = search.context.holding(held.clone());
    let unseen_by = |place: usize| detectability(&search.within(&context), &tried, place).is_some_and(|d| d < VISIBLE);
    if (first..tried.effects.len()).any(unseen_by) {
        return None;
    }
    let (rmse, after) = (compared(&judged.by_base.unseen, &unseen)?.rmse[1], prepared.lack_of_fit.adequacy(&tried.fit));
    Some(ByName { held, tried, unseen, rmse, rivals: Vec::new(), after })
}

impl Judged {
    /// The same with effects of the library named in the place of the mechanisms.
    pub(crate) fn told_by(self, name: ByName) -> Self {
        let ByName { tried, held, unseen, after, rivals, .. } = name;
        let (place, selection) = (self.predicted.decision.model, &self.examined.selection);
        let explained = tried.fit.explains_beyond(&selection.base().fit);
        let removed = removed_by(explained, &after);
        let mut sets = self.predicted.decision.sets_of(&selection.models[place].effects, &tried.effects);
        if let Some(set) = sets.last_mut() {
            set.extend(rivals);
        }
        self.told_by_sets(tried, held, unseen, after, (sets, removed))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A gain with a pivot foretells with 0.92 of the error of a drift, which is likelier by far; one with half of it is told.
    #[test]
    fn of_names_that_foretell_nearly_alike_the_likeliest_is_told() {
        let told = |found: &[(f64, f64)]| likeliest(found.to_vec(), |one| *one).map(|(one, others)| (one.0, others.len() as f64));
        assert_eq!(told(&[(3.04, 115.0), (3.32, 139.0)]), Some((3.32, 1.0)));
        assert_eq!(told(&[(1.5, 115.0), (3.32, 139.0)]), Some((1.5, 0.0)));
        assert_eq!(told(&[(3.0, 139.0), (3.1, 115.0), (3.4, 120.0)]), Some((3.0, 1.0)));
        assert_eq!(told(&[]), None);
    }

    /// A reading that comes late has two names, one that goes with the temperature has one; beside an effect that was named already.
    #[test]
    fn two_mechanisms_are_told_by_one_name_each_or_by_none() {
        let add = |from: &Vec<usize>, names: &[usize]| names.iter().map(|name| [from.as_slice(), &[*name]].concat()).collect();
        let choices = |lists: &[&[usize]]| every_choice(vec![9], lists.iter().map(|list| list.to_vec()), add);
        assert_eq!(choices(&[&[1, 2], &[5]]), [[9, 1, 5], [9, 2, 5]]);
        assert_eq!(choices(&[&[1, 2]]), [[9, 1], [9, 2]]);
        assert!(choices(&[&[1, 2], &[]]).is_empty());
    }
}
