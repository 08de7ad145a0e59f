//! Among rivals that the evidence does not tell apart, the one that foretells rows left out best is named first.
//!
//! The set stays what it is: it says what this recording cannot tell apart. What is named of it also predicts, and there rows left out can tell.
//!
//! Limits: models that the search has fitted, with one effect from each set.

use crate::{
    selection::{candidates::Tried, posterior::Selection, tuning::RIVAL},
    validation::{
        cross_validation::{HeldOutFit, compared},
        tuning::{CLEARLY_WORSE, MOST_RIVALS},
    },
};

/// A model that is named, and what it foretells of rows left out.
pub(crate) struct Named {
    /// of the selection
    pub model: usize,
    /// predictions of rows left out
    pub unseen: HeldOutFit,
}

/// The rival that predicts rows left out clearly better than model `first` and all other rivals, with the sets in its words; `None` where none does.
pub(crate) fn best_foreteller(
    selection: &Selection,
    (first, sets): (&Named, &[Vec<usize>]),
    unseen: impl Fn(&Tried) -> HeldOutFit,
) -> Option<(Named, Vec<Vec<usize>>)> {
    let rivals = rivals(selection, first.model, sets).into_iter().map(|model| (model, unseen(&selection.models[model])));
    let error = |rival: &(usize, HeldOutFit)| {
        let [named, other] = compared(&first.unseen, &rival.1)?.rmse;
        (named > CLEARLY_WORSE * other).then_some(other)
    };
    let better = rivals.filter_map(|rival| Some((error(&rival)?, rival)));
    let (_, (model, unseen)) = better.min_by(|a, b| a.0.total_cmp(&b.0))?;
    let sets = first_of_each(sets, &selection.models[model].effects);
    Some((Named { model, unseen }, sets))
}

/// Models with one effect from each of `sets` that are likely enough to be rivals of model `first`, the likeliest first.
pub(crate) fn rivals(selection: &Selection, first: usize, sets: &[Vec<usize>]) -> Vec<usize> {
    let least = RIVAL * selection.probability[first];
    let one_of_each = |effects: &[usize]| {
        !sets.is_empty()
            && effects.len() == sets.len()
            && sets.iter().all(|set| effects.iter().filter(|e| set.contains(e)).count() == 1)
    };
    let likely = (0..selection.models.len()).filter(|model| *model != first && selection.probability[*model] > least);
    likely.filter(|model| one_of_each(&selection.models[*model].effects)).take(MOST_RIVALS).collect()
}

/// Models that hold another effect in the place of one of `model`, the nearest to the recording first: that effect and the other one, and the place of the model.
pub(crate) fn exchanged(selection: &Selection, model: usize) -> Vec<((usize, usize), usize)> {
    let own = &selection.models[model].effects;
    let exchange = |place: usize| {
        let other = &selection.models[place].effects;
        let gone: Vec<usize> = own.iter().copied().filter(|e| !other.contains(e)).collect();
        let new: Vec<usize> = other.iter().copied().filter(|e| !own.contains(e)).collect();
        match (gone.as_slice(), new.as_slice()) {
            ([gone], [new]) if other.len() == own.len() => Some(((*gone, *new), place)),
            _ => None,
        }
    };
    let mut found: Vec<_> = (0..selection.models.len()).filter_map(exchange).collect();
    found.sort_by(|a, b| selection.models[a.1].fit.objective().total_cmp(&selection.models[b.1].fit.objective()));
    found
}

/// The sets with the effect that is named first in each.
pub(crate) fn first_of_each(sets: &[Vec<usize>], named: &[usize]) -> Vec<Vec<usize>> {
    let ordered = |set: &Vec<usize>| {
        let (first, others): (Vec<usize>, Vec<usize>) = set.iter().partition(|effect| named.contains(effect));
        [first, others].concat()
    };
    // in the order of the effects of the model, as sets stand
    let of = |effect: &usize| sets.iter().find(|set| set.contains(effect)).map(ordered);
    named.iter().filter_map(of).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::validation::cross_validation::PartError;

    /// One effect of a pair is exchanged; neither a larger model nor one that shares nothing is a rival.
    #[test]
    fn a_rival_has_one_effect_exchanged() {
        let all = Selection::of(&[(&[], 0.0), (&[0, 1], 0.5), (&[2, 1], 0.2), (&[2, 3], 0.2), (&[0, 1, 2], 0.1), (&[3, 0], 0.0)]);
        let mut found = exchanged(&all, 1);
        found.sort_unstable();
        assert_eq!(found, [((0, 2), 2), ((1, 3), 5)]);
    }

    fn errors(squares: f64) -> HeldOutFit {
        let part = PartError { name: "run 1".into(), squares: Some(squares), rows: 4, score: None, warned: None };
        HeldOutFit { parts: vec![part], ..HeldOutFit::default() }
    }

    fn chosen(models: &[(&[usize], f64)], squares: impl Fn(&[usize]) -> f64) -> Option<(usize, Vec<Vec<usize>>)> {
        let selection = Selection::of(models);
        let first = Named { model: 0, unseen: errors(squares(models[0].0)) };
        let sets = [vec![3], vec![0, 1, 2]];
        best_foreteller(&selection, (&first, &sets), |tried| errors(squares(&tried.effects))).map(|(n, sets)| (n.model, sets))
    }

    #[test]
    fn the_rival_that_foretells_best_is_named_first_and_the_set_stays() {
        let models: &[(&[usize], f64)] = &[(&[0, 3], 0.5), (&[1, 3], 0.3), (&[2, 3], 0.2)];
        let found = chosen(models, |effects| [9.0, 4.0, 2.0][effects[0]]);
        assert_eq!(found, Some((2, vec![vec![2, 0, 1], vec![3]])));
    }

    #[test]
    fn neither_a_rival_that_is_hardly_better_nor_one_that_is_no_rival_is_named() {
        let models: &[(&[usize], f64)] = &[(&[0, 3], 0.5), (&[1, 3], 0.3), (&[2, 3], 0.001)];
        // 0.98 of the error; and a tenth of it, by a model that the evidence excludes
        assert_eq!(chosen(models, |effects| [1.0, 0.97, 0.01][effects[0]]), None);
    }
}
