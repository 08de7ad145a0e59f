//! An effect without which the others predict rows left out better is not claimed beside them.
//!
//! A fuller model is likelier because it fits the rows that it has seen. Where the physics is right it foretells the others, too. One effect is left out after another,
//! each time the one that costs most, by the rule of [`crate::validation::veto`]; the smaller model takes the place that the base model has there. Where all of them
//! together predict rows left out worse than the base model does, one may be to blame: then it is enough that they are predicted better without it.
//!
//! Where the noise was not measured, nothing says how it lasts, and a course of the noise looks like a small effect. There an effect must be felt in the error on rows left out.
//!
//! Limits: only models that the search has fitted; a number for whatever happens foretells nothing and is not judged.

use crate::{
    selection::{candidates::Tried, posterior::Selection},
    validation::{
        cross_validation::{HeldOutFit, compared},
        veto::{Against, Unseen, little},
    },
};

/// An effect that is not claimed.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct LeftOut {
    /// index into the library
    pub effect: usize,
    /// what rows left out say
    pub against: Against,
}

/// The model to stand behind instead of `start`, its predictions of rows left out, and what was left out on the way. Where the noise was not measured, `enough` says whether a model leaves
/// little enough to be named by itself: else what is hardly felt explains the rest all the same.
pub(crate) fn step_back(
    selection: &Selection,
    start: (usize, HeldOutFit),
    base: &HeldOutFit,
    unseen: impl Fn(&Tried) -> HeldOutFit,
    free_form: impl Fn(usize) -> bool,
    enough: Option<impl Fn(usize) -> bool>,
) -> (usize, HeldOutFit, Vec<LeftOut>) {
    let ((mut model, mut named), mut left_out) = (start, Vec::new());
    // small gains are counted together: each is little beside the rest, and all of them may not be
    let mut nearest = named.clone();
    loop {
        let effects = &selection.models[model].effects;
        let with = || (named.clone(), &selection.models[model].fit);
        let all = Unseen::of((base.clone(), &selection.base().fit), with());
        let doubtful = all.worse().is_some() || all.larger();
        let smaller = |effect: &usize| {
            let others: Vec<usize> = effects.iter().copied().filter(|e| e != effect).collect();
            let place = selection.models.iter().position(|m| m.key() == others.as_slice().into())?;
            (!others.is_empty() && !free_form(*effect)).then_some((*effect, place))
        };
        let judged = effects.iter().filter_map(smaller).filter_map(|(effect, place)| {
            let without = &selection.models[place];
            let both = Unseen::of((unseen(without), &without.fit), with());
            let better =
                || compared(&both.base, both.named.as_ref()?).map(|both| both.rmse).filter(|[without, with]| without < with);
            let stands = || {
                let beside = Unseen::of((base.clone(), &selection.base().fit), (both.base.clone(), &without.fit));
                beside.worse().is_none() && enough.as_ref().is_some_and(|enough| enough(place))
            };
            let little = || little(&both.base, &nearest).filter(|_| stands());
            let doubted = || if doubtful { better().map(Against::Errors) } else { None };
            let against = both.worse().or_else(doubted).or_else(little)?;
            Some((place, both.base, LeftOut { effect, against }))
        });
        let cost = |left: &LeftOut| left.against.cost();
        let dearer = |a: (u8, f64), b: (u8, f64)| a.0.cmp(&b.0).then(a.1.total_cmp(&b.1));
        let Some((place, without, left)) = judged.max_by(|a, b| dearer(cost(&a.2), cost(&b.2))) else {
            return (model, named, left_out);
        };
        if !matches!(left.against, Against::Little(_)) {
            nearest = without.clone();
        }
        (model, named) = (place, without);
        left_out.push(left);
    }
}
