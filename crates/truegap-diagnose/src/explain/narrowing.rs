//! What to measure where no rival is left: the run that best narrows the least sure number of what was found.
//!
//! Limits: the number's error is that of the fit, which knows nothing of an equation that is wrong.

use crate::{
    effects::effect::FittedParameter,
    effects::sentence::called,
    explain::{
        next_experiment::{ExperimentOption, NextExperiment, by_worth, playable},
        play::left_of,
    },
    selection::candidates::{Search, Tried},
    text::{significant, spoken, spoken_list, with_sd},
};

/// Relative error up to which a number needs no further run.
const SURE_ENOUGH: f64 = 0.1;
/// Share of its error that a run must at least take away to be worth it.
const WORTH_IT: f64 = 0.2;

/// The least sure number of the effects of a model.
pub struct LeastSure {
    /// its index among all parameters of the model
    pub index: usize,
    /// number, error, unit
    pub number: FittedParameter,
    /// the effect that it belongs to
    pub effect: String,
}

/// What to measure once the cause is told from all others.
pub(crate) fn narrowing(search: &Search<'_>, best: &Tried, least_sure: Option<LeastSure>) -> NextExperiment {
    let names = spoken_list(best.effects.iter().map(|e| search.library[*e].id().0), "and");
    let told_apart = format!("nothing is left that {names} would have to be told from");
    let only = |says: String| NextExperiment { says, ..NextExperiment::default() };
    let Some(least) = least_sure.filter(|l| relative(&l.number) > SURE_ENOUGH) else {
        return only(format!(
            "{told_apart}, and its numbers, as far as another run could narrow them, are sure to a tenth or better: no further run is needed"
        ));
    };
    let number = &least.number;
    let says = format!(
        "{told_apart}; least sure of its numbers is {} ({}), {}",
        called(number),
        spoken(&least.effect),
        with_sd(number.value, number.sd, &number.parameter.unit)
    );
    let options = options(search, best, least.index);
    match options.first() {
        Some(o) => NextExperiment {
            says: format!("{says}: {} ({} h), which would leave {:.0} % of that error", o.says, significant(o.hours, 2), left(o)),
            separates: Vec::new(),
            options,
        },
        None => only(format!("{says}: a second recording like this one would leave about 70 % of that error")),
    }
}

fn left(option: &ExperimentOption) -> f64 {
    100.0 * option.error_left.unwrap_or(1.0)
}

/// Error over size; infinite where there is no error to be had.
fn relative(number: &FittedParameter) -> f64 {
    let ratio = number.sd / number.value.abs();
    if ratio.is_nan() { f64::INFINITY } else { ratio }
}

/// The least sure of these numbers; one that lies at its bound is a finding about the fit and not to be narrowed.
pub(crate) fn least_sure(numbers: impl Iterator<Item = LeastSure>) -> Option<LeastSure> {
    numbers.filter(|l| !l.number.at_limit).max_by(|a, b| relative(&a.number).total_cmp(&relative(&b.number)))
}

fn options(search: &Search<'_>, best: &Tried, index: usize) -> Vec<ExperimentOption> {
    let option = |(mut option, inputs): (ExperimentOption, _)| {
        let left = left_of(search, &inputs, best, index)?;
        option.error_left = Some(left);
        (left < 1.0 - WORTH_IT).then_some(option)
    };
    by_worth(playable(search).into_iter().filter_map(option).collect(), |o| -o.error_left.unwrap_or(1.0).max(1e-3).ln())
}
