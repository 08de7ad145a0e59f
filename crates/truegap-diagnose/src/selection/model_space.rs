//! The models that are tried: singles, forward steps with swaps, pairs of the best, triples; those that matter fitted to the end and their evidence sampled.
//!
//! Limits: a model that no step leads to is not tried.

use crate::{
    adequacy::lack_of_fit::LackOfFitTests,
    fit::importance::{Sampled, sampled},
    seeds::SEEDS,
    selection::tuning::{
        ABREAST, BETTER_PART, CLEAR_GAIN, CLOSE, ENOUGH_DRAWS, ENOUGH_KNOWN, MAY_BE_NAMED, PARTNERS, REFITTED_MODELS, SAMPLED,
    },
    selection::{
        candidates::{Found, Progress, Search, Tried},
        effect_set::EffectSet,
        prior::weight,
        tempering::temper_of,
    },
};
use rayon::prelude::*;
use std::{
    collections::{BTreeMap, BTreeSet},
    sync::atomic::{AtomicUsize, Ordering},
};

/// The best fit of each set of effects so far.
pub(crate) struct ModelSpace<'s, 'a> {
    search: &'s Search<'a>,
    lack_of_fit: &'s LackOfFitTests,
    models: BTreeMap<EffectSet, Tried>,
    /// effects and coordinates of the models beside which every other effect was tried
    extended: Vec<(Vec<usize>, Vec<f64>)>,
}

impl<'s, 'a> ModelSpace<'s, 'a> {
    /// The base model and every effect alone; where one is worth it, two and three together; all that is close fitted to the end.
    pub fn all(search: &'s Search<'a>, lack_of_fit: &'s LackOfFitTests, base: Tried) -> Self {
        let mut space = Self { search, lack_of_fit, models: BTreeMap::new(), extended: Vec::new() };
        let all: Vec<usize> = (0..search.library.len()).collect();
        let singles = search.add_each(&base, &all, all.len(), "one effect");
        let order = ranked(&singles);
        let gain = order.first().map_or(0.0, |i| singles[*i].fit.log_evidence - base.fit.log_evidence);
        space.keep(std::iter::once(base).chain(singles.iter().cloned()));
        if gain > CLEAR_GAIN {
            let best: Vec<&Tried> = order.iter().take(PARTNERS).map(|i| &singles[*i]).collect();
            space.pairs(&best, &all);
            space.triples(&all);
        }
        space.polish();
        if space.smaller() {
            space.polish();
        }
        space
    }

    /// The models.
    pub fn into_models(self) -> Vec<Tried> {
        self.models.into_values().collect()
    }

    fn stopped(&self) -> bool {
        self.search.stop.load(Ordering::Relaxed)
    }

    fn temper(&self) -> f64 {
        temper_of(self.models.values(), &self.search.library, self.lack_of_fit)
    }

    /// Keeps the better fit of models with the same effects.
    fn keep(&mut self, models: impl IntoIterator<Item = Tried>) {
        for model in models {
            let better = self.models.get(&model.key()).is_none_or(|old| model.fit.log_evidence > old.fit.log_evidence);
            if better {
                self.models.insert(model.key(), model);
            }
        }
    }

    /// Numbers of each effect as the fit of it alone and the likeliest pair that holds it have found them.
    fn found(&self) -> Found {
        let mut found = Found::new();
        for size in [1, 2] {
            let mut likeliest: BTreeMap<usize, &Tried> = BTreeMap::new();
            for tried in self.models.values().filter(|tried| tried.effects.len() == size) {
                for effect in &tried.effects {
                    let best = likeliest.entry(*effect).or_insert(tried);
                    if tried.fit.log_evidence > best.fit.log_evidence {
                        *best = tried;
                    }
                }
            }
            for (effect, tried) in likeliest {
                let model = self.search.model(&tried.effects);
                let numbers = |index: usize| tried.fit.z[model.range_of(index)].to_vec();
                found.entry(effect).or_default().extend(tried.effects.iter().position(|e| *e == effect).map(numbers));
            }
        }
        found
    }

    /// Each of `from` with each other effect, those that promise most fitted, side by side; nothing where that was done from the same fit.
    fn beside_all(&mut self, from: &[Tried], all: &[usize], step: &'static str) -> Vec<Tried> {
        let mut fresh: Vec<&Tried> = Vec::with_capacity(from.len());
        for tried in from {
            if !self.extended.iter().any(|(effects, z)| *effects == tried.effects && *z == tried.fit.z) {
                self.extended.push((tried.effects.clone(), tried.fit.z.clone()));
                fresh.push(tried);
            }
        }
        let found = self.found();
        let add = |tried: &&Tried| self.search.add_each_as_found(tried, all, PARTNERS, step, &found);
        fresh.par_iter().flat_map_iter(add).collect()
    }

    /// Each of the best singles with every other effect, then the best partner with every other (a swap), then all pairs of the best; no more than the first where the
    /// best single leaves nothing and no partner gains anything.
    ///
    /// An effect may show beside one alone that is not the best: a lag of a coefficient, where something else follows the recording more closely at first.
    fn pairs(&mut self, best: &[&Tried], all: &[usize]) {
        let Some(first) = best.first() else { return };
        let forward = self.beside_all(std::slice::from_ref(*first), all, "two effects");
        let Some(second) = ranked(&forward).first().map(|i| forward[*i].clone()) else { return };
        self.keep(forward);
        if second.fit.log_evidence < first.fit.log_evidence + CLEAR_GAIN && !self.lack_of_fit.adequacy(&first.fit).fires() {
            return;
        }
        let partner = second.effects.get(1).and_then(|partner| self.models.get(&EffectSet::from(&[*partner][..])));
        let others: Vec<Tried> = best.iter().skip(1).take(ABREAST - 1).copied().chain(partner).cloned().collect();
        let found = self.beside_all(&others, all, "two effects");
        self.keep(found);
        let alone = self.found();
        let of = |(index, one): (usize, &&Tried)| {
            let others = best[index + 1..].iter().map(|o| o.effects[0]);
            let open = |o: &usize| !self.models.contains_key(&EffectSet::from(&[one.effects[0], *o][..]));
            let others: Vec<usize> = others.filter(open).collect();
            self.search.add_each_as_found(one, &others, PARTNERS, "pairs of the best", &alone)
        };
        let found: Vec<Vec<Tried>> = best.par_iter().enumerate().skip(1).map(of).collect();
        self.keep(found.into_iter().flatten());
        self.the_other_way(best);
    }

    /// Pairs of the best singles once more, from the other one of the two: each has calibrated the base model its own way, and where both effects move the same numbers a fit that begins with the one
    /// may end far above that which begins with the other.
    fn the_other_way(&mut self, best: &[&Tried]) {
        let ways: Vec<(&Tried, &Tried)> = best.iter().flat_map(|from| best.iter().map(|other| (*from, *other))).collect();
        let base = self.search.model(&[]).base_count();
        let again = |(from, other): &(&Tried, &Tried)| {
            let (first, second) = (from.effects[0], other.effects[0]);
            let pair = self.models.get(&EffectSet::from(&[first, second][..]))?;
            let began_with_other = first != second && pair.effects.first() == Some(&second);
            began_with_other.then(|| self.search.otherwise(from, second, &other.fit.z[base..], pair.fit.objective())).flatten()
        };
        let found: Vec<Tried> = ways.par_iter().filter_map(again).collect();
        self.keep(found);
    }

    /// The best pairs with every other effect, where the best is worth it; where the triple is, too, each of its other pairs with every other effect (a swap).
    fn triples(&mut self, all: &[usize]) {
        let Some(pair) = self.worth_more(2) else { return };
        let found = self.beside_all(&self.best_of(2, ABREAST), all, "three effects");
        self.keep(found);
        let Some(triple) = self.worth_more(3) else { return };
        let without = |left_out: &usize| triple.effects.iter().copied().filter(|e| e != left_out).collect::<Vec<_>>();
        let fitted = |other: Vec<usize>| {
            self.models.get(&EffectSet::from(other.as_slice())).cloned().or_else(|| {
                let alone = self.models.get(&EffectSet::from(&other[..1]))?;
                self.search.add_each(alone, &other[1..], 1, "three effects, swapped").pop()
            })
        };
        let from: Vec<Tried> = pair.effects.iter().map(without).filter_map(fitted).collect();
        let found = self.beside_all(&from, all, "three effects, swapped");
        self.keep(found.into_iter().chain(from));
    }

    /// The likeliest models of `count` effects, at most `most`, none far behind the first.
    fn best_of(&self, count: usize, most: usize) -> Vec<Tried> {
        let mut those: Vec<&Tried> = self.models.values().filter(|t| t.effects.len() == count).collect();
        those.sort_by(|a, b| b.fit.log_evidence.total_cmp(&a.fit.log_evidence));
        let least = those.first().map_or(0.0, |t| t.fit.log_evidence) - CLOSE * self.temper();
        those.into_iter().take(most).filter(|t| t.fit.log_evidence > least).cloned().collect()
    }

    /// The best model of `count` effects, where it is clearly better than the best of one less.
    fn worth_more(&self, count: usize) -> Option<Tried> {
        let of_size = |n: usize| {
            let those = self.models.values().filter(move |t| t.effects.len() == n);
            those.max_by(|a, b| a.fit.log_evidence.total_cmp(&b.fit.log_evidence))
        };
        let (smaller, larger) = (of_size(count - 1)?, of_size(count)?);
        let gain = (larger.fit.log_evidence - smaller.fit.log_evidence) / self.temper();
        (gain > CLEAR_GAIN && !self.stopped()).then(|| larger.clone())
    }

    /// Fits to the end what could still matter; the search itself is content with rough fits.
    fn polish(&mut self) {
        let mut done: BTreeSet<EffectSet> = BTreeSet::from([EffectSet::default()]);
        loop {
            let weight = weight(self.temper(), self.search.library.len());
            let best = self.models.values().map(weight).fold(f64::NEG_INFINITY, f64::max);
            let near = |(key, m): &(&EffectSet, &Tried)| !done.contains(*key) && weight(m) > best - CLOSE;
            let rough: Vec<&Tried> = self.models.iter().filter(near).map(|(_, m)| m).collect();
            if rough.is_empty() || self.stopped() {
                return;
            }
            done.extend(rough.iter().map(|m| m.key()));
            let better = self.polished(&rough);
            self.keep(better);
        }
    }

    fn polished(&self, rough: &[&Tried]) -> Vec<Tried> {
        let finished = AtomicUsize::new(0);
        let one = |m: &&Tried| {
            let polished = self.search.polished(m);
            let done = (finished.fetch_add(1, Ordering::Relaxed) + 1) as f64 / rough.len() as f64;
            (self.search.progress)(Progress { step: "closer look", what: format!("{} models", rough.len()), done });
            polished
        };
        rough.par_iter().filter_map(one).collect()
    }

    /// Fits the models that the likeliest hold from where those ended; whether one of them is better for it.
    fn smaller(&mut self) -> bool {
        let weight = weight(self.temper(), self.search.library.len());
        let best = self.models.values().map(weight).fold(f64::NEG_INFINITY, f64::max);
        let mut likely: Vec<&Tried> =
            self.models.values().filter(|m| m.effects.len() > 1 && weight(m) > best - CLEAR_GAIN).collect();
        likely.sort_by(|a, b| weight(b).total_cmp(&weight(a)));
        likely.truncate(REFITTED_MODELS);
        if self.stopped() {
            return false;
        }
        let found: Vec<Tried> = likely.par_iter().flat_map_iter(|m| self.search.without_each(m)).collect();
        let gains =
            |m: &Tried| self.models.get(&m.key()).is_none_or(|old| m.fit.log_evidence > old.fit.log_evidence + BETTER_PART);
        let better = found.iter().any(gains);
        self.keep(found);
        better
    }

    /// Replaces Laplace's evidence by a sampled one for the models with the most weight, and for the base model.
    pub fn check(&mut self) -> EvidenceCheck {
        let temper = self.temper();
        let weight = weight(temper, self.search.library.len());
        let mut order: Vec<(&EffectSet, f64)> = self.models.iter().map(|(key, m)| (key, weight(m))).collect();
        order.sort_by(|a, b| b.1.total_cmp(&a.1));
        let best = order.first().map_or(0.0, |o| o.1);
        let near = |(place, (key, w)): &(usize, (&EffectSet, f64))| key.is_empty() || (*place < SAMPLED.0 && *w > best - CLOSE);
        // what is weighed is the evidence over the temper, and so is its error; what may be named is drawn in full, since names go by small differences
        let enough = |w: f64| if w > best - MAY_BE_NAMED { 0.0 } else { ENOUGH_KNOWN * temper };
        let keys: Vec<(EffectSet, f64)> =
            order.into_iter().enumerate().filter(near).map(|(_, (key, w))| (key.clone(), enough(w))).collect();
        let found: Vec<(EffectSet, Sampled)> =
            keys.par_iter().filter_map(|(key, enough)| Some((key.clone(), self.sampled(key, *enough)?))).collect();
        let mut report = EvidenceCheck { models: found.len(), ..EvidenceCheck::default() };
        let shares = found.iter().map(|(_, s)| s.effective_share);
        report.effective_share = [shares.clone().fold(1.0, f64::min), shares.fold(0.0, f64::max)];
        for (key, sampled) in found.into_iter().filter(|(_, s)| s.effective_share > ENOUGH_DRAWS) {
            let Some(m) = self.models.get_mut(&key) else { continue };
            report.replaced += 1;
            let log_evidence = sampled.log_evidence + m.fit.scale_gain;
            report.largest_change = report.largest_change.max((log_evidence - m.fit.log_evidence).abs());
            m.fit.log_evidence = log_evidence;
        }
        report
    }

    fn sampled(&self, key: &EffectSet, enough: f64) -> Option<Sampled> {
        let m = self.models.get(key).filter(|_| !self.stopped())?;
        let seed = key.iter().fold(SEEDS.evidence, |seed, e| seed.wrapping_mul(31).wrapping_add(*e as u64 + 1));
        sampled(&self.search.model(&m.effects), self.search.whitener, &m.fit, SAMPLED.1, enough, seed)
    }
}

fn ranked(models: &[Tried]) -> Vec<usize> {
    let mut order: Vec<usize> = (0..models.len()).collect();
    order.sort_by(|a, b| models[*b].fit.log_evidence.total_cmp(&models[*a].fit.log_evidence));
    order
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        fit::{levenberg_marquardt::FitOptions, maximum_a_posteriori::fit},
        tests::search::{ACTING, FORESEEN, ROWS, as_foreseen, searched, second_as_found},
    };

    /// The pair that begins with the first wave is caught where the second is foreseen. The second alone has found its numbers, and the first beside it leaves nothing but noise.
    #[test]
    fn a_pair_that_is_caught_from_one_effect_is_found_from_the_other() {
        searched(&ACTING, &FORESEEN, |search, lack_of_fit| {
            let [one, both] = as_foreseen(search);
            let model = search.model(&[1]);
            let start: Vec<f64> = vec![0.0; model.base_count()].into_iter().chain(second_as_found(search)).collect();
            let fit = fit(&model, search.whitener, &start, &FitOptions::default()).unwrap();
            let other = Tried { effects: vec![1], fit };
            let mut space = ModelSpace { search, lack_of_fit, models: BTreeMap::new(), extended: Vec::new() };
            space.keep([one.clone(), other.clone(), both]);
            let left = |space: &ModelSpace<'_, '_>| space.models[&EffectSet::from(&[0, 1][..])].fit.chi2 / ROWS as f64;
            assert!(left(&space) > 4.0, "{}", left(&space));
            space.the_other_way(&[&one, &other]);
            assert!(left(&space) < 1.2, "{}", left(&space));
            // numbers as the fit of each alone and the likeliest pair have them
            let found = space.found();
            assert_eq!([found[&0].len(), found[&1].len()], [2, 2]);
            assert_eq!(found[&1][0], other.fit.z[model.base_count()..]);
        });
    }
}
