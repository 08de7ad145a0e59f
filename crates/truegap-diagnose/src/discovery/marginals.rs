//! How sure each word is: probabilities of sentences, added up word by word.
//!
//! Limits: sentences that no recording could tell apart keep equal shares; a word is as sure as the sentences that hold it together.

use crate::{discovery::screen::Screened, effects::composed::words::InWords, stats::log_sum_exp};
use serde::Serialize;
use std::collections::BTreeMap;

/// Probability of every value of every word, those above a thousandth.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct WordProbabilities {
    /// where
    pub place: BTreeMap<String, f64>,
    /// what it follows
    pub driver: BTreeMap<String, f64>,
    /// how in time
    pub kinetics: BTreeMap<String, f64>,
    /// the law; empty where only the words of an effect of the library are known
    #[serde(skip_serializing_if = "BTreeMap::is_empty")]
    pub form: BTreeMap<String, f64>,
    /// how it acts; empty as the law
    #[serde(skip_serializing_if = "BTreeMap::is_empty")]
    pub action: BTreeMap<String, f64>,
}

/// Probability that place, driver and kinetics need, each, for an answer without rivals.
pub const SURE: f64 = 0.9;

/// A word that decides what a mechanism is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Word {
    /// where
    Place,
    /// what it follows
    Driver,
    /// how in time
    Kinetics,
}

impl Word {
    /// Its name.
    pub fn name(self) -> &'static str {
        match self {
            Self::Place => "place",
            Self::Driver => "driver",
            Self::Kinetics => "kinetics",
        }
    }

    /// Its value.
    pub fn of(self, said: &InWords) -> String {
        match self {
            Self::Place => said.place.word().into(),
            Self::Driver => said.driver.word(),
            Self::Kinetics => said.kinetics.word().into(),
        }
    }
}

/// Probability below which a word's value is not listed.
const LISTED: f64 = 1e-3;

/// Probability from which a word's value is told.
pub const TOLD: f64 = 0.05;

/// Probabilities of the words, log evidence of sentences divided by `temper`.
pub fn marginals(sentences: &[Screened], temper: f64) -> WordProbabilities {
    let weights: Vec<f64> = sentences.iter().map(|s| s.weight(temper)).collect();
    let total = log_sum_exp(&weights);
    let mut words = WordProbabilities::default();
    for (s, weight) in sentences.iter().zip(&weights) {
        let p = (weight - total).exp();
        words.count(&s.sentence.in_words(), p);
        add(&mut words.form, s.sentence.form.word().into(), p);
        add(&mut words.action, s.sentence.action.word().into(), p);
    }
    for word in [&mut words.place, &mut words.driver, &mut words.kinetics, &mut words.form, &mut words.action] {
        word.retain(|_, p| *p >= LISTED);
    }
    words
}

fn add(word: &mut BTreeMap<String, f64>, value: String, p: f64) {
    *word.entry(value).or_insert(0.0) += p;
}

impl WordProbabilities {
    /// Words of effects of the library that stand in one another's place, each with its weight; effects that no words say count as none of them.
    pub fn of_effects(rivals: &[(Option<InWords>, f64)]) -> Self {
        let total: f64 = rivals.iter().map(|(_, weight)| weight).sum();
        let mut words = Self::default();
        let said = rivals.iter().filter_map(|(said, weight)| Some((said.as_ref()?, weight / total)));
        for (said, p) in said.filter(|(_, p)| *p >= LISTED) {
            words.count(said, p);
        }
        words
    }

    /// Adds a probability to the words that decide.
    fn count(&mut self, said: &InWords, p: f64) {
        for (value, word) in
            [(Word::Place, &mut self.place), (Word::Driver, &mut self.driver), (Word::Kinetics, &mut self.kinetics)]
        {
            add(word, value.of(said), p);
        }
    }

    /// Whether nothing is said.
    pub fn is_empty(&self) -> bool {
        self.driver.is_empty()
    }

    /// Place, driver and kinetics with their probabilities, for a reader.
    pub fn says(&self) -> String {
        let of = |name: &str, word: &BTreeMap<String, f64>| {
            let values = Self::values(word, TOLD).into_iter().map(|(value, p)| format!("{value} {p:.2}"));
            format!("{name}: {}", values.collect::<Vec<_>>().join(" or "))
        };
        [of("place", &self.place), of("driver", &self.driver), of("kinetics", &self.kinetics)].join("; ")
    }

    /// The values of a word that are at least this probable, likeliest first.
    pub fn values(word: &BTreeMap<String, f64>, least: f64) -> Vec<(&str, f64)> {
        let mut values: Vec<(&str, f64)> = word.iter().map(|(v, p)| (v.as_str(), *p)).filter(|(_, p)| *p >= least).collect();
        values.sort_by(|a, b| b.1.total_cmp(&a.1));
        values
    }

    /// The words that decide, each with the probability of its likeliest value.
    fn most_probable(&self) -> [(Word, f64); 3] {
        let most = |word: &BTreeMap<String, f64>| word.values().copied().fold(0.0, f64::max);
        [(Word::Place, most(&self.place)), (Word::Driver, most(&self.driver)), (Word::Kinetics, most(&self.kinetics))]
    }

    /// The word whose likeliest value is least probable, where one is below `least`.
    pub fn least_sure(&self, least: f64) -> Option<Word> {
        let below = self.most_probable().into_iter().filter(|(_, p)| *p < least);
        below.min_by(|a, b| a.1.total_cmp(&b.1)).map(|(word, _)| word)
    }

    /// Probability of the likeliest value of the least sure word.
    pub fn sureness(&self) -> f64 {
        self.most_probable().into_iter().fold(1.0, |least, (_, p)| least.min(p))
    }

    /// Whether place, driver and kinetics are each at least this probable.
    pub fn sure(&self, least: f64) -> bool {
        [&self.place, &self.driver, &self.kinetics].iter().all(|word| !Self::values(word, least).is_empty())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::effects::composed::words::{Driver, Kinetics, Place};

    #[test]
    fn rivals_of_one_driver_leave_no_doubt_of_it_whatever_the_name() {
        let said = |place, kinetics| Some(InWords { place, driver: Driver::Load, kinetics });
        let rivals = [(said(Place::Inputs, Kinetics::Static), 0.6), (said(Place::Geometry, Kinetics::Static), 0.3), (None, 0.1)];
        let words = WordProbabilities::of_effects(&rivals);
        let told = |word: &BTreeMap<String, f64>| word.iter().map(|(v, p)| format!("{v} {p:.2}")).collect::<Vec<_>>();
        assert_eq!((told(&words.driver), told(&words.kinetics)), (vec!["load 0.90".into()], vec!["static 0.90".into()]));
        assert_eq!(told(&words.place), ["geometry 0.30", "inputs 0.60"]);
        assert!(WordProbabilities::of_effects(&[(None, 1.0)]).is_empty());
    }
}
