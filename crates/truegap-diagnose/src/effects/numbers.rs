//! Numbers of an effect that it has beside this base model and in this recording.
//!
//! An effect names the numbers of its laws without knowing where it is asked. Some are only there beside some base models, or where a driver moves.

use crate::{
    data::context::{Context, Number},
    effects::effect::Effect,
};

/// Those of the numbers of these names that an effect has here.
pub(crate) fn here(effect: &dyn Effect, names: &[&'static str], context: &Context<'_>) -> Vec<Number> {
    if names.is_empty() {
        return Vec::new();
    }
    let parameters = effect.parameters(context);
    let has = |name: &&&str| parameters.iter().any(|parameter| parameter.name == ***name);
    names.iter().filter(has).map(|name| (effect.id(), *name)).collect()
}

/// Those that are 0 in the simplest law by its name and free here.
pub(crate) fn free_to_be_nothing(effect: &dyn Effect, context: &Context<'_>) -> Vec<Number> {
    let mut numbers = here(effect, effect.may_be_nothing(), context);
    numbers.retain(|(id, name)| !context.holds(*id, name));
    numbers
}

/// Starts for the numbers behind the size, as many as an effect with so many `parameters` has here: the last ones may be missing.
pub(crate) fn cut(starts: Vec<Vec<f64>>, parameters: usize) -> Vec<Vec<f64>> {
    starts.into_iter().map(|start| start[..parameters - 1].to_vec()).collect()
}
