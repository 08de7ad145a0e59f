//! Whether the numbers of a model file can be, before anything is built of them.
//!
//! Limits: a number that is possible and wrong is not found; standard deviations play no part in an answer, and only those below 0 are refused.

use super::by_name::within_its_runs;
use super::model_file::{ModelFile, RunningModel};
use super::model_file_error::ModelFileError;
use truegap_core::given_again;
use truegap_diagnose::answer::{AddedEffect, NamedValue, Scales};
use truegap_diagnose::mechanism::Numbers;
use truegap_diagnose::{Context, Effect, Library};

impl ModelFile {
    /// Whether every number can be, and is given once.
    ///
    /// # Errors
    /// [`ModelFileError::Number`] or [`ModelFileError::Base`] with the first that cannot; [`ModelFileError::Twice`] or [`ModelFileError::EffectTwice`] with what is given twice.
    pub(super) fn check_numbers(&self) -> Result<(), ModelFileError> {
        self.base.check()?;
        self.scales_are_possible()?;
        sound("[[parameter]]", &self.parameters)?;
        sound("[[base_alone]]", &self.base_alone)?;
        if let Some((effect, _)) = given_again(&self.effects, is_same) {
            return Err(ModelFileError::EffectTwice { id: effect.id.clone() });
        }
        self.effects.iter().try_for_each(|effect| {
            sound(&effect.id, &effect.parameters)?;
            effect.mechanism.as_ref().map_or(Ok(()), |mechanism| held(&effect.id, &mechanism.numbers))
        })
    }

    fn scales_are_possible(&self) -> Result<(), ModelFileError> {
        let Scales { longest_run_s, shortest_step_s, duration_s, response_span, noise_sd, .. } = self.scales;
        let scales = [
            ("longest_run_s", longest_run_s),
            ("shortest_step_s", shortest_step_s),
            ("duration_s", duration_s),
            ("response_span", response_span),
            ("noise_sd", noise_sd),
        ];
        let wrong = scales.into_iter().find(|(_, value)| !(value.is_finite() && *value >= 0.0));
        wrong.map_or(Ok(()), |(name, value)| Err(of_scales(name, value)))?;
        let Some(moved) = &self.scales.moved else { return Ok(()) };
        let ends = moved.ranges.iter().flat_map(|(name, ends)| ends.iter().map(move |end| (name.as_str(), *end)));
        let mut ranges = [("temperature_k", moved.temperature_k), ("load", moved.load)].into_iter().chain(ends);
        let wrong = ranges.find(|(_, value)| !value.is_finite());
        wrong.map_or(Ok(()), |(name, value)| Err(of_scales(name, value)))
    }
}

fn of_scales(name: &str, value: f64) -> ModelFileError {
    let wanted = "what `truegap diagnose` writes there: a finite number, and no time or size below 0";
    ModelFileError::Number { what: format!("{name} under [scales]"), value, wanted }
}

impl RunningModel {
    /// Every effect is known, and none of its numbers is below 0 that cannot be.
    pub(super) fn check(&self) -> Result<(), ModelFileError> {
        let effects = Library::default();
        self.as_fitted(|context| {
            for added in &self.augmented.effects {
                let Some(effect) = effects.find(&added.id) else { continue };
                possible(effect, added, context)?;
            }
            // an id that the library does not have is told with all that it has; nothing is walked here
            let known = |added: &AddedEffect| effects.find(&added.id).is_some();
            match self.augmented.effects.iter().all(known) {
                true => Ok(()),
                false => Ok(self.augmented.stages(&effects, context).map(|_| ())?),
            }
        })
    }
}

/// None of the numbers, which stand in the order of the effect's, is below 0 that cannot be.
fn possible(effect: &dyn Effect, added: &AddedEffect, context: &Context<'_>) -> Result<(), ModelFileError> {
    let parameters = effect.parameters(&within_its_runs(added, context));
    let below = added.parameters.iter().zip(&parameters).find(|(given, known)| known.bounds.0 >= 0.0 && given.value < 0.0);
    below.map_or(Ok(()), |(NamedValue { name, value, .. }, _)| {
        Err(ModelFileError::Number { what: format!("`{name}` of {}", added.id), value: *value, wanted: "a number from 0 on" })
    })
}

/// Whether two are one effect: discovered ones of one name may differ in their words.
fn is_same(one: &AddedEffect, other: &AddedEffect) -> bool {
    let words = |added: &AddedEffect| added.mechanism.as_ref().map(|mechanism| mechanism.sentence.clone());
    one.id == other.id && words(one) == words(other)
}

/// Every number is one, and each name stands once.
fn sound(of: &str, values: &[NamedValue]) -> Result<(), ModelFileError> {
    values.iter().try_for_each(|value| finite(of, value))?;
    match given_again(values, |one, other| one.name == other.name) {
        Some((first, second)) => {
            let (name, of) = (first.name.clone(), of.to_owned());
            Err(ModelFileError::Twice { of, name, first: first.value, second: second.value })
        }
        None => Ok(()),
    }
}

fn finite(of: &str, NamedValue { name, value, sd, .. }: &NamedValue) -> Result<(), ModelFileError> {
    if *sd < 0.0 {
        let wanted = "a standard deviation, from 0 on";
        return Err(ModelFileError::Number { what: format!("the sd of `{name}` of {of}"), value: *sd, wanted });
    }
    match value.is_finite() {
        true => Ok(()),
        false => Err(ModelFileError::Number { what: format!("`{name}` of {of}"), value: *value, wanted: "a finite number" }),
    }
}

/// The fixed numbers of a mechanism.
fn held(id: &str, numbers: &Numbers) -> Result<(), ModelFileError> {
    let Numbers { tau_s, width, threshold, exponent, scale, period, phase, turn } = *numbers;
    let numbers = [
        ("tau_s", tau_s),
        ("width", width),
        ("threshold", threshold),
        ("exponent", exponent),
        ("scale", scale),
        ("period", period),
        ("phase", phase),
        ("turn", turn),
    ];
    let wrong = numbers.into_iter().find(|(_, value)| !value.is_finite());
    wrong.map_or(Ok(()), |(name, value)| {
        Err(ModelFileError::Number { what: format!("{name} of {id}"), value, wanted: "a finite number" })
    })
}
