//! The simple laws that effects hold as special cases, where rows left out do not bear out the richer ones.
//!
//! Limits: numbers that their effects name as such; effects of the library.

use crate::{
    data::context::Number,
    pipeline::{
        calibrated::{ByBase, predicted_like_base, predictions},
        judged::{Judged, Told},
        prepare::Prepared,
    },
    selection::{
        candidates::{Search, Tried},
        refitted::refitted,
        verdict::Decision,
    },
    validation::{
        among_rivals::{first_of_each, rivals},
        cross_validation::{HeldOutFit, compared},
        held_numbers::not_borne_out,
        tuning::CLEARLY_WORSE,
    },
};
use std::sync::atomic::Ordering;

/// A model with the simple laws that its effects hold as special cases, where rows left out do not bear out the richer ones.
pub(crate) struct Simple {
    /// the model
    pub tried: Tried,
    /// numbers that are held at nothing
    pub held: Vec<Number>,
    /// what it foretells of rows left out
    pub unseen: HeldOutFit,
}

/// A model with the laws that rows left out bear out, which are predicted `least` times better or more without what is held; `None` where it has no answer with them.
pub(crate) fn simple(
    prepared: &Prepared<'_>,
    search: &Search<'_>,
    by_base: &ByBase,
    tried: &Tried,
    least: f64,
) -> Option<Simple> {
    let foretold = |search: &Search<'_>, tried: &Tried| predicted_like_base(prepared, search, by_base, tried);
    let held = not_borne_out(search, tried, &foretold, least);
    let held = [search.context.held.as_slice(), &held].concat();
    let context = search.context.holding(held.clone());
    let narrow = search.within(&context);
    let tried = if held.is_empty() { tried.clone() } else { refitted(&narrow, tried)? };
    let unseen = predictions(prepared, &narrow, by_base, &tried);
    Some(Simple { tried, held, unseen })
}

/// What is stood behind with the simple laws that foretell rows left out as well, once it is decided what that is, and the decision for it. A rival that foretells clearly better with its own simple laws
/// takes the place: a richer law may have hidden it. `None` where no number is held for it, where mechanisms of words are part of it, or where the base model has plates.
pub(crate) fn told_simply(prepared: &Prepared<'_>, told: &Told<'_>, judged: &Judged) -> Option<(Simple, Decision)> {
    let (selection, decision) = (&judged.examined.selection, &judged.predicted.decision);
    let chosen = &selection.models[decision.model];
    let of_library = !chosen.effects.is_empty() && chosen.effects.iter().all(|e| *e < prepared.testable.len());
    let derived = prepared.context.has_plates();
    if derived || !of_library || told.stop.load(Ordering::Relaxed) {
        return None;
    }
    let searched = prepared.searched();
    let context = prepared.context.holding(judged.held.clone());
    let search = prepared.search(&searched, told.progress, told.stop);
    let search = search.within(&context);
    let simple = |tried: &Tried| simple(prepared, &search, &judged.by_base, tried, 1.0);
    let named = simple(chosen)?;
    // held by what it foretells where it is calibrated as the base model is told; told by the better of two ways to calibrate
    let as_told = judged.predicted.unseen.stood_behind();
    let [before, after] = compared(as_told, &named.unseen)?.rmse;
    let taken = named.held.len() > judged.held.len() && after <= before;
    let rivals = rivals(selection, decision.model, &decision.sets).into_iter();
    let others = rivals.filter_map(|model| Some((model, simple(&selection.models[model])?)));
    let clearly_better = |(_, other): &(usize, Simple)| {
        let both = compared(if taken { &named.unseen } else { as_told }, &other.unseen);
        both.map(|both| both.rmse).filter(|[own, other]| *own > CLEARLY_WORSE * other).map(|[_, other]| other)
    };
    let better = others.filter_map(|other| Some((clearly_better(&other)?, other)));
    match better.min_by(|a, b| a.0.total_cmp(&b.0)) {
        Some((_, (model, other))) => {
            let sets = first_of_each(&decision.sets, &selection.models[model].effects);
            Some((other, Decision { model, sets, ..decision.clone() }))
        }
        None => taken.then(|| (named, decision.clone())),
    }
}

impl Judged {
    /// The same with simple laws in the model that is stood behind by this decision.
    pub(crate) fn with_simple_laws(mut self, prepared: &Prepared<'_>, simple: Simple, decision: Decision) -> Self {
        let Simple { tried, held, unseen } = simple;
        let after = prepared.lack_of_fit.adequacy(&tried.fit);
        self.predicted.decision = decision.clone();
        self.stands_behind(tried, held, unseen, after, |model, _| Decision { model, ..decision })
    }
}
