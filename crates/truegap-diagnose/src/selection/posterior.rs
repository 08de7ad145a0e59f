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
        whole::whole,
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

    /// The `model` that is stood behind where it names something, else the likeliest that does.
    pub fn named_or_likeliest(&self, model: usize) -> Option<usize> {
        if self.models[model].effects.is_empty() { self.likeliest_named() } else { Some(model) }
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
    let models = space.into_models().into_iter().filter_map(|m| whole(search, m)).collect();
    Selection { check, ..weigh(models, &search.library, lack_of_fit) }
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
mod tests;
