//! How much less differences in evidence count, because the equations of the library may be off.
//!
//! Limits: one divisor for all models of a recording.

use crate::{
    adequacy::lack_of_fit::LackOfFitTests,
    effects::effect::Effect,
    selection::candidates::Tried,
    selection::tuning::{ABSORBED_PART, FORM_ERROR, FORM_SHAPES, MOSTLY_FORESEEN},
};

/// Divisor of log evidence: the right physics written with another equation leaves `FORM_ERROR` of its signal over `FORM_SHAPES` shapes, and evidence between
/// models must not rest on less than that.
///
/// The signal is what the best of the models explains, beyond what was foreseen. Parameters pushed away from what is known of them are misfit too: calibration may
/// have absorbed most of it there. How wrong the equations can be shows in what the best model leaves: its parameters may absorb all but one part in `ABSORBED_PART`.
pub(crate) fn temper_of<'t>(
    models: impl Iterator<Item = &'t Tried> + Clone,
    library: &[&dyn Effect],
    lack_of_fit: &LackOfFitTests,
) -> f64 {
    let Some(best) = least(models.clone()) else { return 1.0 };
    let nothing = expected(models, library).map_or(0.0, |m| m.fit.objective());
    let signal = 2.0 * (nothing - best.fit.objective()).max(0.0);
    let error = FORM_ERROR * FORM_ERROR * signal;
    let shows = if error > ABSORBED_PART { ABSORBED_PART * lack_of_fit.may_leave(&best.fit) } else { f64::INFINITY };
    1.0 + error.min(shows) / FORM_SHAPES
}

/// The model of the lowest objective.
pub(crate) fn least<'t>(models: impl Iterator<Item = &'t Tried>) -> Option<&'t Tried> {
    models.min_by(|a, b| a.fit.objective().total_cmp(&b.fit.objective()))
}

/// The model from which equations may be off: the base model, or that with nothing but effects that were computed beforehand, where those are most of what is
/// missing. They carry the error of their computation, some per cent, and not that of an equation chosen for its simplicity.
pub(crate) fn expected<'t>(models: impl Iterator<Item = &'t Tried> + Clone, library: &[&dyn Effect]) -> Option<&'t Tried> {
    let base = models.clone().find(|m| m.effects.is_empty())?;
    let lowest = least(models.clone())?.fit.objective();
    let computed = models.filter(|m| m.effects.iter().all(|e| library[*e].foreseen()));
    let best = least(computed)?;
    let most = base.fit.objective() - best.fit.objective() > MOSTLY_FORESEEN * (base.fit.objective() - lowest);
    Some(if most { best } else { base })
}
