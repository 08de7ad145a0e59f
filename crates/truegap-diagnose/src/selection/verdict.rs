//! One of six verdicts from probabilities and adequacy.
//!
//! Limits: thresholds were fixed on generated recordings and the open cases (`docs/diagnosis.md`), never on sealed ones.

use crate::{
    adequacy::lack_of_fit::Adequacy,
    selection::{
        effect_set::EffectSet,
        posterior::Selection,
        rival_sets::{Places, in_its_place, rival_sets, sets_told},
        tuning::{ADEQUATE, AGREED, DETECTED, LIKELIER_THAN_NOT, LOUD_REST, RIGHT_FAMILY, RIVAL, SURE},
        unmodelled::Unmodelled,
    },
};
use serde::Serialize;

/// The six verdicts, and no others.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Verdict {
    /// no mismatch found
    Agrees,
    /// missing: the findings
    Explained,
    /// missing: one of `ambiguity`
    Ambiguous,
    /// the family is clear, the equation is not adequate
    WrongForm,
    /// something real that nothing in the library explains
    Unexplained,
    /// mismatch present, cause not decided
    Undecided,
}

impl Verdict {
    /// As in files.
    pub fn word(self) -> &'static str {
        match self {
            Self::Agrees => "agrees",
            Self::Explained => "explained",
            Self::Ambiguous => "ambiguous",
            Self::WrongForm => "wrong_form",
            Self::Unexplained => "unexplained",
            Self::Undecided => "undecided",
        }
    }
}

/// What was decided.
#[derive(Clone, Debug)]
pub struct Decision {
    /// verdict
    pub verdict: Verdict,
    /// index into the selection's models of the model stood behind; the base model where nothing is named
    pub model: usize,
    /// sets of effects (indices into the library) that cannot be told apart, one a finding
    pub sets: Vec<Vec<usize>>,
    /// share of the structured misfit that the best model removes
    pub removed: f64,
    /// unmodelled cause that is likelier than all of it
    pub unmodelled: Option<Unmodelled>,
    /// whether an unmodelled cause cannot be excluded
    pub unmodelled_rivals: bool,
    /// effects of the model stood behind (indices into the library) that it carries without a claim to their names
    pub carried: Vec<usize>,
}

impl Decision {
    /// Something is in the reading that no model of the base's physics could make, `left` of it beside the model stood behind, which explains `explained`: the verdict
    /// where otherwise all agrees, or where it is more than an equation in the wrong form leaves.
    #[must_use]
    pub fn with_interference(self, base: usize, explained: f64, left: f64) -> Self {
        let more = share(explained, left) < RIGHT_FAMILY;
        match self.verdict {
            Verdict::Agrees => Self::nothing(Verdict::Unexplained, base),
            Verdict::Explained | Verdict::Ambiguous | Verdict::WrongForm if more => Self::nothing(Verdict::Unexplained, base),
            _ => self,
        }
    }

    /// The same with `new` in the set of the effect `own`: which of the two it is, is not told.
    #[must_use]
    pub(crate) fn with_rival(mut self, (own, new): (usize, usize)) -> Self {
        if let Some(set) = self.sets.iter_mut().find(|set| set.contains(&own) && !set.contains(&new)) {
            set.push(new);
            self.verdict = Verdict::Ambiguous;
        }
        self
    }

    /// The same where these of the `effects` of its model are only carried: what they leave open is not open any more. The others stand for a `share` of what the model removes, and are all
    /// there is to explain only where that is as much as an adequate equation removes; `after` is what the model leaves.
    #[must_use]
    pub(crate) fn carrying(self, (carried, share): (Vec<usize>, f64), effects: &[usize], after: &Adequacy) -> Self {
        if carried.is_empty() {
            return self;
        }
        let claimed = || effects.iter().zip(&self.sets).filter(|(effect, _)| !carried.contains(effect)).map(|(_, set)| set);
        let verdict = match claimed().any(|set| set.len() > 1) || self.unmodelled_rivals {
            true => Verdict::Ambiguous,
            false if share >= ADEQUATE && Self::adequate(self.removed, after) => Verdict::Explained,
            false => Verdict::WrongForm,
        };
        Self { verdict, carried, ..self }
    }

    /// Whether what is left beside a model that removes this share of the misfit is no reason to doubt it.
    pub(crate) fn adequate(removed: f64, after: &Adequacy) -> bool {
        !after.fires() || (removed >= ADEQUATE && after.left_over_noise < LOUD_REST)
    }

    /// A verdict that names nothing, where model `base` is the base model.
    pub(crate) fn nothing(verdict: Verdict, base: usize) -> Self {
        Self {
            verdict,
            model: base,
            sets: Vec::new(),
            removed: 0.0,
            unmodelled: None,
            unmodelled_rivals: false,
            carried: Vec::new(),
        }
    }
}

/// The model to stand behind, an index into the selection's: the likeliest that names something. Where that holds effects that are not sure, and none of its effects has a
/// rival in its place, the model of those that are sure; where one has, the model without those that are less likely than not. A smaller model that the evidence excludes is no answer:
/// something has to be in the place of what it lacks. Where that is one of several, the smallest part of the likeliest model that is not excluded is stood behind. `None` where nothing was
/// fitted.
pub fn stated(selection: &Selection) -> Option<usize> {
    let best = selection.likeliest_named()?;
    let effects = &selection.models[best].effects;
    let rivals = rival_sets(selection, best, Places::One).iter().any(|s| s.len() > 1);
    let least = if rivals { LIKELIER_THAN_NOT } else { SURE };
    let told: EffectSet =
        effects.iter().copied().zip(in_its_place(selection, best)).filter(|(_, p)| *p >= least).map(|(e, _)| e).collect();
    let smaller = selection.models.iter().position(|m| !m.effects.is_empty() && m.key() == told);
    let excluded = |model: usize| selection.probability[model] < RIVAL * selection.probability[best];
    let Some(told) = smaller.filter(|told| excluded(*told)) else { return Some(smaller.unwrap_or(best)) };
    let one_of_several = |model: usize| sets_told(selection, model).iter().any(|set| set.len() > 1);
    let parts = parts_of(selection, best).into_iter().filter(|part| !excluded(*part));
    Some(parts.into_iter().find(|part| one_of_several(*part)).unwrap_or(told))
}

/// Models that hold some or all effects of model `best` and no other, the smallest first, of one size the likeliest.
fn parts_of(selection: &Selection, best: usize) -> Vec<usize> {
    let whole = &selection.models[best].effects;
    let is_part = |model: &usize| {
        let effects = &selection.models[*model].effects;
        !effects.is_empty() && effects.iter().all(|e| whole.contains(e))
    };
    let mut parts: Vec<usize> = (0..selection.models.len()).filter(is_part).collect();
    let size = |model: usize| selection.models[model].effects.len();
    parts.sort_by(|a, b| size(*a).cmp(&size(*b)).then(selection.probability[*b].total_cmp(&selection.probability[*a])));
    parts
}

/// Decides; `after` is the adequacy of the model that [`stated`] names, `free_form` says which effects have no equation that could be wrong.
pub fn decide(selection: &Selection, before: &Adequacy, after: &Adequacy, free_form: impl Fn(usize) -> bool) -> Decision {
    let nothing = |verdict| Decision::nothing(verdict, selection.base);
    let none = selection.probability_none();
    let library_sees = none < DETECTED;
    if !library_sees {
        return if before.fires() {
            let likely = selection.unmodelled.first().filter(|(_, odds)| *odds > none);
            Decision { unmodelled: likely.map(|(u, _)| u.clone()), ..nothing(Verdict::Unexplained) }
        } else {
            nothing(if none >= AGREED { Verdict::Agrees } else { Verdict::Undecided })
        };
    }
    if let Some(unmodelled) = selection.likelier_than_the_library() {
        return unmodelled_instead(selection, unmodelled);
    }
    let Some(best) = stated(selection) else { return nothing(Verdict::Undecided) };
    let removed = removed_by(2.0 * (selection.base().fit.objective() - selection.models[best].fit.objective()), after);
    let sets = sets_told(selection, best);
    let rivals = sets.iter().any(|s| s.len() > 1);
    let sure = selection.models[best].effects.iter().all(|e| selection.effect_probability[*e] >= SURE);
    if after.fires() && removed.min(removed_by_equations(selection, best, after, free_form)) < RIGHT_FAMILY {
        return Decision { removed, ..nothing(Verdict::Unexplained) };
    }
    let unmodelled_rivals = !sure && selection.probability_unmodelled() > 1.0 - SURE;
    let verdict = match sure && !rivals {
        true if Decision::adequate(removed, after) => Verdict::Explained,
        true => Verdict::WrongForm,
        false if rivals || unmodelled_rivals => Verdict::Ambiguous,
        false => Verdict::Undecided,
    };
    let model = if verdict == Verdict::Undecided { selection.base } else { best };
    Decision { verdict, model, sets, removed, unmodelled_rivals, ..nothing(verdict) }
}

/// The decision for a smaller model than the one stood behind, some of whose effects are not claimed; `after` is the adequacy of the smaller one.
pub(crate) fn stepped_back(selection: &Selection, decision: &Decision, model: usize, after: &Adequacy) -> Decision {
    let (fuller, smaller) = (&selection.models[decision.model], &selection.models[model]);
    let set = |effect: &usize| {
        let place = fuller.effects.iter().position(|e| e == effect);
        place.and_then(|place| decision.sets.get(place)).cloned().unwrap_or_else(|| vec![*effect])
    };
    let sets: Vec<Vec<usize>> = smaller.effects.iter().map(set).collect();
    let removed = removed_by(2.0 * (selection.base().fit.objective() - smaller.fit.objective()), after);
    let verdict = match after.fires() {
        true if removed < RIGHT_FAMILY => return Decision { removed, ..Decision::nothing(Verdict::Unexplained, selection.base) },
        _ if sets.iter().any(|set| set.len() > 1) => Verdict::Ambiguous,
        _ if Decision::adequate(removed, after) => Verdict::Explained,
        _ => Verdict::WrongForm,
    };
    Decision { verdict, model, sets, removed, ..decision.clone() }
}

/// The decision for a model that foretells rows left out, and whose rest stands out all the same: `removed` is the share of the reproducible misfit that it removes there.
pub(crate) fn foretold(selection: &Selection, model: usize, removed: f64) -> Decision {
    let sets = sets_told(selection, model);
    let verdict = if sets.iter().any(|set| set.len() > 1) { Verdict::Ambiguous } else { Verdict::WrongForm };
    Decision { model, sets, removed, ..Decision::nothing(verdict, selection.base) }
}

/// An unmodelled cause is likelier than all of it. What it stands beside is not named: it would be a smaller part of what is missing.
fn unmodelled_instead(selection: &Selection, unmodelled: &Unmodelled) -> Decision {
    let beside = selection.with(&unmodelled.effects).unwrap_or(selection.base());
    let explained = (selection.base().fit.objective() - beside.fit.objective()).max(0.0);
    let removed = explained / (explained + unmodelled.gain.max(f64::MIN_POSITIVE));
    Decision { removed, unmodelled: Some(unmodelled.clone()), ..Decision::nothing(Verdict::Unexplained, selection.base) }
}

/// What may be said when the search was stopped: that it was not finished, and nothing of causes.
pub fn interrupted(selection: &Selection) -> Decision {
    Decision::nothing(Verdict::Undecided, selection.base)
}

/// Share of the misfit that the best model removes: what it explains, in units of the noise variance, over that and what the tests still find.
///
/// Parameters pushed away from what is known of them are misfit too, which is why the fall of the whole objective counts and not that of the residual.
pub(crate) fn removed_by(explained: f64, after: &Adequacy) -> f64 {
    share(explained, after.left())
}

/// What is explained over that and what is left; 1 where there is neither.
fn share(explained: f64, left: f64) -> f64 {
    let explained = explained.max(0.0);
    if explained + left > 0.0 { explained / (explained + left) } else { 1.0 }
}

/// Share of the misfit that effects with an equation remove of what those without one leave; 1 where all have one.
fn removed_by_equations(selection: &Selection, best: usize, after: &Adequacy, free_form: impl Fn(usize) -> bool) -> f64 {
    let model = &selection.models[best];
    let free: Vec<usize> = model.effects.iter().copied().filter(|e| free_form(*e)).collect();
    if free.is_empty() {
        return 1.0;
    }
    let without = selection.with(&free).unwrap_or(selection.base());
    removed_by(2.0 * (without.fit.objective() - model.fit.objective()), after)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn explained() -> Decision {
        Decision { verdict: Verdict::Explained, model: 3, sets: vec![vec![7]], ..Decision::nothing(Verdict::Explained, 0) }
    }

    /// An effect that takes 30 units of a recording with a burst of 360 is a small part of what is there; one that takes 3000 is not.
    #[test]
    fn interference_unseats_an_effect_that_explains_less_of_the_recording() {
        let small = explained().with_interference(0, 30.0, 360.0);
        assert_eq!((small.verdict, small.model, small.sets.len()), (Verdict::Unexplained, 0, 0));
        let large = explained().with_interference(0, 3000.0, 360.0);
        assert_eq!((large.verdict, large.model), (Verdict::Explained, 3));
        assert_eq!(Decision::nothing(Verdict::Agrees, 0).with_interference(0, 0.0, 1.0).verdict, Verdict::Unexplained);
        assert_eq!(Decision::nothing(Verdict::Undecided, 0).with_interference(0, 0.0, 99.0).verdict, Verdict::Undecided);
    }

    /// A curve stands for 93 or 99.5 % of what is removed, and beside it a lag with a rival is carried: nothing is open, and whether the curve explains all that counts is its share's matter.
    #[test]
    fn what_is_carried_leaves_nothing_open() {
        let both = || Decision { verdict: Verdict::Ambiguous, sets: vec![vec![7], vec![1, 2]], removed: 0.999, ..explained() };
        let of = |share| both().carrying((vec![1], share), &[7, 1], &left(0.0));
        assert_eq!((of(0.93).verdict, of(0.995).verdict), (Verdict::WrongForm, Verdict::Explained));
        assert_eq!(of(0.93).carried, [1]);
        let rivals = both().carrying((vec![7], 0.995), &[7, 1], &left(0.0));
        assert_eq!(rivals.verdict, Verdict::Ambiguous);
        assert_eq!(both().carrying((Vec::new(), 1.0), &[7, 1], &left(0.0)).verdict, Verdict::Ambiguous);
    }

    #[test]
    fn a_rival_joins_the_set_of_its_effect() {
        let two = explained().with_rival((7, 2));
        assert_eq!((two.verdict, &two.sets), (Verdict::Ambiguous, &vec![vec![7, 2]]));
        assert_eq!(two.with_rival((7, 2)).sets, [[7, 2]]);
        assert_eq!(explained().with_rival((5, 2)).verdict, Verdict::Explained);
    }

    use crate::{
        fit::{model::Kinds, optimum::finish, score_test::JointTest},
        selection::{candidates::Tried, model_space::EvidenceCheck},
    };
    use nalgebra::DMatrix;

    /// What is left over of a model: nothing, or `excess` above twelve degrees of freedom.
    fn left(excess: f64) -> Adequacy {
        let smooth = JointTest { statistic: 12.0 + excess, freedom: 12, p_value: if excess > 0.0 { 1e-9 } else { 0.5 } };
        Adequacy {
            smooth,
            stretches: JointTest { statistic: 0.0, freedom: 0, p_value: 1.0 },
            line_p_value: 1.0,
            line_at: (0, 0.0),
            left_over_noise: 1.0,
        }
    }

    /// Models with their effects and probabilities; each effect takes 1000 units of a misfit of `misfit`.
    fn selection(misfit: f64, models: &[(&[usize], f64)]) -> Selection {
        let tried = |effects: &[usize]| {
            let left: f64 = (misfit - 1000.0 * effects.len() as f64).max(0.0);
            let count = 1 + effects.len();
            let free = vec![(f64::NEG_INFINITY, f64::INFINITY); count];
            let fit = finish(vec![0.0; count], vec![left.sqrt()], DMatrix::zeros(1, count), &free, Kinds::default(), (1, true));
            Tried { effects: effects.to_vec(), fit }
        };
        let of = |effect: usize| models.iter().filter(|(e, _)| e.contains(&effect)).map(|(_, p)| p).sum();
        Selection {
            models: models.iter().map(|(effects, _)| tried(effects)).collect(),
            probability: models.iter().map(|(_, p)| *p).collect(),
            effect_probability: (0..3).map(of).collect(),
            temper: 1.0,
            base: models.iter().position(|(e, _)| e.is_empty()).unwrap(),
            check: EvidenceCheck::default(),
            unmodelled: Vec::new(),
        }
    }

    fn decided(models: &[(&[usize], f64)], before: f64, after: f64) -> Decision {
        decide(&selection(2000.0, models), &left(before), &left(after), |_| false)
    }

    #[test]
    fn what_is_not_detected_is_not_named() {
        assert_eq!(decided(&[(&[], 0.5), (&[0], 0.5)], 0.0, 0.0).verdict, Verdict::Agrees);
        assert_eq!(decided(&[(&[0], 0.8), (&[], 0.2)], 0.0, 0.0).verdict, Verdict::Undecided);
        assert_eq!(decided(&[(&[0], 0.8), (&[], 0.2)], 90.0, 0.0).verdict, Verdict::Unexplained);
        assert_eq!(decided(&[(&[0], 0.97), (&[], 0.03)], 0.0, 0.0).verdict, Verdict::Explained);
    }

    #[test]
    fn a_rival_within_twenty_makes_it_ambiguous() {
        let near = decided(&[(&[0], 0.92), (&[1], 0.07), (&[], 0.01)], 0.0, 0.0);
        assert_eq!((near.verdict, near.sets), (Verdict::Ambiguous, vec![vec![0, 1]]));
        let far = decided(&[(&[0], 0.96), (&[1], 0.03), (&[], 0.01)], 0.0, 0.0);
        assert_eq!((far.verdict, far.sets), (Verdict::Explained, vec![vec![0]]));
    }

    /// One effect takes 1000 of 2000 units; what the tests find beside it is a share of 1 %, 23 % or 33 % of that and it.
    #[test]
    fn what_is_left_decides_on_the_form() {
        let one: &[(&[usize], f64)] = &[(&[0], 0.99), (&[], 0.01)];
        assert_eq!(decided(one, 0.0, 5.0).verdict, Verdict::Explained);
        let wrong = decided(one, 0.0, 300.0);
        assert_eq!(wrong.verdict, Verdict::WrongForm);
        approx::assert_relative_eq!(wrong.removed, 1000.0 / 1300.0, max_relative = 1e-12);
        assert_eq!(decided(one, 0.0, 500.0).verdict, Verdict::Unexplained);
    }

    /// A slow response, or a drift with a relaxation: what is missing is one or the other two.
    #[test]
    fn two_effects_together_may_stand_in_the_place_of_one() {
        let one_or_two = decided(&[(&[0], 0.6), (&[1, 2], 0.4), (&[], 0.0)], 90.0, 0.0);
        assert_eq!((one_or_two.verdict, one_or_two.sets), (Verdict::Ambiguous, vec![vec![0, 1, 2]]));
    }

    /// The first effect has a rival in its place, the second is rather not there: it is not told beside the two.
    #[test]
    fn an_effect_that_is_rather_not_there_is_not_told_beside_rivals() {
        let models: &[(&[usize], f64)] = &[(&[0, 2], 0.34), (&[0], 0.3), (&[1], 0.3), (&[1, 2], 0.06), (&[], 0.0)];
        let found = decided(models, 90.0, 0.0);
        assert_eq!((found.verdict, found.sets), (Verdict::Ambiguous, vec![vec![0, 1]]));
    }

    /// All but 0.5 % of a misfit is removed, and what is left stands a hundred times out of the noise: there is more to be found.
    #[test]
    fn a_loud_rest_is_no_adequate_equation() {
        let one: &[(&[usize], f64)] = &[(&[0], 0.99), (&[], 0.01)];
        let decided =
            |left_over_noise| decide(&selection(2000.0, one), &left(0.0), &Adequacy { left_over_noise, ..left(5.0) }, |_| false);
        assert_eq!(decided(3.0).verdict, Verdict::Explained);
        assert_eq!(decided(100.0).verdict, Verdict::WrongForm);
    }

    /// The likeliest model holds an effect that is not sure and has no rival: the smaller one is stated.
    #[test]
    fn an_effect_that_is_not_sure_is_left_out_of_what_is_stated() {
        let two: &[(&[usize], f64)] = &[(&[0, 1], 0.6), (&[0], 0.39), (&[], 0.01)];
        let found = decided(two, 0.0, 0.0);
        assert_eq!((found.verdict, found.sets, found.model), (Verdict::Explained, vec![vec![0]], 1));
    }

    /// A curve is sure, and beside it one of two or both; the curve alone is excluded. It is not stated for want of a sure second one: the likeliest of the two stands, with the other as rival.
    #[test]
    fn what_the_evidence_excludes_is_not_stated_for_want_of_a_sure_name() {
        let open: &[(&[usize], f64)] = &[(&[0, 1, 2], 0.45), (&[0, 1], 0.42), (&[0, 2], 0.13), (&[0], 0.0), (&[], 0.0)];
        let found = decided(open, 0.0, 0.0);
        assert_eq!((found.verdict, found.model, found.sets), (Verdict::Ambiguous, 1, vec![vec![0], vec![1, 2]]));
    }

    /// Two effects were stood behind; the second is not claimed any more. What is left decides on the form as before, and a set stays with its effect.
    #[test]
    fn a_smaller_model_takes_over_with_its_own_sets_and_form() {
        let models: &[(&[usize], f64)] = &[(&[0, 1], 0.99), (&[0], 0.005), (&[], 0.005)];
        let selection = selection(3000.0, models);
        let fuller =
            Decision { verdict: Verdict::Explained, sets: vec![vec![0], vec![1, 2]], ..Decision::nothing(Verdict::Explained, 0) };
        let of = |excess: f64| stepped_back(&selection, &fuller, 1, &left(excess));
        assert_eq!((of(0.0).verdict, of(0.0).model, of(0.0).sets), (Verdict::Explained, 1, vec![vec![0]]));
        assert_eq!(of(300.0).verdict, Verdict::WrongForm);
        let little = of(5000.0);
        assert_eq!((little.verdict, little.model), (Verdict::Unexplained, 2));
        let other = Decision { sets: vec![vec![0, 2], vec![1]], ..fuller.clone() };
        assert_eq!(stepped_back(&selection, &other, 1, &left(0.0)).verdict, Verdict::Ambiguous);
    }
}
