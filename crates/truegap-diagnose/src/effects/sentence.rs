//! What is told of a fitted effect: its own sentence, or that the fit ran to where no number means anything.
//!
//! Limits: judges numbers by their bounds, errors and units; whether the effect is there is decided elsewhere.

use crate::{
    data::context::Context,
    effects::effect::{Effect, FittedParameter},
    text::{listed, rounded, spoken, uncapitalised, with_sd},
};
use truegap_core::{EffectId, Parameter};

/// A share of a whole beyond which a dimensionless number cannot be: ten times the whole.
const LARGEST_SHARE: f64 = 10.0;
/// A change per kelvin that cannot be: the whole of it.
const LARGEST_PER_KELVIN: f64 = 1.0;
/// Standard deviations of what was known beforehand beyond which a number was not foreseen.
const BEYOND: f64 = 10.0;
/// Distance from 0 and 1 within which a number counts as one of them: both are natural ends, where a part of an equation is absent or all there is.
const NATURAL: f64 = 1e-6;

/// The sentence of an effect with these numbers, `beside` what the effects beside it are fitted to.
///
/// Where its size is on a bound, less sure than it is large, or larger than any such number can be, that is a finding about the fit and told as one. A further
/// number on a bound is told behind the sentence, unless the bound is a natural end of it.
pub fn sentence(
    effect: &dyn Effect,
    fitted: &[FittedParameter],
    context: &Context<'_>,
    beside: &[(EffectId, Vec<FittedParameter>)],
) -> String {
    let Some(size) = fitted.first() else { return spoken(effect.id().0) };
    if let Some(why) = about_the_fit(effect, size).or_else(|| unsure(effect, size)) {
        return format!("{why}: this says more of the fit than of the instrument");
    }
    of_the_instrument(effect, fitted, context, beside)
}

/// The same of an effect that stands far out of the noise: a size that is less sure than it is large has other numbers that make up for it.
pub fn sentence_of_seen(
    effect: &dyn Effect,
    fitted: &[FittedParameter],
    context: &Context<'_>,
    beside: &[(EffectId, Vec<FittedParameter>)],
) -> String {
    match fitted.first() {
        Some(size) if about_the_fit(effect, size).is_none() && unsure(effect, size).is_some() => {
            let told = of_the_instrument(effect, fitted, context, beside);
            format!("{told}; its numbers make up for one another, so that all of them are known better than each")
        }
        _ => sentence(effect, fitted, context, beside),
    }
}

/// What an effect tells with its numbers, and those that lie on a limit.
fn of_the_instrument(
    effect: &dyn Effect,
    fitted: &[FittedParameter],
    context: &Context<'_>,
    beside: &[(EffectId, Vec<FittedParameter>)],
) -> String {
    let told = effect.told(fitted, context, beside);
    let further = &fitted[1..];
    let at_limit = further
        .iter()
        .filter(|f| f.at_limit && !is_natural(f.value) && !effect.describes() && !at_once(effect, &f.parameter, f.value));
    let at_limit: Vec<String> = at_limit.map(limit).collect();
    let no_number: Vec<String> = further.iter().filter(|f| !f.value.is_finite()).map(value).collect();
    match (at_limit.as_slice(), no_number.as_slice()) {
        ([], []) => told,
        (_, [_, ..]) => {
            let name = name_of(effect.id().0);
            format!(
                "{name} is asked for, but the fit ran to {}: this says more of the fit than of the instrument",
                listed(&no_number, "and")
            )
        }
        (limits, []) => format!("{told}; the fit ran to the limit of {}", listed(limits, "and")),
    }
}

/// Whether a number of an effect lies at its lower limit, and that is a law of its own.
pub(crate) fn at_once(effect: &dyn Effect, parameter: &Parameter, value: f64) -> bool {
    let (low, high) = parameter.bounds;
    effect.at_once().contains(&parameter.name.as_str()) && value - low < high - value
}

/// What is told of an effect that the probabilities ask for while nothing of it stands out of the noise.
pub(crate) fn nothing_stands_out(id: &str) -> String {
    format!(
        "{} is asked for, but nothing of it stands out of the noise once all else is free: this says more of the fit than of the instrument",
        name_of(id)
    )
}

/// Why the size of an effect says nothing of the instrument; `None` where it does.
fn about_the_fit(effect: &dyn Effect, size: &FittedParameter) -> Option<String> {
    let name = name_of(effect.id().0);
    if cannot_be(size) {
        return Some(format!("{name} is asked for, but the fit ran to {}", value(size)));
    }
    // a reading that stops for good has lost all of its slope: that end is a natural one
    if size.at_limit && !(effect.clips() && is_natural(size.value)) {
        return Some(format!("{name} is asked for, but the fit ran to the limit of {}", limit(size)));
    }
    None
}

/// That the size of an effect is less sure than it is large; `None` where it is not.
fn unsure(effect: &dyn Effect, size: &FittedParameter) -> Option<String> {
    let name = name_of(effect.id().0);
    // typical sizes of numbers that are free one by one are as sure as those numbers are many
    // what else may act is told in the deviation beside the number; here it is the fit that does not know it
    let unsure = size.sd_of_fit.is_nan() || size.sd_of_fit > size.value.abs();
    (unsure && !effect.free_form()).then(|| {
        let told = with_sd(size.value, size.sd_of_fit, &size.parameter.unit);
        format!("{name} is asked for, but its size is less sure than it is large, {told}")
    })
}

/// Whether a size is larger than anything of its kind and far beyond what was taken to be possible.
fn cannot_be(size: &FittedParameter) -> bool {
    let largest = match size.parameter.unit.as_str() {
        "1" => LARGEST_SHARE,
        "1/K" => LARGEST_PER_KELVIN,
        _ => f64::INFINITY,
    };
    let beyond = (size.value - size.parameter.centre()).abs() > BEYOND * size.parameter.sd();
    !size.value.is_finite() || (size.value.abs() > largest && beyond)
}

fn is_natural(value: f64) -> bool {
    value.abs() < NATURAL || (value - 1.0).abs() < NATURAL
}

/// `its time constant of the electronics, 4.25 h`.
fn limit(number: &FittedParameter) -> String {
    format!("{}, {}", called(number), rounded(number.value, &number.parameter.unit))
}

fn value(number: &FittedParameter) -> String {
    if !number.value.is_finite() {
        return format!("no number for {}", called(number));
    }
    format!("{} for {}", rounded(number.value, &number.parameter.unit), called(number))
}

/// The name of an effect in a sentence about the fit.
fn name_of(id: &str) -> String {
    if id.starts_with("discovered") { "a mechanism in words".into() } else { spoken(id) }
}

/// `the size of the change`: what a number means, with its article.
pub(crate) fn called(number: &FittedParameter) -> String {
    let meaning = uncapitalised(&number.parameter.meaning);
    format!("the {}", meaning.strip_prefix("its ").unwrap_or(&meaning))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// "discovered is asked for" was told.
    #[test]
    fn a_mechanism_of_words_has_a_name_in_sentences() {
        assert!(nothing_stands_out("discovered_second").starts_with("a mechanism in words is asked for"));
        assert!(nothing_stands_out("driver_coefficient").starts_with("driver coefficient is asked for"));
    }
}
