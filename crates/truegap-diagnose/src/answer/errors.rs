//! Errors in sample and on rows left out, before and after what is named was added.
//!
//! Limits: an error stands for the rows that both models predict; where there is none, it is absent.

use crate::{
    answer::tuning::{LIKE_NOISE, MOSTLY_ABSORBED},
    answer::{
        fit_facts::{BeforeAfter, FitFacts, HeldOut, RecordingError, SelectedAgain, SelectedWithout},
        found::Found,
    },
    explain::conflicts::Conflict,
    selection::{candidates::Tried, effect_set::EffectSet, start::zero_size, verdict::Verdict},
    stats::{rmse, rmse_of_both},
    validation::{
        cross_validation::{HeldOutFit, PartError, compared, held_out, misfit_removed, part_error},
        permutation::permuted,
        selected_again::ChosenWithout,
    },
};
use truegap_core::SimulationError;

/// Response of every row, as `tried` has it.
///
/// # Errors
/// Those of the simulator: block averages may have an answer where a single row has none.
pub(crate) fn respond(found: &Found<'_>, tried: &Tried) -> Result<Vec<f64>, SimulationError> {
    found.search.model_over(found.all.problem, &tried.effects).respond(&tried.fit.z)
}

/// Predictions of rows left out, as `tried` makes them.
pub(crate) fn unseen(found: &Found<'_>, tried: &Tried) -> HeldOutFit {
    held_out(found.search, found.searched_noise, tried, found.all)
}

/// What an added term of equal freedom removes when its history is permuted.
pub(crate) fn permutation_control(found: &Found<'_>, tried: &Tried) -> Option<f64> {
    let problem = found.search.problem;
    permuted(&found.selection.base().fit, &tried.fit, &problem.runs_of_recordings(), &problem.inputs.run)
}

/// Root-mean-square errors of two predictions of every row.
pub(crate) fn in_sample(found: &Found<'_>, before: &[f64], after: &[f64]) -> Option<BeforeAfter> {
    let response = found.all.told();
    let error = |prediction: &[f64]| rmse(prediction, &response, 0..response.len());
    Some(BeforeAfter { rmse_before: error(before)?, rmse_after: error(after)? })
}

/// Errors of the calibrated base model and of the model stood behind; `before` and `after` are their predictions of rows left out.
pub(crate) fn fit_facts(found: &Found<'_>, in_sample: BeforeAfter, before: &HeldOutFit, after: &HeldOutFit) -> FitFacts {
    let floor = found.noise.floor();
    let both = compared(before, after);
    let named = !found.chosen().effects.is_empty();
    let removed = both.as_ref().and_then(|c| misfit_removed(c.rmse[0], c.rmse[1], floor, found.noise.rows));
    FitFacts {
        in_sample,
        held_out: HeldOut {
            how: after.how.clone(),
            rmse_before: both.as_ref().map(|c| c.rmse[0]),
            rmse_after: both.as_ref().map(|c| c.rmse[1]),
            misfit_removed: removed.filter(|_| named),
            permutation_control: if named { permutation_control(found, found.chosen()) } else { None },
            parts: both.map(|c| c.parts).unwrap_or_default(),
            recordings: by_recording(found, before, after),
            selected_again: found.selected_again.as_deref().map(|chosen| selected_again(found, chosen)),
        },
        noise_floor: floor,
        unit: found.search.problem.simulator.unit().to_owned(),
    }
}

/// The choices made without each part, counted and with their errors.
fn selected_again(found: &Found<'_>, chosen: &[ChosenWithout]) -> SelectedAgain {
    let stood_behind = found.chosen().key();
    let same = chosen.iter().filter(|c| EffectSet::from(c.effects.as_slice()) == stood_behind).count();
    let response = found.all.told();
    let error = |c: &ChosenWithout| part_error(&c.part, c.prediction.as_deref(), &response);
    let errors: Vec<PartError> = chosen.iter().map(error).collect();
    let part = |(c, error): (&ChosenWithout, &PartError)| SelectedWithout {
        part: error.name.clone(),
        verdict: c.verdict,
        named: c.effects.iter().map(|e| found.id(*e)).collect(),
        rmse: error.rmse(),
    };
    let what = if stood_behind.is_empty() { "nothing is named" } else { "the same is named" };
    SelectedAgain {
        says: format!("chosen again without each part of the recording, {what} {same} of {} times", chosen.len()),
        same,
        rmse: PartError::rmse_over(&errors),
        parts: chosen.iter().zip(&errors).map(part).collect(),
    }
}

/// Errors on rows left out, of each of several recordings.
fn by_recording(found: &Found<'_>, before: &HeldOutFit, after: &HeldOutFit) -> Vec<RecordingError> {
    let problem = found.all.problem;
    let Some(joined) = problem.simulator.joined() else { return Vec::new() };
    let error = |k: usize| {
        let rows = joined.rows(k, problem.inputs);
        let both = rmse_of_both([&before.prediction, &after.prediction], problem.response, rows.clone());
        RecordingError {
            recording: k + 1,
            rmse_before: both.map(|b| b[0]),
            rmse_after: both.map(|b| b[1]),
            noise_floor: found.noise.floor_of(rows),
        }
    };
    (0..joined.count()).map(error).collect()
}

/// Calibration hid the effect: most of its raw size is gone from the residual, or parameters are pushed away.
pub(crate) fn concealed(found: &Found<'_>, conflicts: &[Conflict], fit: &FitFacts) -> bool {
    if found.reserved.as_ref().is_some_and(|r| r.withheld) {
        return false;
    }
    let clean = fit.in_sample.rmse_before < LIKE_NOISE * fit.noise_floor;
    let mismatch = found.decision.verdict != Verdict::Agrees;
    clean && (!conflicts.is_empty() || (mismatch && absorbed_share(found) > MOSTLY_ABSORBED))
}

/// Share of the raw effect that the base parameters absorb.
fn absorbed_share(found: &Found<'_>) -> f64 {
    let chosen = found.chosen();
    if chosen.effects.is_empty() {
        return 0.0;
    }
    let model = found.search.model(&chosen.effects);
    let mut without = chosen.fit.z.clone();
    (0..chosen.effects.len()).for_each(|i| without[model.first_of(i)] = zero_size(&model, i));
    let Ok(there) = model.residual(&without, found.search.whitener) else { return 0.0 };
    let raw: f64 = there.iter().zip(chosen.fit.residual.iter()).map(|(a, b)| (a - b).powi(2)).sum();
    let left = (found.selection.base().fit.chi2 - chosen.fit.chi2).max(0.0);
    if raw > 0.0 { 1.0 - (left / raw).sqrt().min(1.0) } else { 0.0 }
}
