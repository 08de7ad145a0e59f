//! The part of the pipeline that decides from evidence: fits, probabilities, adequacy, verdict. Recordings and simulated ones ([`crate::validation::recovery`]) go through the same.
//!
//! Limits: noise, block averages and directions are given; what rows left out change of the decision comes after it, and for recordings alone.

use crate::{
    adequacy::lack_of_fit::{Adequacy, LackOfFitTests},
    selection::tuning::{VISIBLE, VISIBLE_SHARE},
    selection::{
        candidates::{Search, Tried},
        detectability::detectability,
        effect_set::EffectSet,
        posterior::{Selection, select},
        tempering::expected,
        unmodelled::Causes,
        verdict::{Decision, decide, interrupted, stated},
    },
};
use std::sync::atomic::Ordering;
use truegap_core::SimulationError;

/// What was found before it is put into words.
#[derive(Clone)]
pub struct Examined {
    /// models and probabilities
    pub selection: Selection,
    /// adequacy of the base model
    pub before: Adequacy,
    /// adequacy of the likeliest model that names something; of the base model where nothing was fitted
    pub after: Adequacy,
    /// verdict
    pub decision: Decision,
}

impl Examined {
    /// The same decision on the list of models that `change` makes of its own: their order may have changed.
    #[must_use]
    pub fn with(self, change: impl FnOnce(Selection) -> Selection) -> Self {
        let key = self.selection.models[self.decision.model].key();
        let selection = change(self.selection);
        let decision = Decision { model: selection.place_of(key), ..self.decision };
        Self { selection, decision, ..self }
    }
}

/// Fits, weighs and decides.
///
/// # Errors
/// Those of the simulator at the centre of the prior.
pub fn examine(search: &Search<'_>, lack_of_fit: &LackOfFitTests) -> Result<Examined, SimulationError> {
    let selection = select(search, lack_of_fit, search.base()?);
    let nothing = expected(selection.models.iter(), &search.library).map_or(0.0, |m| m.fit.objective());
    let causes = Causes::new(search.problem, search.whitener);
    let selection = selection.with_unmodelled(&causes, &search.library, lack_of_fit.slack());
    let temper = selection.temper;
    let simpler = |models: &[Tried], tried: &Tried| {
        let without = invisible(search, models, tried, nothing).map(|effect| tried.key().without(effect));
        with_a_simpler_law(search, models, tried, temper).into_iter().chain(without).collect()
    };
    Ok(judge(search, lack_of_fit, selection.merged(simpler)))
}

/// The verdict on a selection.
pub fn judge(search: &Search<'_>, lack_of_fit: &LackOfFitTests, selection: Selection) -> Examined {
    let named = stated(&selection).unwrap_or(selection.base);
    let before = lack_of_fit.adequacy(&selection.base().fit);
    let after = lack_of_fit.adequacy(&selection.models[named].fit);
    let stopped = search.stop.load(Ordering::Relaxed);
    let decision =
        if stopped { interrupted(&selection) } else { decide(&selection, &before, &after, |e| search.library[e].free_form()) };
    Examined { selection, before, after, decision }
}

/// The effects of a model with a simpler law in the place of one that holds it as a special case, where that fits as well: within [`VISIBLE`] deviations, tempered as the evidence is.
fn with_a_simpler_law(search: &Search<'_>, models: &[Tried], tried: &Tried, temper: f64) -> Option<EffectSet> {
    let simpler = |effect: &usize| {
        let simple = search.library.get(*effect)?.comes_down_to()?;
        let simple = search.library.iter().position(|other| other.id() == simple)?;
        let key: EffectSet = tried.key().without(*effect).iter().copied().chain([simple]).collect();
        let fits = models.iter().find(|model| model.key() == key)?;
        (2.0 * (fits.fit.objective() - tried.fit.objective()) < VISIBLE * VISIBLE * temper).then_some(key)
    };
    tried.effects.iter().find_map(simpler)
}

/// The effect of a model that stands least above the noise, and above the error of its equations, where that is not enough; `nothing` is the objective of the
/// model from which equations may be off.
///
/// An effect stands out by what the objective rises without it: exactly, where the model without it was fitted, else as its linear detectability has it.
fn invisible(search: &Search<'_>, models: &[Tried], tried: &Tried, nothing: f64) -> Option<usize> {
    let deviance = |objective: f64| (2.0 * (objective - tried.fit.objective())).max(0.0).sqrt();
    let needed = if tried.effects.len() > 1 { VISIBLE.max(VISIBLE_SHARE * deviance(nothing)) } else { VISIBLE };
    let without = |effect: usize| {
        let key = tried.key().without(effect);
        models.iter().find(|m| m.key() == key).map(|m| m.fit.objective())
    };
    let seen = (0..tried.effects.len()).filter_map(|index| {
        let exact = without(tried.effects[index]).map(deviance);
        Some((exact.or_else(|| detectability(search, tried, index))?, tried.effects[index]))
    });
    let least = seen.min_by(|a, b| a.0.total_cmp(&b.0));
    least.filter(|(d, _)| *d < needed).map(|(_, effect)| effect)
}
