//! Which effects could stand in the place of one that a model holds.
//!
//! Limits: models that the search has fitted; in one place at most two effects.

use crate::selection::{
    candidates::Tried,
    posterior::Selection,
    tuning::{LIKELIER_THAN_NOT, RIVAL, SURE},
};

/// How many effects may stand in the place of one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Places {
    One,
    OneOrTwo,
}

/// For each effect of model `best`: itself, and those that stand in its place in models of at least [`RIVAL`] of its probability.
pub(crate) fn rival_sets(selection: &Selection, best: usize, places: Places) -> Vec<Vec<usize>> {
    let model = &selection.models[best];
    let probability = selection.probability[best];
    let most = model.effects.len() + usize::from(places == Places::OneOrTwo);
    let place = |effect: &usize| {
        let others: Vec<usize> = model.effects.iter().copied().filter(|e| e != effect).collect();
        let mut set = vec![*effect];
        let likely = selection.models.iter().zip(&selection.probability).filter(|(_, p)| **p > RIVAL * probability);
        for (rival, _) in likely {
            let replaces = !rival.effects.contains(effect) && others.iter().all(|o| rival.effects.contains(o));
            if replaces && (model.effects.len()..=most).contains(&rival.effects.len()) {
                let new = rival.effects.iter().filter(|e| !others.contains(e));
                new.for_each(|e| {
                    if !set.contains(e) {
                        set.push(*e)
                    }
                });
            }
        }
        set
    };
    model.effects.iter().map(place).collect()
}

/// The likeliest model that holds `rival` and all that model `best` holds but `effect`, or else that holds `rival` without it; `None` where there is none.
pub(crate) fn in_place_of(selection: &Selection, best: usize, effect: usize, rival: usize) -> Option<&Tried> {
    let others = || selection.models[best].effects.iter().filter(|e| **e != effect);
    let holds = |tried: &Tried| tried.effects.contains(&rival) && !tried.effects.contains(&effect);
    let likeliest = |holds: &dyn Fn(&Tried) -> bool| {
        let those = selection.models.iter().zip(&selection.probability).filter(|(tried, _)| holds(tried));
        those.max_by(|a, b| a.1.total_cmp(b.1)).map(|(tried, _)| tried)
    };
    let all_others = |tried: &Tried| holds(tried) && others().all(|other| tried.effects.contains(other));
    likeliest(&all_others).or_else(|| likeliest(&holds))
}

/// Probability of each effect of model `best`, or of one of those that could stand in its place.
pub(crate) fn in_its_place(selection: &Selection, best: usize) -> Vec<f64> {
    let probability = |set: Vec<usize>| match set[..] {
        [effect] => selection.effect_probability[effect],
        _ => {
            let all = selection.models.iter().zip(&selection.probability);
            all.filter(|(tried, _)| tried.effects.iter().any(|e| set.contains(e))).map(|(_, p)| p).sum()
        }
    };
    rival_sets(selection, best, Places::One).into_iter().map(probability).collect()
}

/// The sets that are told of `best`, which may be a smaller model than the likeliest: of such a one the larger ones that hold it are no rivals.
///
/// Two effects together are looked for in the place of one where no one effect stands there and the model is not sure; and then what most models without it hold.
pub(crate) fn sets_told(selection: &Selection, best: usize) -> Vec<Vec<usize>> {
    let told = &selection.models[best].effects;
    let likeliest = selection.likeliest_named().unwrap_or(best);
    let known = rival_sets(selection, likeliest, Places::One);
    let place = |effect: &usize| selection.models[likeliest].effects.iter().position(|e| e == effect);
    // in the order of the model that is told
    let sets: Vec<Vec<usize>> = told.iter().filter_map(|effect| known.get(place(effect)?).cloned()).collect();
    let sure = told.iter().all(|e| selection.effect_probability[*e] >= SURE);
    if sets.iter().any(|set| set.len() > 1) || sure {
        return sets;
    }
    let in_place = rival_sets(selection, best, Places::OneOrTwo);
    if in_place.iter().any(|set| set.len() > 1) { in_place } else { held_by_most(selection, best) }
}

/// For each effect of model `best`: itself, and where it is not sure, those that most of the probability without it holds. Each model of such a rival may be far behind, where many of them share what it is
/// worth: a lag at the input beside any one of five small effects, in the place of a lag of the response that needs none of them.
fn held_by_most(selection: &Selection, best: usize) -> Vec<Vec<usize>> {
    let told = &selection.models[best].effects;
    let place = |effect: &usize| {
        let without: Vec<_> =
            selection.models.iter().zip(&selection.probability).filter(|(tried, _)| !tried.effects.contains(effect)).collect();
        let all: f64 = without.iter().map(|(_, p)| **p).sum();
        let held =
            |other: &usize| -> f64 { without.iter().filter(|(tried, _)| tried.effects.contains(other)).map(|(_, p)| **p).sum() };
        let open = selection.effect_probability[*effect] < SURE;
        let others = (0..selection.effect_probability.len()).filter(|other| open && !told.contains(other));
        std::iter::once(*effect).chain(others.filter(|other| held(other) > LIKELIER_THAN_NOT * all)).collect()
    };
    told.iter().map(place).collect()
}
