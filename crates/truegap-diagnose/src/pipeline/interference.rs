//! Interference beside what a model names: a tone of the electronics takes nothing from an effect that leaves it as it was, and both are told.
//!
//! A ripple that follows the sensor is another matter: what stands beside it is a smaller part of what is missing.
//!
//! Limits: one tone, as strong and in step in all parts of the recording.

use crate::{
    adequacy::interference::every_row::Interference,
    data::error::DiagnoseError,
    fit::model::Model,
    pipeline::prepare::Prepared,
    selection::{
        candidates::{Search, Tried},
        examine::Examined,
        tuning::RIGHT_FAMILY,
        verdict::{Decision, decide, stated},
    },
};
use std::sync::atomic::Ordering;

/// Bursts and a tone in what the model stood behind leaves of every row, and the decision with them counted.
pub(crate) fn with_interference(
    prepared: &Prepared<'_>,
    search: &Search<'_>,
    examined: &Examined,
) -> Result<(Interference, Decision), DiagnoseError> {
    let Examined { selection, decision, .. } = examined;
    let rows = EveryRow { prepared, search };
    let (base, stood_behind) = (selection.base(), &selection.models[decision.model]);
    let interference = rows.left_by(stood_behind)?;
    let explained = 2.0 * (base.fit.objective() - stood_behind.fit.objective());
    let apart = rows.apart(&interference, (base, stood_behind))?;
    let decision = match interference.is_anything() {
        true => decision.clone().with_interference(selection.base, explained, interference.excess(apart)),
        false => decision.clone(),
    };
    Ok((interference, decision))
}

/// The decision where a line in the spectrum of what the likeliest model leaves is the electronics' own tone, and no doubt of that model.
pub(crate) fn beside_a_tone(prepared: &Prepared<'_>, search: &Search<'_>, examined: Examined) -> Result<Examined, DiagnoseError> {
    let Examined { selection, before, after, .. } = &examined;
    let asked = stated(selection).filter(|_| after.fires() && !search.stop.load(Ordering::Relaxed));
    let Some(named) = asked.map(|model| &selection.models[model]) else { return Ok(examined) };
    let rows = EveryRow { prepared, search };
    let interference = rows.left_by(named)?;
    if !rows.apart(&interference, (selection.base(), named))? {
        return Ok(examined);
    }
    let blocks = (prepared.problem.inputs.run.len() as f64 / named.fit.residual.len() as f64).round();
    let after = after.without_line(interference.tone.per_row * blocks);
    let decision = decide(selection, before, &after, |e| search.library[e].free_form());
    Ok(Examined { after, decision, ..examined })
}

/// What models leave of every row.
struct EveryRow<'s, 'a> {
    prepared: &'s Prepared<'a>,
    search: &'s Search<'s>,
}

impl EveryRow<'_, '_> {
    fn model(&self, tried: &Tried) -> Model<'_> {
        let effects = tried.effects.iter().map(|e| self.search.library[*e]).collect();
        Model::new(self.prepared.problem, self.search.context, effects)
    }

    fn left_by(&self, tried: &Tried) -> Result<Interference, DiagnoseError> {
        let known = (self.prepared.lack_of_fit.slack(), self.prepared.noise_is_known());
        Ok(Interference::in_what_is_left(&self.model(tried), &tried.fit.z, &self.prepared.noise, known)?)
    }

    /// Whether the tone is the electronics' own, and what the `named` model explains is not taken from it.
    fn apart(&self, interference: &Interference, (base, named): (&Tried, &Tried)) -> Result<bool, DiagnoseError> {
        if !interference.tone.steady || named.effects.is_empty() {
            return Ok(false);
        }
        let of = |tried: &Tried| interference.of_the_tone(&self.model(tried), &tried.fit.z, &self.prepared.noise);
        let explained = 2.0 * (base.fit.objective() - named.fit.objective());
        Ok(of(base)? - of(named)? <= (1.0 - RIGHT_FAMILY) * explained)
    }
}
