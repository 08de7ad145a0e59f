//! A law whose only difference from a simpler one is not seen stands in one set with that: an influence that comes late by 0.7 ms (sd 0.6) may be there at once.
//!
//! The likelihood tells the two apart by the noise. Where equations only describe, what they leave is more than the noise, and the deviation that is told of a number counts that.
//!
//! Limits: effects that name the law they come down to, and numbers whose lower limit is that law; their order of likelihood is left as it is.

use crate::selection::{
    candidates::{Search, Tried},
    verdict::Decision,
};

/// Size of a number from which on it is told from nothing, in the standard deviations that are told of it.
const TOLD_FROM_NOTHING: f64 = 2.0;

/// The decision for a model, with the simpler law in the set of each claimed effect that is not told from it; `sd` are the deviations that are told of its numbers, in those of the prior.
pub(crate) fn laws_not_told_apart(search: &Search<'_>, tried: &Tried, sd: &[f64], decision: Decision) -> Decision {
    let model = search.model(&tried.effects);
    let is_nothing = |i: usize| {
        let (prior, z) = (&model.parameters[i].prior, tried.fit.z[i]);
        prior.at(z) < TOLD_FROM_NOTHING * prior.slope(z) * sd[i]
    };
    let simpler = |(index, effect): (usize, &usize)| {
        let law = search.library[*effect];
        let simple = law.comes_down_to()?;
        let simple = search.library.iter().position(|other| other.id() == simple)?;
        let tells_apart = |i: &usize| law.at_once().contains(&model.parameters[*i].name.as_str());
        let mut numbers = model.range_of(index).filter(tells_apart).peekable();
        let is_seen = numbers.peek().is_none() || decision.carried.contains(effect) || tried.effects.contains(&simple);
        (!is_seen && numbers.all(is_nothing)).then_some((*effect, simple))
    };
    let pairs: Vec<(usize, usize)> = tried.effects.iter().enumerate().filter_map(simpler).collect();
    pairs.into_iter().fold(decision, Decision::with_rival)
}
