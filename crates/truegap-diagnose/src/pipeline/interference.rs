//! Interference beside what a model names: a tone of the electronics takes nothing from an effect that leaves it as it was, and both are told.
//!
//! A ripple that follows the sensor is another matter: what stands beside it is a smaller part of what is missing.
//!
//! Limits: one tone, as strong and in step in all parts of the recording.

use crate::{
    adequacy::interference::{
        every_row::{Interference, Level},
        tone::Tone,
    },
    data::error::DiagnoseError,
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
    let residual = rows.left_by(stood_behind)?;
    let interference = rows.interference(&residual);
    let explained = stood_behind.fit.explains_beyond(&base.fit);
    let apart = rows.apart(interference.tone, (base, stood_behind), &residual)?;
    let decision = match interference.is_anything() {
        true => decision.clone().with_interference(selection.base, explained, interference.excess(apart)),
        false => decision.clone(),
    };
    Ok((interference, decision))
}

/// Bursts and a tone in what a model leaves of every row.
///
/// # Errors
/// Those of the simulator.
pub(crate) fn interference_beside(
    prepared: &Prepared<'_>,
    search: &Search<'_>,
    tried: &Tried,
) -> Result<Interference, DiagnoseError> {
    let rows = EveryRow { prepared, search };
    Ok(rows.interference(&rows.left_by(tried)?))
}

/// The decision where a line in the spectrum of what the likeliest model leaves is the electronics' own tone, and no doubt of that model.
pub(crate) fn beside_a_tone(prepared: &Prepared<'_>, search: &Search<'_>, examined: Examined) -> Result<Examined, DiagnoseError> {
    let Examined { selection, before, after, .. } = &examined;
    let asked = stated(selection).filter(|_| after.fires() && !search.stop.load(Ordering::Relaxed));
    let Some(named) = asked.map(|model| &selection.models[model]) else { return Ok(examined) };
    let rows = EveryRow { prepared, search };
    let residual = rows.left_by(named)?;
    let tone = rows.interference(&residual).tone;
    if !rows.apart(tone, (selection.base(), named), &residual)? {
        return Ok(examined);
    }
    let blocks = (prepared.problem.inputs.run.len() as f64 / named.fit.residual.len() as f64).round();
    let after = after.without_line(tone.per_row * blocks);
    let decision = decide(selection, before, &after, |e| search.library[e].free_form());
    Ok(Examined { after, decision, ..examined })
}

/// What models leave of every row.
struct EveryRow<'s, 'a> {
    prepared: &'s Prepared<'a>,
    search: &'s Search<'s>,
}

impl EveryRow<'_, '_> {
    /// The whitened residual.
    fn left_by(&self, tried: &Tried) -> Result<Vec<f64>, DiagnoseError> {
        let model = self.search.model_over(self.prepared.problem, &tried.effects);
        Ok(model.residual(&tried.fit.z, &self.prepared.noise.whitener(&self.prepared.problem.runs(), None))?)
    }

    fn interference(&self, residual: &[f64]) -> Interference {
        let problem = self.prepared.problem;
        let level = Level {
            slack: self.prepared.lack_of_fit.slack(),
            steps: self.prepared.noise.burst_of_steps(),
            is_known: self.prepared.noise_is_known(),
        };
        Interference::of(residual, problem.inputs, &problem.runs_in_order(), level)
    }

    /// Whether the tone is another wave of a cycle that is named, or the electronics' own, and what the `named` model explains, which leaves `residual`, is not taken from it.
    fn apart(&self, tone: Tone, (base, named): (&Tried, &Tried), residual: &[f64]) -> Result<bool, DiagnoseError> {
        let problem = self.prepared.problem;
        let period = |effect: &usize| self.search.library[*effect].comes_back_s();
        if let Some(frequency) = tone.frequency_hz
            && named
                .effects
                .iter()
                .filter_map(period)
                .any(|period| is_overtone(frequency, period, self.prepared.context.duration_s))
        {
            return Ok(true);
        }
        if !tone.steady || named.effects.is_empty() {
            return Ok(false);
        }
        let power = |residual: &[f64]| tone.power_in(residual, problem.inputs.time_s.as_deref(), &problem.runs_in_order());
        Ok(power(&self.left_by(base)?) - power(residual) <= (1.0 - RIGHT_FAMILY) * named.fit.explains_beyond(&base.fit))
    }
}

/// Most waves of one cycle: a shape of hours in a day.
const MOST_WAVES: f64 = 12.0;

/// Whether a line at this `frequency`, Hz, is a multiple of that of a `period`, s, as far as a recording of `duration_s` tells frequencies apart.
fn is_overtone(frequency: f64, period: f64, duration_s: f64) -> bool {
    let times = (frequency * period).round();
    (1.0..=MOST_WAVES).contains(&times) && (frequency - times / period).abs() * duration_s < 1.0
}

#[cfg(test)]
mod tests {
    use super::*;

    /// People in a street by the hour, for 39 days: a line of 8 hours was something in the reading that no library knows, and took the day with it.
    #[test]
    fn a_line_of_eight_hours_is_a_wave_of_the_day() {
        let (day, hour) = (86_400.0, 3600.0);
        let found = |hours: f64| is_overtone(1.0 / (hours * hour), day, 39.0 * day);
        assert!(found(8.0) && found(24.0) && found(6.0) && !found(7.0) && !found(9.6) && !found(1.5));
    }
}
