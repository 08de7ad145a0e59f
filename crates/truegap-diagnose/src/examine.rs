//! The part of the pipeline that decides: fits, probabilities, adequacy, verdict. Recordings and simulated ones ([`crate::bank`]) go through the same.
//!
//! Limits: noise, thinned rows and directions are given.

use crate::{
    detectability::detectability,
    gate::{Adequacy, Gate},
    search::{Search, Tried},
    select::{Selection, select},
    verdict::{Decision, decide, interrupted},
};
use std::sync::atomic::Ordering;
use truegap_core::SimulationError;

/// Detectability below which an effect of a larger model is not claimed.
const VISIBLE: f64 = 4.5;

/// What was found before it is put into words.
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

/// Fits, weighs and decides.
///
/// # Errors
/// Those of the simulator at the centre of the prior.
pub fn examine(search: &Search<'_>, gate: &Gate) -> Result<Examined, SimulationError> {
    let base = search.base()?;
    Ok(judge(search, gate, select(search, base).merged(|tried| hidden(search, tried))))
}

/// The verdict on a selection.
pub fn judge(search: &Search<'_>, gate: &Gate, selection: Selection) -> Examined {
    let named = selection.models.iter().position(|m| !m.effects.is_empty()).unwrap_or(selection.base);
    let before = gate.adequacy(&selection.base().fit);
    let after = gate.adequacy(&selection.models[named].fit);
    let stopped = search.stop.load(Ordering::Relaxed);
    let decision = if stopped { interrupted(&selection) } else { decide(&selection, &before, &after) };
    Examined { selection, before, after, decision }
}

/// The effect of a model that stands least above the noise, where that is not enough.
fn hidden(search: &Search<'_>, tried: &Tried) -> Option<usize> {
    let seen = (0..tried.effects.len()).map(|index| (detectability(search, tried, index), tried.effects[index]));
    seen.min_by(|a, b| a.0.total_cmp(&b.0)).filter(|(d, _)| *d < VISIBLE).map(|(_, effect)| effect)
}
