//! What a reader is told of a change of regime.

use super::{Of, RegimeChange};
use crate::{
    data::context::Context,
    effects::effect::FittedParameter,
    text::{percent_with_sd, rounded, significant, with_sd},
};
use truegap_core::EffectId;

/// Share of a change below which a coefficient, or what changes beside the zero, counts as none.
const NONE: f64 = 0.05;

/// When it was switched.
pub(super) fn at(fitted: &[FittedParameter]) -> String {
    let (when, takes) = (&fitted[1], &fitted[2]);
    if when.parameter.unit == "s" {
        // a change that takes long is not known better than to its own length
        format!("{} after the first row", with_sd(when.value, when.sd.max(0.3 * takes.value), "s"))
    } else {
        format!("at about row {}", significant(when.value.round(), 4))
    }
}

/// The sentence, with what the coefficient was before by the effects `beside` it.
pub(super) fn said(
    effect: &RegimeChange,
    fitted: &[FittedParameter],
    context: &Context<'_>,
    beside: &[(EffectId, Vec<FittedParameter>)],
) -> String {
    let before = |id: &str| {
        let found = beside.iter().find(|(effect, _)| effect.0 == id).and_then(|(_, f)| f.first());
        found.map_or(0.0, |before| before.value)
    };
    let (of, at, reading) = (effect.of(context), at(fitted), context.simulator.unit());
    let turn = fitted.get(3).map_or((0.0, 0.0), |turn| (turn.value, turn.sd));
    let change = fitted[0].value;
    let (coefficient, zero) = effect.divided(change, turn.0, context);
    let sd_of = |part: fn(f64) -> f64, by: fn(f64) -> f64| (part(turn.0) * fitted[0].sd).hypot(change * by(turn.0) * turn.1);
    let switched = |old: f64, of: &str| {
        let (unit, (_, half)) = (effect.of(context).unit(context), effect.of(context).middle_and_half(context));
        let told = |value: f64| {
            if value.abs() < NONE * coefficient.abs() {
                format!("about none ({})", rounded(value, &unit))
            } else {
                rounded(value, &unit)
            }
        };
        let by = with_sd(coefficient, sd_of(f64::sin, f64::cos) / half, &unit);
        format!(
            "something is switched {at}: the coefficient of {of} is {} before and {} after it (change {by})",
            told(old),
            told(old + coefficient)
        )
    };
    // the reading above its lowest value is what the gain counts from
    let in_the_middle = zero + coefficient * 0.5 * context.response_span.abs();
    let gain = |sd: f64| {
        let by = percent_with_sd(coefficient, sd);
        let step = rounded(in_the_middle, reading);
        format!("something is switched {at}: the gain changes by {by}, and the reading by {step} in the middle of its range")
    };
    match (of, effect) {
        (_, RegimeChange::OfTheGain) => gain(sd_of(f64::cos, f64::sin)),
        _ if turn.0.sin().abs() < turn.0.cos().abs() && (turn.0.abs() < NONE || turn.0.abs() < 2.0 * turn.1) => {
            format!("something is switched {at}: the zero changes by {}", with_sd(change, fitted[0].sd, reading))
        }
        (Of::Temperature, _) => switched(before("temperature_coefficient"), "temperature"),
        (Of::Driver(course), _) => switched(before("driver_coefficient"), course.name(context)),
        (Of::Reading, _) => gain(sd_of(f64::sin, f64::cos) / of.middle_and_half(context).1),
        (Of::Nothing, _) => format!("something is switched {at}: the zero changes by {}", with_sd(change, fitted[0].sd, reading)),
    }
}
