//! From fits to probabilities: a prior that pays for multiplicity, and tempering for the error of every equation.
//!
//! Limits: models that were not tried have probability 0.

use crate::{
    adequacy::lack_of_fit::LackOfFitTests,
    effects::effect::Effect,
    selection::tuning::{LARGEST_GAIN, NEGLIGIBLE, RIVAL, UNMODELLED_PRIOR},
    selection::{
        candidates::{Search, Tried},
        effect_set::EffectSet,
        model_space::{EvidenceCheck, ModelSpace},
        prior::{log_prior, one_more, weight},
        tempering::{least, temper_of},
        unmodelled::{Causes, Unmodelled},
    },
    stats::log_sum_exp,
};

/// All models tried, with probabilities.
#[derive(Clone)]
pub struct Selection {
    /// models, likeliest first
    pub models: Vec<Tried>,
    /// probability of each
    pub probability: Vec<f64>,
    /// probability of each effect of the library to belong to the model
    pub effect_probability: Vec<f64>,
    /// divisor of log evidence
    pub temper: f64,
    /// index of the base model in `models`
    pub base: usize,
    /// how Laplace's approximation fared near the top
    pub check: EvidenceCheck,
    /// causes outside the library beside models of it, likeliest first, with their odds against all of `models` together
    pub unmodelled: Vec<(Unmodelled, f64)>,
}

impl Selection {
    /// The likeliest model.
    pub fn best(&self) -> &Tried {
        &self.models[0]
    }

    /// The base model.
    pub fn base(&self) -> &Tried {
        &self.models[self.base]
    }

    /// Where the model of these effects stands; the base model where none does.
    pub fn place_of(&self, effects: EffectSet) -> usize {
        self.models.iter().position(|m| m.key() == effects).unwrap_or(self.base)
    }

    /// The model that leaves least, its parameters' distance from what is known of them counted.
    pub fn least(&self) -> Option<&Tried> {
        least(self.models.iter())
    }

    /// Index of the likeliest model that names something; `None` where nothing was fitted.
    pub fn likeliest_named(&self) -> Option<usize> {
        self.models.iter().position(|m| !m.effects.is_empty())
    }

    /// Probability that nothing is missing, among the models of the library; a verdict weighs it against odds of causes outside it.
    pub fn probability_none(&self) -> f64 {
        self.probability[self.base]
    }

    /// Probability that nothing is missing, causes outside the library counted, on the scale of [`Selection::effect_probability`].
    pub fn probability_agrees(&self) -> f64 {
        self.probability_none() / self.whole()
    }

    /// Sets causes outside the library beside the models; the probabilities of effects then leave room for them.
    ///
    /// Where the noise may have `slack` times the variance that was taken, the evidence of both sides is worth that much less.
    #[must_use]
    pub fn with_unmodelled(mut self, causes: &Causes, library: &[&dyn Effect], slack: f64) -> Self {
        let temper = self.temper * slack;
        // what is outside pays for its freedom in full, and so does what is inside without an equation
        let library_size = self.effect_probability.len();
        let weight = |m: &Tried| m.fit.tempered(temper) + log_prior(m.effects.len(), library_size);
        let total = log_sum_exp(&self.models.iter().map(weight).collect::<Vec<_>>());
        let found = causes.beside(&self.models, library, weight, temper);
        self.unmodelled = found
            .into_iter()
            .map(|u| {
                let odds = (u.weight - total).min(LARGEST_GAIN).exp();
                (u, odds)
            })
            .collect();
        self.sorted()
    }

    /// Log odds of one thing more beside model `beside` against all of `models` and all unmodelled causes together, where it adds `gain` to the log evidence, that
    /// divided as the models' own; such a thing is as likely beforehand as an unmodelled cause. Models that are not a `rival` do not count.
    pub fn log_odds_beside(&self, beside: &Tried, gain: f64, slack: f64, rival: impl Fn(&Tried) -> bool) -> f64 {
        let temper = self.temper * slack;
        let library_size = self.effect_probability.len();
        let weight = |m: &Tried| m.fit.tempered(temper) + log_prior(m.effects.len(), library_size);
        let models = self.models.iter().filter(|m| rival(m)).map(weight);
        let all: Vec<f64> = models.chain(self.unmodelled.iter().map(|(u, _)| u.weight)).collect();
        weight(beside) + one_more(beside.effects.len()) + UNMODELLED_PRIOR.ln() + gain - log_sum_exp(&all)
    }

    /// The same with all probability on the base model.
    #[must_use]
    pub fn base_alone(mut self) -> Self {
        let base = self.base;
        self.probability.iter_mut().enumerate().for_each(|(i, p)| *p = if i == base { 1.0 } else { 0.0 });
        self.unmodelled.clear();
        self.sorted()
    }

    /// The same where rows left out contradict all of the library's answer: all probability on the base model, and nothing from behind the `library` effects.
    #[must_use]
    pub fn refuted(mut self, library: usize) -> Self {
        self.keep_the_library(library);
        self.base = self.models.iter().position(|m| m.effects.is_empty()).unwrap_or(0);
        self.base_alone()
    }

    /// Drops models that hold effects from behind the `library` ones.
    fn keep_the_library(&mut self, library: usize) {
        let inside: Vec<bool> = self.models.iter().map(|m| m.effects.iter().all(|e| *e < library)).collect();
        let mut kept = inside.iter().copied();
        self.models.retain(|_| kept.next().unwrap_or(true));
        let mut kept = inside.iter().copied();
        self.probability.retain(|_| kept.next().unwrap_or(true));
        self.effect_probability.truncate(library);
    }

    /// The same with all that is left of probability shared as before.
    fn shared(mut self) -> Self {
        let total: f64 = self.probability.iter().sum();
        self.probability.iter_mut().for_each(|p| *p /= total);
        self.sorted()
    }

    /// The same without probability for the models that hold all of the `refuted` effects, and without those from behind the `library` effects; `None` where what is left was no rival of those.
    #[must_use]
    pub fn without_holders_of(mut self, refuted: &[usize], library: usize) -> Option<Self> {
        self.keep_the_library(library);
        let holds = |m: &Tried| refuted.iter().all(|e| m.effects.contains(e));
        let (mut gone, mut left) = (0.0, 0.0);
        for (m, p) in self.models.iter().zip(&mut self.probability) {
            if holds(m) {
                gone += std::mem::take(p);
            } else if !m.effects.is_empty() {
                left += *p;
            }
        }
        self.unmodelled.clear();
        (left > RIVAL * gone).then(|| self.shared())
    }

    /// The same without models that hold effects from behind the `library` ones, and room for `more` of those.
    #[must_use]
    pub fn of_the_library(mut self, library: usize, more: usize) -> Self {
        self.keep_the_library(library);
        self.effect_probability.extend(std::iter::repeat_n(0.0, more));
        self.shared()
    }

    /// The same with one more model, `log_odds` against everything else together, that holds `more` effects from behind the library.
    #[must_use]
    pub fn with_model(mut self, tried: Tried, log_odds: f64, more: usize) -> Self {
        let (share, others) = (1.0 / (1.0 + (-log_odds).exp()), 1.0 / (1.0 + log_odds.exp()));
        let whole = self.whole();
        // what all models together have, the new one among them; unmodelled causes are odds against that
        let inside = share + others / whole;
        self.probability.iter_mut().for_each(|p| *p *= others / whole / inside);
        self.unmodelled.iter_mut().for_each(|(_, o)| *o *= others / whole / inside);
        self.models.push(tried);
        self.probability.push(share / inside);
        self.effect_probability.extend(std::iter::repeat_n(0.0, more));
        self.sorted()
    }

    /// The same with what model `place` has of probability given to `named`, which says the same with the effects of the library.
    #[must_use]
    pub fn told_as(mut self, place: usize, named: Tried) -> Self {
        let (key, share) = (named.key(), std::mem::take(&mut self.probability[place]));
        match self.models.iter().position(|m| m.key() == key) {
            Some(known) => {
                self.probability[known] += share;
                self.models[known] = named;
            }
            None => {
                self.probability.push(share);
                self.models.push(named);
            }
        }
        self.sorted()
    }

    /// What weights against all of `models` together are divided by to make probabilities that leave room for causes outside the library.
    fn whole(&self) -> f64 {
        1.0 + self.unmodelled.iter().map(|(_, odds)| odds).sum::<f64>()
    }

    /// Causes outside the library with the probability of each, likeliest first.
    pub fn unmodelled_probabilities(&self) -> impl Iterator<Item = (&Unmodelled, f64)> {
        let whole = self.whole();
        self.unmodelled.iter().map(move |(cause, odds)| (cause, odds / whole))
    }

    /// Probability that a cause outside the library acts.
    pub fn probability_unmodelled(&self) -> f64 {
        self.unmodelled_probabilities().map(|(_, p)| p).sum()
    }

    /// The likeliest cause outside the library, where it is likelier than all of the library together.
    pub fn likelier_than_the_library(&self) -> Option<&Unmodelled> {
        self.unmodelled.first().filter(|(_, odds)| *odds > 1.0).map(|(u, _)| u)
    }

    /// Counts each likely model for the simpler one that says as much, while there is one: without its least visible effect, where that cannot be seen in the fit, or with a simpler law.
    ///
    /// `simpler` has the effects of such models, the first that was tried counts. One effect is changed at a time: two that can stand in for one another are each invisible beside the other, and together they are not nothing.
    #[must_use]
    pub fn merged(mut self, simpler: impl Fn(&[Tried], &Tried) -> Vec<EffectSet>) -> Self {
        let keys: Vec<EffectSet> = self.models.iter().map(Tried::key).collect();
        let largest = keys.iter().map(|key| key.len()).max().unwrap_or(0);
        for size in (1..=largest).rev() {
            for index in 0..self.models.len() {
                if keys[index].len() != size || self.probability[index] < NEGLIGIBLE {
                    continue;
                }
                let simpler = simpler(&self.models, &self.models[index]);
                // where no simpler model was tried, nothing is known of it
                let Some(target) = simpler.iter().find_map(|key| keys.iter().position(|k| k == key)) else { continue };
                self.probability[target] += self.probability[index];
                self.probability[index] = 0.0;
            }
        }
        self.sorted()
    }

    /// The same models with the probabilities raised to a power: above 1 they were too modest, below 1 too bold (see [`crate::validation::recovery`]).
    #[must_use]
    pub fn sharpened(mut self, power: f64) -> Self {
        // in logarithms: a power of odds that stand for certainty is larger than any number
        let raised: Vec<f64> = self.probability.iter().map(|p| power * p.ln()).collect();
        let total = log_sum_exp(&raised);
        self.probability.iter_mut().zip(raised).for_each(|(p, raised)| *p = (raised - total).exp());
        self.unmodelled.iter_mut().for_each(|(_, odds)| *odds = (power * odds.ln() - total).min(LARGEST_GAIN).exp());
        self.sorted()
    }

    /// Likeliest first, with the probabilities of the effects added up again.
    fn sorted(mut self) -> Self {
        let mut order: Vec<usize> = (0..self.models.len()).collect();
        order.sort_by(|a, b| self.probability[*b].total_cmp(&self.probability[*a]));
        self.models = order.iter().map(|i| self.models[*i].clone()).collect();
        self.probability = order.iter().map(|i| self.probability[*i]).collect();
        self.base = self.models.iter().position(|m| m.effects.is_empty()).unwrap_or(0);
        self.unmodelled.sort_by(|a, b| b.1.total_cmp(&a.1));
        self.effect_probability = self.of_effects();
        self
    }

    /// Probability of each effect to belong to the model, causes outside the library beside it or not.
    fn of_effects(&self) -> Vec<f64> {
        let mut sums = vec![0.0; self.effect_probability.len()];
        let inside = self.models.iter().map(|m| m.effects.as_slice()).zip(&self.probability);
        let unmodelled = self.unmodelled.iter().map(|(u, odds)| (&*u.effects, odds));
        inside.chain(unmodelled).for_each(|(effects, p)| effects.iter().for_each(|e| sums[*e] += p));
        let whole = self.whole();
        // rounding of many small terms
        sums.iter_mut().for_each(|p| *p = (*p / whole).min(1.0));
        sums
    }

    /// The model with exactly these effects.
    pub fn with(&self, effects: &[usize]) -> Option<&Tried> {
        let key = EffectSet::from(effects);
        self.models.iter().find(|m| m.key() == key)
    }
}

/// Fits the model space and weighs all of them.
pub fn select(search: &Search<'_>, lack_of_fit: &LackOfFitTests, base: Tried) -> Selection {
    let mut space = ModelSpace::all(search, lack_of_fit, base);
    let check = space.check();
    let mut models = space.into_models();
    models.retain(|m| is_whole(search, m));
    Selection { check, ..weigh(models, &search.library, lack_of_fit) }
}

/// Whether every effect that changes another one has that beside it, where the library holds it.
pub(crate) fn is_whole(search: &Search<'_>, model: &Tried) -> bool {
    let is = |e: &usize, id: &str| search.library[*e].id().0 == id;
    let held = |id: &str| !(0..search.library.len()).any(|e| is(&e, id)) || model.effects.iter().any(|e| is(e, id));
    model.effects.iter().filter_map(|e| search.library[*e].beside(search.context)).all(held)
}

fn weigh(mut models: Vec<Tried>, library: &[&dyn Effect], lack_of_fit: &LackOfFitTests) -> Selection {
    let temper = temper_of(models.iter(), library, lack_of_fit);
    let weight = weight(temper, library.len());
    models.sort_by(|a, b| weight(b).total_cmp(&weight(a)));
    let weights: Vec<f64> = models.iter().map(weight).collect();
    let total = log_sum_exp(&weights);
    let probability: Vec<f64> = weights.iter().map(|w| (w - total).exp()).collect();
    let (effect_probability, check) = (vec![0.0; library.len()], EvidenceCheck::default());
    Selection { models, probability, effect_probability, temper, base: 0, check, unmodelled: Vec::new() }.sorted()
}

#[cfg(test)]
impl Selection {
    /// Models that leave nothing, by their effects, with their probabilities; the first is the base model.
    pub(crate) fn of(models: &[(&[usize], f64)]) -> Self {
        let effects = models.iter().flat_map(|(effects, _)| *effects).max().map_or(0, |last| last + 1);
        Self {
            models: models.iter().map(|(effects, _)| Tried::leaving(vec![0.0; 3], effects)).collect(),
            probability: models.iter().map(|(_, p)| *p).collect(),
            effect_probability: vec![0.0; effects],
            temper: 1.0,
            base: 0,
            check: EvidenceCheck::default(),
            unmodelled: Vec::new(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::selection::unmodelled::Cause;

    fn tried(effects: &[usize]) -> Tried {
        Tried::leaving(vec![0.0; 3], effects)
    }

    fn selection(odds: f64) -> Selection {
        let wanders =
            Unmodelled { cause: Cause::WanderingZero, effects: EffectSet::from(&[][..]), weight: 0.0, gain: 0.0, row: None };
        Selection {
            models: vec![tried(&[]), tried(&[0])],
            probability: vec![0.2, 0.8],
            effect_probability: vec![0.8],
            temper: 1.0,
            base: 0,
            check: EvidenceCheck::default(),
            unmodelled: vec![(wanders, odds)],
        }
    }

    /// Odds of 3 against everything are a probability of 3/4, whatever an unmodelled cause has, and the rest keeps its shares; odds beyond any number are certainty.
    #[test]
    fn one_more_model_has_the_probability_of_its_odds() {
        for odds in [0.0, 1.0, 1e200] {
            let with = selection(odds).with_model(tried(&[1]), 3f64.ln(), 1);
            approx::assert_relative_eq!(with.effect_probability[1], 0.75, max_relative = 1e-12);
            approx::assert_relative_eq!(with.effect_probability[0], 0.25 * 0.8 / (1.0 + odds), max_relative = 1e-9);
            approx::assert_relative_eq!(with.probability_unmodelled(), 0.25 * odds / (1.0 + odds), max_relative = 1e-9);
            let certain = selection(odds).with_model(tried(&[1]), 5e4, 1);
            approx::assert_relative_eq!(certain.effect_probability[1], 1.0);
        }
    }

    /// Three models of 0.2, 0.5 and 0.3; the largest holds an effect that cannot be seen.
    fn three() -> Selection {
        Selection {
            models: vec![tried(&[0]), tried(&[0, 1]), tried(&[])],
            probability: vec![0.5, 0.3, 0.2],
            effect_probability: vec![0.0; 2],
            base: 2,
            unmodelled: Vec::new(),
            ..selection(0.0)
        }
    }

    #[test]
    fn what_cannot_be_seen_counts_for_the_model_without_it() {
        let merged = three().merged(|_, tried| tried.effects.contains(&1).then(|| tried.key().without(1)).into_iter().collect());
        approx::assert_relative_eq!(merged.effect_probability[0], 0.8, max_relative = 1e-12);
        assert_eq!(merged.effect_probability[1], 0.0);
        approx::assert_relative_eq!(merged.probability.iter().sum::<f64>(), 1.0, max_relative = 1e-12);
    }

    /// A mechanism of 0.3 and an effect of 0.5 that say the same have 0.8 together under the effect's name, whether its model was fitted before or not.
    #[test]
    fn what_is_told_by_a_name_keeps_its_probability() {
        let known = three().told_as(1, tried(&[0]));
        assert_eq!((known.models.len(), known.models[0].effects.as_slice()), (3, &[0][..]));
        approx::assert_relative_eq!(known.probability[0], 0.8, max_relative = 1e-12);
        let new = selection(0.0).with_model(tried(&[1]), 3f64.ln(), 1).told_as(0, tried(&[0, 1]));
        approx::assert_relative_eq!(new.probability.iter().sum::<f64>(), 1.0, max_relative = 1e-12);
        approx::assert_relative_eq!(new.probability[0], 0.75, max_relative = 1e-12);
        assert_eq!(new.models[0].effects, [0, 1]);
    }

    /// Squares of 0.5, 0.3 and 0.2 over their sum, 0.38.
    #[test]
    fn sharpened_probabilities_are_powers_over_their_sum() {
        let sharp = three().sharpened(2.0);
        approx::assert_relative_eq!(
            sharp.probability.as_slice(),
            [0.25 / 0.38, 0.09 / 0.38, 0.04 / 0.38].as_slice(),
            max_relative = 1e-12
        );
        approx::assert_relative_eq!(sharp.probability_none(), 0.04 / 0.38, max_relative = 1e-12);
        let beside = selection(0.5).sharpened(2.0);
        // 0.2, 0.8 and odds of 0.5: squares 0.04, 0.64, 0.25
        approx::assert_relative_eq!(beside.probability_unmodelled(), 0.25 / 0.93, max_relative = 1e-12);
    }

    /// Odds that stand for certainty do so at any power, and leave nothing to what the library names.
    #[test]
    fn certainty_stays_certainty_at_every_power() {
        for power in [0.25, 1.0, 4.06] {
            let certain = selection(LARGEST_GAIN.exp()).sharpened(power);
            approx::assert_relative_eq!(certain.probability_unmodelled(), 1.0, max_relative = 1e-12);
            assert!(certain.effect_probability[0] < 1e-9, "{:?}", certain.effect_probability);
        }
        let nothing = selection(0.0).sharpened(4.06);
        assert_eq!(nothing.probability_unmodelled(), 0.0);
    }

    /// Of 0.2, 0.5 and 0.3 the models that hold effect 0 are gone: the base model is alone, and no rival is left. Without those that hold effects 0 and 1, 0.2 and 0.5 are left of 0.7.
    #[test]
    fn without_what_rows_left_out_refute_rivals_keep_their_shares() {
        assert!(three().without_holders_of(&[0], 2).is_none());
        let left = three().without_holders_of(&[0, 1], 2).unwrap();
        approx::assert_relative_eq!(left.effect_probability[0], 0.5 / 0.7, max_relative = 1e-12);
        assert_eq!((left.effect_probability[1], left.models.len()), (0.0, 3));
        // a rival of a thousandth is none
        let sure = Selection { probability: vec![0.001, 0.998, 0.001], ..three() };
        assert!(sure.without_holders_of(&[0, 1], 2).is_none());
    }

    /// A model from behind one effect of the library gives its share back, and room is made for two others.
    #[test]
    fn mechanisms_make_room_for_others() {
        let left = three().of_the_library(1, 2);
        assert_eq!((left.models.len(), left.effect_probability.len()), (2, 3));
        approx::assert_relative_eq!(left.effect_probability[0], 0.5 / 0.7, max_relative = 1e-12);
    }

    /// A library that rows left out contradict has no probability left, and neither has what was composed beside it.
    #[test]
    fn what_is_refuted_leaves_the_base_model_alone() {
        let whole = selection(0.5).with_model(tried(&[1]), 2.0, 1);
        let alone = whole.refuted(1);
        assert_eq!(alone.models.len(), 2);
        assert_eq!((alone.base, alone.probability_none()), (0, 1.0));
        assert_eq!(alone.effect_probability, [0.0]);
        assert_eq!(alone.probability_unmodelled(), 0.0);
    }
}
