//! Mechanisms from outside the library as facts: their words, how sure each is, their numbers, what they could be.
//!
//! Limits: decides nothing; a mechanism is listed whether the verdict stands behind it or not.

use crate::{
    answer::{
        diagnosis::BeforeAfterUnit,
        found::Found,
        numbers::{fitted, parameters},
        parameter_facts::ParameterFacts,
    },
    discovery::{discover::Discovery, marginals::WordProbabilities, phrase_book::could_be},
    effects::{
        composed::{describe::words as clause, file::MechanismFile, mechanism::Sentence},
        effect::Effect,
    },
    validation::cross_validation::{HeldOutFit, compared},
};
use serde::Serialize;

/// A mechanism that no library lists.
#[derive(Clone, Debug, Serialize)]
pub struct DiscoveredFacts {
    /// where in the chain
    pub place: String,
    /// what it follows
    pub driver: String,
    /// how in time
    pub kinetics: String,
    /// the law
    pub form: String,
    /// how it acts
    pub action: String,
    /// the words with their varieties, as a model file has them
    pub sentence: Sentence,
    /// whether the verdict stands behind it
    pub named: bool,
    /// probability of each value of each word
    pub probability: WordProbabilities,
    /// the words as a clause
    pub clause: String,
    /// sentence with numbers
    pub says: String,
    /// known physics that the words fit, each with a source; no claim
    pub could_be: Vec<String>,
    /// fitted numbers
    pub parameters: Vec<ParameterFacts>,
    /// error on rows left out, of the calibrated base model and with everything that the mechanism's model holds
    pub held_out: BeforeAfterUnit,
    /// share of turned histories in which the same freedom removes as much by chance
    pub control_p_value: f64,
    /// columns that were weighed
    pub weighed: usize,
    /// the mechanism as a file, for other recordings
    #[serde(skip)]
    pub file: MechanismFile,
}

/// The mechanisms; `before` and `after` are predictions of rows left out by the base model and by the model that holds them.
pub(crate) fn discovered(found: &Found<'_>, before: &HeldOutFit, after: Option<&HeldOutFit>) -> Vec<DiscoveredFacts> {
    let first = found.search.library.len() - found.mechanisms.len();
    let facts = |(k, mechanism): (usize, &Discovery)| {
        let index = first + k;
        let tried = found.selection.models.iter().find(|m| m.effects.contains(&index))?;
        let model = found.search.model(&tried.effects);
        let own = model.range_of(tried.effects.iter().position(|e| *e == index)?);
        let both = after.and_then(|after| compared(before, after));
        let words = &mechanism.effect.sentence;
        let numbers = fitted(found, tried, own.clone());
        let says = mechanism.effect.told(&numbers, found.search.context, &[]);
        let values: Vec<_> = numbers.into_iter().map(|p| (p.parameter.name, p.value, p.sd, p.parameter.unit)).collect();
        Some(DiscoveredFacts {
            place: words.quantity.place().word().into(),
            driver: words.driver.word(),
            kinetics: words.kinetics.word().into(),
            form: words.form.word().into(),
            action: words.action.word().into(),
            sentence: words.clone(),
            named: found.chosen().effects.contains(&index),
            probability: mechanism.words.clone(),
            file: MechanismFile::of(&mechanism.effect, &values),
            clause: clause(words),
            says,
            could_be: could_be(words),
            parameters: parameters(found, tried, own),
            held_out: BeforeAfterUnit {
                rmse_before: both.as_ref().map(|c| c.rmse[0]),
                rmse_after: both.as_ref().map(|c| c.rmse[1]),
                unit: found.search.problem.simulator.unit().into(),
            },
            control_p_value: mechanism.control_p_value,
            weighed: mechanism.weighed,
        })
    };
    found.mechanisms.iter().enumerate().filter_map(facts).collect()
}

/// The model that holds the mechanisms, where there are any.
pub(crate) fn model_of<'f>(found: &'f Found<'_>) -> Option<&'f crate::selection::candidates::Tried> {
    let first = found.search.library.len() - found.mechanisms.len();
    found.selection.models.iter().find(|m| m.effects.iter().any(|e| *e >= first))
}
