//! Mechanisms from outside the library as facts: their words, how sure each is, their numbers, what they could be.
//!
//! Limits: decides nothing; a mechanism is listed whether the verdict stands behind it or not.

use crate::{
    answer::{
        discovered_facts::DiscoveredFacts,
        fit_facts::BeforeAfterUnit,
        found::Found,
        numbers::{fitted, parameters},
    },
    discovery::{discover::Discovery, phrase_book::could_be},
    effects::{
        composed::{describe::words as clause, file::MechanismFile, units::number_unit},
        effect::Effect,
    },
    validation::cross_validation::{HeldOutFit, compared},
};

/// The mechanisms; `before` and `after` are predictions of rows left out by the base model and by the model that holds them.
pub(crate) fn discovered(found: &Found<'_>, before: &HeldOutFit, after: Option<&HeldOutFit>) -> Vec<DiscoveredFacts> {
    let first = found.search.library.len() - found.mechanisms.len();
    let facts = |(k, mechanism): (usize, &Discovery)| {
        let index = first + k;
        // with the numbers that the answer predicts by
        let tried = found.told(found.selection.models.iter().find(|m| m.effects.contains(&index))?);
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
            named: found.chosen().effects.contains(&index) && !found.carries(index),
            carried: found.chosen().effects.contains(&index) && found.carries(index),
            in_other_words: found.in_other_words,
            log_odds: Some(found.log_odds_of_mechanisms).filter(|odds| odds.is_finite()),
            probability: mechanism.words.clone(),
            file: MechanismFile::of(&mechanism.effect, &values, |name| number_unit(name, words, found.search.context)),
            clause: clause(words),
            says,
            could_be: could_be(words, &mechanism.effect.start),
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
