//! The numbers of an added effect in a model file, found by their names.
//!
//! Limits: names; units are those of [`super::written_units`].

use super::model_file::RunningModel;
use super::model_file_error::ModelFileError;
use super::written_units::{of_effect, of_mechanism};
use truegap_core::Parameter;
use truegap_core::nearest::instead;
use truegap_diagnose::answer::{AddedEffect, NamedValue};
use truegap_diagnose::mechanism::Numbers;
use truegap_diagnose::{Context, Effect, Library};

/// The number of a mechanism that every one has.
const SIZE: &str = "size";

impl RunningModel {
    /// Puts the numbers of every added effect in the order and the units of its equations, whatever order they stand in. Further numbers of a richer law are 0 where the file is of before the law had
    /// them. An effect that the library does not have stays as it is.
    ///
    /// # Errors
    /// [`ModelFileError::SurplusNumber`] for a name that an effect does not have, [`ModelFileError::MissingNumber`] for one that is not there,
    /// [`ModelFileError::NumberUnit`] for one in a unit of another kind.
    pub(super) fn order_numbers(&mut self) -> Result<(), ModelFileError> {
        let (library, mut effects) = (Library::default(), std::mem::take(&mut self.augmented.effects));
        self.as_fitted(|context| effects.iter_mut().try_for_each(|added| in_order(added, &library, context)))?;
        self.augmented.effects = effects;
        Ok(())
    }
}

/// The same for one effect.
fn in_order(added: &mut AddedEffect, library: &Library, context: &Context<'_>) -> Result<(), ModelFileError> {
    if added.mechanism.is_some() {
        return of_a_mechanism(added);
    }
    let Some(effect) = library.find(&added.id) else { return Ok(()) };
    let context = &within_its_runs(added, context);
    let parameters = effect.parameters(context);
    known(added, &parameters.iter().map(|p| p.name.as_str()).collect::<Vec<_>>())?;
    let ordered = parameters.into_iter().map(|parameter| number(added, effect, parameter));
    added.parameters = ordered.collect::<Result<_, _>>()?;
    of_effect(added, effect, context)
}

/// The context with no more runs than an effect with so many numbers can mean: a count of runs alone costs no memory.
pub(super) fn within_its_runs<'a>(added: &AddedEffect, context: &Context<'a>) -> Context<'a> {
    context.clone().with_runs(context.runs.min(added.parameters.len() + 2))
}

/// The number of this name, as the file gives it.
fn number(added: &AddedEffect, effect: &dyn Effect, parameter: Parameter) -> Result<NamedValue, ModelFileError> {
    let Parameter { name, unit, .. } = parameter;
    match added.parameters.iter().find(|given| given.name == name) {
        Some(given) => Ok(given.clone()),
        None if effect.came_later().contains(&name.as_str()) => Ok(NamedValue { name, unit, value: 0.0, sd: 0.0 }),
        None => Err(ModelFileError::MissingNumber { id: added.id.clone(), name, unit }),
    }
}

/// A mechanism takes its numbers by their names, and those that are not listed from its words; without a size it would do nothing.
fn of_a_mechanism(added: &mut AddedEffect) -> Result<(), ModelFileError> {
    let names: Vec<&str> = [SIZE].into_iter().chain(Numbers::NAMES).collect();
    known(added, &names)?;
    match added.parameters.iter().any(|given| given.name == SIZE) {
        true => of_mechanism(added),
        false => Err(ModelFileError::MissingNumber { id: added.id.clone(), name: SIZE.into(), unit: "...".into() }),
    }
}

/// Refuses a name that is none of `names`.
fn known(added: &AddedEffect, names: &[&str]) -> Result<(), ModelFileError> {
    match added.parameters.iter().find(|given| !names.contains(&given.name.as_str())) {
        Some(NamedValue { name, value, .. }) => {
            let (id, name, instead) = (added.id.clone(), name.clone(), instead(name, &[], names));
            Err(ModelFileError::SurplusNumber { id, name, value: *value, instead })
        }
        None => Ok(()),
    }
}
