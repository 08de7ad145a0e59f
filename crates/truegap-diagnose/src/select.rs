//! From fits to probabilities: a prior that pays for multiplicity, and tempering for the error of every equation.
//!
//! Limits: models that were not tried have probability 0.

use crate::{
    effect::Effect,
    evidence::log_sum_exp,
    gate::Gate,
    importance::{Sampled, sampled},
    search::{Progress, Search, Tried},
    unlisted::{Causes, Unlisted},
};
use rayon::prelude::*;
use std::{
    collections::{BTreeMap, BTreeSet},
    sync::atomic::{AtomicUsize, Ordering},
};

/// Prior probabilities of 0, 1, 2 and 3 effects, shared evenly within each number.
const NUMBER_PRIOR: [f64; 4] = [0.5, 0.35, 0.12, 0.03];
/// Relative error that even the right physics has when written with the wrong equation (sibling forms; see `docs/diagnosis.md`).
pub const FORM_ERROR: f64 = 0.2;
/// Partners that are fitted at each step, those that promise most.
const PARTNERS: usize = 6;
/// Probability below which a model is not looked at more closely.
const NEGLIGIBLE: f64 = 1e-4;
/// Log odds that are large enough to stand for certainty.
const LARGEST: f64 = 500.0;
/// Number of independent shapes over which that error spreads.
const FORM_SHAPES: f64 = 10.0;

/// All models tried, with probabilities.
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
    pub unlisted: Vec<(Unlisted, f64)>,
}

/// Laplace's approximation against importance sampling.
#[derive(Clone, Copy, Debug, Default, PartialEq, serde::Serialize)]
pub struct EvidenceCheck {
    /// models sampled
    pub models: usize,
    /// models whose evidence is the sampled one; the others had too few effective draws
    pub replaced: usize,
    /// largest change of log evidence among those replaced
    pub largest_change: f64,
    /// effective share of the draws: smallest and greatest over the models sampled
    pub effective_share: [f64; 2],
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

    /// The model that leaves least, its parameters' distance from what is known of them counted.
    pub fn least(&self) -> Option<&Tried> {
        least(self.models.iter())
    }

    /// Index of the likeliest model that names something; `None` where nothing was fitted.
    pub fn likeliest_named(&self) -> Option<usize> {
        self.models.iter().position(|m| !m.effects.is_empty())
    }

    /// Probability that nothing is missing.
    pub fn probability_none(&self) -> f64 {
        self.probability[self.base]
    }

    /// Sets causes outside the library beside the models; the probabilities of effects then leave room for them.
    ///
    /// Where the noise may have `slack` times the variance that was taken, the evidence of both sides is worth that much less.
    #[must_use]
    pub fn with_unlisted(mut self, causes: &Causes, library: &[&dyn Effect], slack: f64) -> Self {
        let temper = self.temper * slack;
        // what is outside pays for its freedom in full, and so does what is inside without an equation
        let library_size = self.effect_probability.len();
        let weight = |m: &Tried| m.fit.tempered(temper) + log_prior(m.effects.len(), library_size);
        let total = log_sum_exp(&self.models.iter().map(weight).collect::<Vec<_>>());
        let found = causes.beside(&self.models, library, weight, temper);
        self.unlisted = found
            .into_iter()
            .map(|u| {
                let odds = (u.weight - total).min(LARGEST).exp();
                (u, odds)
            })
            .collect();
        self.sorted()
    }

    /// What weights against all of `models` together are divided by to make probabilities that leave room for causes outside the library.
    fn whole(&self) -> f64 {
        1.0 + self.unlisted.iter().map(|(_, odds)| odds).sum::<f64>()
    }

    /// Causes outside the library with the probability of each, likeliest first.
    pub fn unlisted_probabilities(&self) -> impl Iterator<Item = (&Unlisted, f64)> {
        let whole = self.whole();
        self.unlisted.iter().map(move |(cause, odds)| (cause, odds / whole))
    }

    /// Probability that a cause outside the library acts.
    pub fn probability_unlisted(&self) -> f64 {
        self.unlisted_probabilities().map(|(_, p)| p).sum()
    }

    /// The likeliest cause outside the library, where it is likelier than all of the library together.
    pub fn outside(&self) -> Option<&Unlisted> {
        self.unlisted.first().filter(|(_, odds)| *odds > 1.0).map(|(u, _)| u)
    }

    /// Counts each likely model for the one without its least visible effect, while that cannot be seen in the fit: it is not claimed.
    ///
    /// `hidden` names the least visible effect of a model, where it does not stand above the noise. One effect is dropped at a time: two that can stand in
    /// for one another are each hidden by the other, and together they are not nothing.
    #[must_use]
    pub fn merged(mut self, hidden: impl Fn(&[Tried], &Tried) -> Option<usize>) -> Self {
        let keys: Vec<Vec<usize>> = self.models.iter().map(Tried::key).collect();
        let largest = keys.iter().map(Vec::len).max().unwrap_or(0);
        for size in (1..=largest).rev() {
            for index in 0..self.models.len() {
                if keys[index].len() != size || self.probability[index] < NEGLIGIBLE {
                    continue;
                }
                let Some(dropped) = hidden(&self.models, &self.models[index]) else { continue };
                let key: Vec<usize> = keys[index].iter().copied().filter(|e| *e != dropped).collect();
                // where the smaller model was not tried, nothing is known of it
                let Some(target) = keys.iter().position(|k| *k == key) else { continue };
                self.probability[target] += self.probability[index];
                self.probability[index] = 0.0;
            }
        }
        self.sorted()
    }

    /// The same models with the probabilities raised to a power: above 1 they were too modest, below 1 too bold (see [`crate::bank`]).
    #[must_use]
    pub fn sharpened(mut self, power: f64) -> Self {
        let total: f64 = self.probability.iter().map(|p| p.powf(power)).sum();
        self.probability.iter_mut().for_each(|p| *p = p.powf(power) / total);
        self.unlisted.iter_mut().for_each(|(_, odds)| *odds = odds.powf(power) / total);
        self.sorted()
    }

    /// Likeliest first, with the probabilities of the effects added up again.
    fn sorted(mut self) -> Self {
        let mut order: Vec<usize> = (0..self.models.len()).collect();
        order.sort_by(|a, b| self.probability[*b].total_cmp(&self.probability[*a]));
        self.models = order.iter().map(|i| self.models[*i].clone()).collect();
        self.probability = order.iter().map(|i| self.probability[*i]).collect();
        self.base = self.models.iter().position(|m| m.effects.is_empty()).unwrap_or(0);
        self.unlisted.sort_by(|a, b| b.1.total_cmp(&a.1));
        self.effect_probability = self.of_effects();
        self
    }

    /// Probability of each effect to belong to the model, causes outside the library beside it or not.
    fn of_effects(&self) -> Vec<f64> {
        let mut sums = vec![0.0; self.effect_probability.len()];
        let inside = self.models.iter().map(|m| &m.effects).zip(&self.probability);
        let outside = self.unlisted.iter().map(|(u, odds)| (&u.effects, odds));
        inside.chain(outside).for_each(|(effects, p)| effects.iter().for_each(|e| sums[*e] += p));
        let whole = self.whole();
        // rounding of many small terms
        sums.iter_mut().for_each(|p| *p = (*p / whole).min(1.0));
        sums
    }

    /// The model with exactly these effects.
    pub fn with(&self, effects: &[usize]) -> Option<&Tried> {
        let mut key = effects.to_vec();
        key.sort_unstable();
        self.models.iter().find(|m| m.key() == key)
    }
}

/// Log prior of a model with `count` of `library` effects.
fn log_prior(count: usize, library: usize) -> f64 {
    let combinations: f64 = (0..count).map(|i| (library.max(count) - i) as f64 / (i + 1) as f64).product();
    (NUMBER_PRIOR.get(count).copied().unwrap_or(0.0) / combinations).ln()
}

/// Log prior of one thing more beside `count` effects, over that of those alone; minus infinity where there are as many as there may be.
pub(crate) fn one_more(count: usize) -> f64 {
    let prior = |count: usize| NUMBER_PRIOR.get(count).copied().unwrap_or(0.0);
    (prior(count + 1) / prior(count)).ln()
}

/// Log posterior of a model, up to a constant: its log evidence over `temper`, and its log prior.
fn weight(temper: f64, library: usize) -> impl Fn(&Tried) -> f64 + Copy + Sync {
    move |m| m.fit.log_evidence / temper + log_prior(m.effects.len(), library)
}

/// Tries singles, forward steps with swaps, and pairs of the best; weighs all of them.
pub fn select(search: &Search<'_>, gate: &Gate, base: Tried) -> Selection {
    let all: Vec<usize> = (0..search.library.len()).collect();
    let mut tried: BTreeMap<Vec<usize>, Tried> = BTreeMap::new();
    let singles = search.add_each(&base, &all, all.len(), "one effect");
    let order = ranked(&singles);
    let gain = order.first().map_or(0.0, |i| singles[*i].fit.log_evidence - base.fit.log_evidence);
    keep(&mut tried, std::iter::once(base).chain(singles.iter().cloned()));
    if gain > CLEAR {
        let best: Vec<&Tried> = order.iter().take(6).map(|i| &singles[*i]).collect();
        pairs(search, gate, &best, &all, &mut tried);
        triples(search, gate, &all, &mut tried);
    }
    polish(search, gate, &mut tried);
    let check = check(search, gate, &mut tried);
    Selection { check, ..weigh(tried, &search.library, gate) }
}

/// Models that are sampled, those with the most weight, and the draws for each.
const SAMPLED: (usize, usize) = (8, 128);
/// Effective share of draws from which a sampled evidence stands in for Laplace's.
const ENOUGH: f64 = 0.1;

/// Replaces Laplace's evidence by a sampled one for the models with the most weight, and for the base model.
fn check(search: &Search<'_>, gate: &Gate, tried: &mut BTreeMap<Vec<usize>, Tried>) -> EvidenceCheck {
    let weight = weight(temper_of(tried.values(), &search.library, gate), search.library.len());
    let mut order: Vec<(Vec<usize>, f64)> = tried.iter().map(|(key, m)| (key.clone(), weight(m))).collect();
    order.sort_by(|a, b| b.1.total_cmp(&a.1));
    let best = order.first().map_or(0.0, |o| o.1);
    let near = |(place, (key, w)): &(usize, (Vec<usize>, f64))| key.is_empty() || (*place < SAMPLED.0 && *w > best - CLOSE);
    let keys: Vec<Vec<usize>> = order.into_iter().enumerate().filter(near).map(|(_, (key, _))| key).collect();
    let look = |key: &Vec<usize>| {
        let m = tried.get(key)?;
        let seed = key.iter().fold(0x7a11_u64, |seed, e| seed.wrapping_mul(31).wrapping_add(*e as u64 + 1));
        sampled(&search.model(&m.effects), search.whitener, &m.fit, SAMPLED.1, seed).map(|s| (key.clone(), s))
    };
    let stopped = || search.stop.load(Ordering::Relaxed);
    let found: Vec<(Vec<usize>, Sampled)> = keys.par_iter().filter(|_| !stopped()).filter_map(look).collect();
    let mut report = EvidenceCheck { models: found.len(), ..EvidenceCheck::default() };
    let shares = found.iter().map(|(_, s)| s.effective_share);
    report.effective_share = [shares.clone().fold(1.0, f64::min), shares.fold(0.0, f64::max)];
    for (key, sampled) in found.into_iter().filter(|(_, s)| s.effective_share > ENOUGH) {
        let Some(m) = tried.get_mut(&key) else { continue };
        report.replaced += 1;
        let log_evidence = sampled.log_evidence + m.fit.scale_gain;
        report.largest_change = report.largest_change.max((log_evidence - m.fit.log_evidence).abs());
        m.fit.log_evidence = log_evidence;
    }
    report
}

/// Fits to the end what could still matter; the search itself is content with rough fits.
fn polish(search: &Search<'_>, gate: &Gate, tried: &mut BTreeMap<Vec<usize>, Tried>) {
    let mut done: BTreeSet<Vec<usize>> = BTreeSet::from([Vec::new()]);
    loop {
        let weight = weight(temper_of(tried.values(), &search.library, gate), search.library.len());
        let best = tried.values().map(weight).fold(f64::NEG_INFINITY, f64::max);
        let near = |(key, m): &(&Vec<usize>, &Tried)| !done.contains(*key) && weight(m) > best - CLOSE;
        let rough: Vec<&Tried> = tried.iter().filter(near).map(|(_, m)| m).collect();
        if rough.is_empty() || search.stop.load(Ordering::Relaxed) {
            return;
        }
        done.extend(rough.iter().map(|m| m.key()));
        let count = rough.len() as f64;
        let finished = AtomicUsize::new(0);
        let better: Vec<Tried> = rough
            .par_iter()
            .filter_map(|m| {
                let polished = search.polished(m);
                let done = (finished.fetch_add(1, Ordering::Relaxed) + 1) as f64 / count;
                (search.progress)(Progress { step: "closer look", what: format!("{} models", rough.len()), done });
                polished
            })
            .collect();
        keep(tried, better);
    }
}

/// Gain in log evidence from which a larger model is worth looking for still larger ones.
const CLEAR: f64 = 3.0;
/// Difference in log weight beyond which a model is not looked at more closely.
const CLOSE: f64 = 12.0;

fn ranked(models: &[Tried]) -> Vec<usize> {
    let mut order: Vec<usize> = (0..models.len()).collect();
    order.sort_by(|a, b| models[*b].fit.log_evidence.total_cmp(&models[*a].fit.log_evidence));
    order
}

/// Keeps the better fit of models with the same effects.
fn keep(tried: &mut BTreeMap<Vec<usize>, Tried>, models: impl IntoIterator<Item = Tried>) {
    for model in models {
        let better = tried.get(&model.key()).is_none_or(|old| model.fit.log_evidence > old.fit.log_evidence);
        if better {
            tried.insert(model.key(), model);
        }
    }
}

/// The best single with every other effect, then the best partner with every other (a swap), then all pairs of the best six; no more than the first where the
/// best single leaves nothing and no partner gains anything.
fn pairs(search: &Search<'_>, gate: &Gate, best: &[&Tried], all: &[usize], tried: &mut BTreeMap<Vec<usize>, Tried>) {
    let Some(first) = best.first() else { return };
    let forward = search.add_each(first, all, PARTNERS, "two effects");
    let Some(second) = ranked(&forward).first().map(|i| forward[*i].clone()) else { return };
    let partner = second.effects.get(1).copied();
    keep(tried, forward);
    if second.fit.log_evidence < first.fit.log_evidence + CLEAR && !gate.adequacy(&first.fit).fires() {
        return;
    }
    if let Some(alone) = partner.and_then(|p| tried.get(&vec![p]).cloned()) {
        keep(tried, search.add_each(&alone, all, PARTNERS, "two effects, swapped"));
    }
    for (index, one) in best.iter().enumerate().skip(1) {
        let others: Vec<usize> = best[index + 1..]
            .iter()
            .map(|o| o.effects[0])
            .filter(|o| !tried.contains_key(&sorted(&[one.effects[0], *o])))
            .collect();
        keep(tried, search.add_each(one, &others, PARTNERS, "pairs of the best"));
    }
}

/// The best pair with every other effect, where the pair is worth it; where the triple is, too, each of its other pairs with every other effect (a swap).
fn triples(search: &Search<'_>, gate: &Gate, all: &[usize], tried: &mut BTreeMap<Vec<usize>, Tried>) {
    let Some(pair) = worth_more(search, gate, tried, 2) else { return };
    keep(tried, search.add_each(&pair, all, PARTNERS, "three effects"));
    let Some(triple) = worth_more(search, gate, tried, 3) else { return };
    let others = pair.effects.iter().map(|left_out| triple.effects.iter().copied().filter(|e| e != left_out).collect::<Vec<_>>());
    for other in others {
        let known = tried.get(&sorted(&other)).cloned();
        let from = known.or_else(|| {
            let alone = tried.get(&vec![other[0]])?;
            search.add_each(alone, &other[1..], 1, "three effects, swapped").pop()
        });
        let Some(from) = from else { continue };
        keep(tried, search.add_each(&from, all, PARTNERS, "three effects, swapped"));
        keep(tried, [from]);
    }
}

/// The best model of `count` effects, where it is clearly better than the best of one less.
fn worth_more(search: &Search<'_>, gate: &Gate, tried: &BTreeMap<Vec<usize>, Tried>, count: usize) -> Option<Tried> {
    let of_size = |n: usize| {
        tried.values().filter(move |t| t.effects.len() == n).max_by(|a, b| a.fit.log_evidence.total_cmp(&b.fit.log_evidence))
    };
    let (smaller, larger) = (of_size(count - 1)?, of_size(count)?);
    let gain = (larger.fit.log_evidence - smaller.fit.log_evidence) / temper_of(tried.values(), &search.library, gate);
    (gain > CLEAR && !search.stop.load(Ordering::Relaxed)).then(|| larger.clone())
}

fn sorted(effects: &[usize]) -> Vec<usize> {
    let mut key = effects.to_vec();
    key.sort_unstable();
    key
}

/// Divisor of log evidence: the right physics written with another equation leaves `FORM_ERROR` of its signal over `FORM_SHAPES` shapes, and evidence between
/// models must not rest on less than that.
///
/// The signal is what the best of the models explains, beyond what was foreseen. Parameters pushed away from what is known of them are misfit too: calibration may
/// have hidden most of it there. How wrong the equations can be shows in what the best model leaves: all but a `HIDDEN`th may hide in its parameters, not more.
fn temper_of<'t>(models: impl Iterator<Item = &'t Tried> + Clone, library: &[&dyn Effect], gate: &Gate) -> f64 {
    let Some(best) = least(models.clone()) else { return 1.0 };
    let nothing = expected(models, library).map_or(0.0, |m| m.fit.objective());
    let signal = 2.0 * (nothing - best.fit.objective()).max(0.0);
    let error = FORM_ERROR * FORM_ERROR * signal;
    let shows = if error > HIDDEN { HIDDEN * gate.may_leave(&best.fit) } else { f64::INFINITY };
    1.0 + error.min(shows) / FORM_SHAPES
}

/// Part of an error of form that shows in what a model leaves, the rest hidden in its parameters: one in so many, in units of the noise variance.
const HIDDEN: f64 = 10.0;

/// The model of the lowest objective.
fn least<'t>(models: impl Iterator<Item = &'t Tried>) -> Option<&'t Tried> {
    models.min_by(|a, b| a.fit.objective().total_cmp(&b.fit.objective()))
}

/// Share of the misfit from which on it counts as foreseen.
const FORESEEN: f64 = 0.9;

/// The model from which equations may be off: the base model, or that with nothing but effects that were computed beforehand, where those are most of what is
/// missing. They carry the error of their computation, some per cent, and not that of an equation chosen for its simplicity.
pub(crate) fn expected<'t>(models: impl Iterator<Item = &'t Tried> + Clone, library: &[&dyn Effect]) -> Option<&'t Tried> {
    let base = models.clone().find(|m| m.effects.is_empty())?;
    let least = least(models.clone())?.fit.objective();
    let computed = models.filter(|m| m.effects.iter().all(|e| library[*e].foreseen()));
    let best = computed.min_by(|a, b| a.fit.objective().total_cmp(&b.fit.objective()))?;
    let most = base.fit.objective() - best.fit.objective() > FORESEEN * (base.fit.objective() - least);
    Some(if most { best } else { base })
}

fn weigh(tried: BTreeMap<Vec<usize>, Tried>, library: &[&dyn Effect], gate: &Gate) -> Selection {
    let mut models: Vec<Tried> = tried.into_values().collect();
    let temper = temper_of(models.iter(), library, gate);
    let weight = weight(temper, library.len());
    models.sort_by(|a, b| weight(b).total_cmp(&weight(a)));
    let weights: Vec<f64> = models.iter().map(weight).collect();
    let total = log_sum_exp(&weights);
    let probability: Vec<f64> = weights.iter().map(|w| (w - total).exp()).collect();
    let (effect_probability, check) = (vec![0.0; library.len()], EvidenceCheck::default());
    Selection { models, probability, effect_probability, temper, base: 0, check, unlisted: Vec::new() }.sorted()
}
