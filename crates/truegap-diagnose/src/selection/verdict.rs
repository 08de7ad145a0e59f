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
    /// share of what the model removes that those stand for whose names are claimed
    pub claimed: f64,
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

    /// Each named effect with each of its rivals, where the recording leaves these open.
    pub(crate) fn rivals(&self) -> impl Iterator<Item = (usize, usize)> + '_ {
        let open = self.verdict == Verdict::Ambiguous;
        self.sets.iter().filter(move |_| open).flat_map(|set| set.iter().skip(1).map(|rival| (set[0], *rival)))
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
    /// there is to explain only where that is as much as an adequate equation removes, or where they leave next to what the model leaves, in which tests see nothing (`near`); `after` is what the model leaves.
    #[must_use]
    pub(crate) fn carrying(self, (carried, share, near): (Vec<usize>, f64, bool), effects: &[usize], after: &Adequacy) -> Self {
        if carried.is_empty() {
            return self;
        }
        let claimed = effects.iter().zip(&self.sets).filter(|(effect, _)| !carried.contains(effect)).map(|(_, set)| set);
        let verdict = match Self::of_sets(claimed, self.removed, after) {
            _ if self.unmodelled_rivals => Verdict::Ambiguous,
            Verdict::Explained if share < ADEQUATE && !near => Verdict::WrongForm,
            verdict => verdict,
        };
        Self { verdict, carried, claimed: share.clamp(0.0, 1.0), ..self }
    }

    /// The verdict on a model whose effects have these rivals, that removes this share of the misfit: what is open comes before what is not adequate.
    pub(crate) fn of_sets<'s>(mut sets: impl Iterator<Item = &'s Vec<usize>>, removed: f64, after: &Adequacy) -> Verdict {
        match sets.any(|set| set.len() > 1) {
            true => Verdict::Ambiguous,
            false if Self::adequate(removed, after) => Verdict::Explained,
            false => Verdict::WrongForm,
        }
    }

    /// For each effect of another model the set of rivals in which it stands beside `own`, the effects that this was decided for; itself alone where it is new.
    pub(crate) fn sets_of(&self, own: &[usize], effects: &[usize]) -> Vec<Vec<usize>> {
        let known = |effect| own.iter().position(|e| e == effect).and_then(|place| self.sets.get(place));
        effects.iter().map(|effect| known(effect).cloned().unwrap_or_else(|| vec![*effect])).collect()
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
            claimed: 1.0,
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
    let removed = removed_by(selection.models[best].fit.explains_beyond(&selection.base().fit), after);
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
    let sets = decision.sets_of(&fuller.effects, &smaller.effects);
    let removed = removed_by(smaller.fit.explains_beyond(&selection.base().fit), after);
    let verdict = match after.fires() {
        true if removed < RIGHT_FAMILY => return Decision { removed, ..Decision::nothing(Verdict::Unexplained, selection.base) },
        _ => Decision::of_sets(sets.iter(), removed, after),
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
    removed_by(model.fit.explains_beyond(&without.fit), after)
}

#[cfg(test)]
mod tests;
