//! What a reader is told of something that is switched inside a recording.

use crate::{
    effects::effect::FittedParameter,
    text::{percent_with_sd, rounded, significant, with_sd},
};

/// Share of a change below which a coefficient counts as none.
const NONE: f64 = 0.05;

/// When it was switched.
pub(super) fn at(fitted: &[FittedParameter]) -> String {
    let (when, takes) = (&fitted[1], &fitted[2]);
    if when.parameter.unit == "s" {
        // a change that takes long is not known better than to its own length
        format!("something is switched {} after the first row", with_sd(when.value, when.sd.max(0.3 * takes.value), "s"))
    } else {
        format!("something is switched at about row {}", significant(when.value.round(), 4))
    }
}

/// A zero that changes by this, and the standard deviation of that.
pub(super) fn zero(at: &str, [change, sd]: [f64; 2], unit: &str) -> String {
    format!("{at}: the zero changes by {}", with_sd(change, sd, unit))
}

/// A gain that changes by this, and the reading in the middle of its range by `step`.
pub(super) fn gain(at: &str, [change, sd]: [f64; 2], (step, unit): (f64, &str)) -> String {
    let (by, step) = (percent_with_sd(change, sd), rounded(step, unit));
    format!("{at}: the gain changes by {by}, and the reading by {step} in the middle of its range")
}

/// A coefficient of something that was `old` and changes by this.
pub(super) fn coefficient((at, of): (&str, &str), old: f64, [change, sd]: [f64; 2], unit: &str) -> String {
    let told = |value: f64| {
        let number = rounded(value, unit);
        if value.abs() < NONE * change.abs() { format!("about none ({number})") } else { number }
    };
    let by = with_sd(change, sd, unit);
    format!("{at}: the coefficient of {of} is {} before and {} after it (change {by})", told(old), told(old + change))
}
