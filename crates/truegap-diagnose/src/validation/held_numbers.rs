//! Numbers of an effect that rows left out do not bear out: a bend, a slow way beside the quick one, a fading. They are held at nothing.
//!
//! A richer law fits what it has seen at least as well, and foretells worse where its further numbers have only followed the noise, or other physics. The effect keeps its name; its law is
//! then the simple one that it holds as a special case.
//!
//! Limits: numbers that their effect names as such; rows left out are predicted as the caller calibrates.

use crate::{
    data::context::Number,
    effects::{effect::Effect, numbers::free_to_be_nothing},
    selection::{
        candidates::{Search, Tried},
        posterior::Selection,
        refitted::refitted,
    },
    validation::{
        cross_validation::{HeldOutFit, compared},
        tuning::{CLEARLY_WORSE, REFITTED_FROM, TOLD_FROM_NOTHING},
    },
};
use truegap_core::EffectId;

/// What a model foretells of rows left out.
type Foretold<'a> = &'a dyn Fn(&Search<'_>, &Tried) -> HeldOutFit;

/// Numbers of the model `tried` that are better held at nothing, by effect and name; empty where all are borne out. Rows left out are predicted better without them, `least` times or more.
pub(crate) fn not_borne_out(search: &Search<'_>, tried: &Tried, foretold: Foretold<'_>, least: f64) -> Vec<Number> {
    let effects = tried.effects.iter().map(|e| search.library[*e]);
    let mut open: Vec<Number> = effects.flat_map(|effect| free_to_be_nothing(effect, search.context)).collect();
    let (mut held, mut best) = (Vec::new(), foretold(search, tried));
    let doubtful = on_a_limit(search, tried);
    // one at a time, the one without which most is gained
    while let Some((place, predicted)) = best_without_one(search, tried, foretold, (&open, &held), &best, (&doubtful, least)) {
        held.push(open.remove(place));
        best = predicted;
    }
    held
}

/// Numbers of effects that lie on a bound, where the fit says that the law does not hold, or that are not told from a bound at nothing.
fn on_a_limit(search: &Search<'_>, tried: &Tried) -> Vec<(EffectId, String)> {
    let model = search.model(&tried.effects);
    let of_effect = |(index, effect): (usize, &&dyn Effect)| {
        let values = model.values(&tried.fit.z);
        let near_nothing = |place: usize| {
            let parameter = &model.parameters[place];
            parameter.bounds.0 == 0.0
                && values[place] < TOLD_FROM_NOTHING * tried.fit.sd[place] * parameter.prior.slope(tried.fit.z[place])
        };
        let at_limit = model.range_of(index).filter(|place| tried.fit.at_limit[*place] || near_nothing(*place));
        at_limit.map(|place| (effect.id(), model.parameters[place].name.clone())).collect::<Vec<_>>()
    };
    model.effects.iter().enumerate().flat_map(of_effect).collect()
}

/// The number of `open` that is best held besides those of `held`, and what the model then foretells; `None` where that is not better than `best` by as much as is asked for, or for a `doubtful` one clearly worse.
fn best_without_one(
    search: &Search<'_>,
    tried: &Tried,
    foretold: Foretold<'_>,
    (open, held): (&[Number], &[Number]),
    best: &HeldOutFit,
    (doubtful, least): (&[(EffectId, String)], f64),
) -> Option<(usize, HeldOutFit)> {
    let without = |one: &Number| {
        let context = search.context.holding([held, &[*one]].concat());
        let fewer = search.within(&context);
        Some(foretold(&fewer, &refitted(&fewer, tried)?))
    };
    let better = open.iter().enumerate().filter_map(|(place, one)| {
        let predicted = without(one)?;
        let [before, after] = compared(best, &predicted)?.rmse;
        // on its bound a number has to be felt to be told
        let on_its_bound = doubtful.iter().any(|(id, name)| (*id, name.as_str()) == *one);
        let least = if on_its_bound { CLEARLY_WORSE.recip() } else { least };
        (before > least * after).then_some((after, (place, predicted)))
    });
    better.min_by(|a, b| a.0.total_cmp(&b.0)).map(|(_, found)| found)
}

/// The models that hold one of these numbers, fitted again without it; those that play no part stay as they are.
pub(crate) fn with_held(search: &Search<'_>, mut selection: Selection, held: &[Number]) -> Selection {
    let concerned = |tried: &Tried| tried.effects.iter().any(|e| held.iter().any(|(id, _)| *id == search.library[*e].id()));
    for (tried, probability) in selection.models.iter_mut().zip(&selection.probability) {
        if *probability > REFITTED_FROM && concerned(tried) {
            *tried = refitted(search, tried).unwrap_or_else(|| tried.clone());
        }
    }
    selection
}
