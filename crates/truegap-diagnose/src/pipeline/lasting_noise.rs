//! What is named beside a noise that nobody measured is compared with a noise that lasts.
//!
//! A noise that was not measured is read from short stretches, which know nothing of a wander over many rows. Every law with a few numbers takes some of such a wander, and many squares of that noise with it; and since the wander
//! goes to and fro a dozen times and not a thousand, rows left out may be predicted better by chance. So what is named is weighed once more: the base model beside white noise and a wander of one memory, each
//! of any size, against the model that is named, under its own noise or beside such a wander as well. Where the base model is much likelier, nothing is named. Physics that adds something to a wander stands.
//!
//! **Source:** Nelson & Kang, Econometrica 49 (1981) 741, for laws that a wander mimics; Durbin & Koopman, Time Series Analysis by State Space Methods, section 2.1.
//!
//! Limits: one recording with a clock, and no base model with plates; all that is named together; one memory.

use crate::{
    data::error::DiagnoseError,
    discovery::discover::with_mechanisms,
    fit::{levenberg_marquardt::FitOptions, maximum_a_posteriori::fit, model::Model, optimum::Fit, under_noise::UnderNoise},
    pipeline::{
        interference::interference_beside,
        judged::{Judged, Told},
        noise_choice::prior_of,
        noise_that_lasts::is_noise,
        prepare::Prepared,
        wanders::{evidence, memories, with_lasting, with_walk},
    },
    selection::{
        candidates::{Search, Tried},
        tuning::{RIGHT_FAMILY, RIVAL, WALKS},
    },
    stats::{median, rms},
    validation::cross_validation::compared,
    whitening::{
        noise_model::NoiseModel,
        whitener::{Lasting, Whitener},
    },
};
use std::sync::atomic::Ordering;

/// The same, without what is named where a noise that lasts is much likelier.
///
/// # Errors
/// Those of the simulator.
pub(crate) fn beside_lasting_noise(prepared: &Prepared<'_>, told: &Told<'_>, judged: Judged) -> Result<Judged, DiagnoseError> {
    let asked = !prepared.noise.measured && judged.kept_back.is_none() && judged.names_something();
    let alone = prepared.problem.is_one_with_a_clock();
    // with plates the equations are derived: what they explain is weighed by causes outside the library alone
    let derived = prepared.context.has_plates();
    if !asked || !alone || derived || told.stop.load(Ordering::Relaxed) {
        return Ok(judged);
    }
    let both = compared(&judged.by_base.unseen, judged.predicted.unseen.stood_behind());
    if both.is_some_and(|both| foretells_most(both.rmse)) {
        return Ok(judged);
    }
    let Some((odds, comes_back)) = log_odds(prepared, told, &judged)?.filter(|(odds, _)| *odds > -RIVAL.ln()) else {
        return Ok(judged);
    };
    let judged = judged.told_as_a_walk(odds);
    let searched = prepared.searched();
    let search = &prepared.search(&searched, told.progress, told.stop);
    let interference = interference_beside(prepared, search, judged.examined.selection.base()).ok();
    match interference.filter(|found| comes_back && is_noise(prepared, &judged, found)) {
        Some(interference) => Ok(judged.told_as_noise(prepared, interference)),
        None => Ok(judged),
    }
}

/// Whether rows left out are predicted so much better with what is named, by these errors without and with it, that no wander does as much: none is foretold beyond its memory.
fn foretells_most([before, after]: [f64; 2]) -> bool {
    after.powi(2) <= (1.0 - RIGHT_FAMILY) * before.powi(2)
}

/// Log odds of the base model beside a wander against what is named, and whether that wander comes back often.
fn log_odds(prepared: &Prepared<'_>, told: &Told<'_>, judged: &Judged) -> Result<Option<(f64, bool)>, DiagnoseError> {
    let searched = prepared.searched();
    let context = prepared.context.holding(judged.held.clone());
    let mechanisms = judged.composition.as_ref().map_or(&[][..], |c| c.mechanisms.as_slice());
    let search = &with_mechanisms(&prepared.search(&searched, told.progress, told.stop), mechanisms);
    let search = search.within(&context);
    let named = judged.stood_behind();
    let Some(base) = search.part_of(named, &[]) else { return Ok(None) };
    let odds = log_odds_of_a_wander(&search, &prepared.searched_noise, prepared.testable.len(), [&base, named])?;
    Ok(Some(odds))
}

/// The same of two fitted models, the base model and what is named, of a library of so many effects.
fn log_odds_of_a_wander(
    search: &Search<'_>,
    noise: &NoiseModel,
    library: usize,
    [base, named]: [&Tried; 2],
) -> Result<(f64, bool), DiagnoseError> {
    let without = wander(&search.model(&[]), &base.fit, noise)?;
    let beside = wander(&search.model(&named.effects), &named.fit, noise)?.log_evidence;
    let own = evidence(&named.fit, search.whitener);
    Ok((without.log_evidence - beside.max(own) - prior_of(library, named), without.comes_back))
}

/// A model beside the wander under which it is likeliest.
struct Wander {
    log_evidence: f64,
    /// whether a wander that comes back often is much likelier than one that goes on and on
    comes_back: bool,
}

/// The likeliest wander beside a model, and white noise.
fn wander(model: &Model<'_>, start: &Fit, noise: &NoiseModel) -> Result<Wander, DiagnoseError> {
    let weighed = UnderNoise::of(model, start)?;
    let size = rms(model.misfit(&start.z)?.into_iter());
    let runs = model.problem.runs();
    let time = model.problem.inputs.time_s.as_deref().unwrap_or(&[]);
    let span = |rows: &std::ops::Range<usize>| time[rows.end - 1] - time[rows.start];
    let longest = runs.iter().map(span).fold(0.0, f64::max);
    let steps: Vec<f64> = runs.iter().flat_map(|run| time[run.clone()].windows(2).map(|w| w[1] - w[0])).collect();
    let step = if steps.is_empty() { longest } else { median(&steps) };
    let filter = |memory: Option<f64>, ratio: f64, white: f64| {
        let noise = match memory {
            Some(memory) => with_lasting(noise, of_one_memory(time, memory, ratio * white), white),
            None => with_walk(noise, time, ratio * white, white),
        };
        noise.whitener(&runs, None)
    };
    let of = |memory: Option<f64>, ratio: f64| weighed.as_loud(size, |white| filter(memory, ratio, white));
    let best = |memory: Option<f64>| WALKS.map(|ratio| of(memory, ratio)).into_iter().max_by(|a, b| a.0.total_cmp(&b.0));
    let back = memories(step, longest).filter_map(|memory| best(Some(memory))).max_by(|a, b| a.0.total_cmp(&b.0));
    let on = best(None);
    let density = |one: &Option<(f64, f64, Whitener)>| one.as_ref().map_or(f64::NEG_INFINITY, |one| one.0);
    let comes_back = density(&back) > density(&on) - RIVAL.ln();
    let likeliest = [back, on].into_iter().flatten().max_by(|a, b| a.0.total_cmp(&b.0));
    let Some((.., filter)) = likeliest else { return Ok(Wander { log_evidence: f64::NEG_INFINITY, comes_back }) };
    let fit = fit(model, &filter, &start.z, &FitOptions::default())?;
    Ok(Wander { log_evidence: evidence(&fit, &filter), comes_back })
}

/// A wander of this memory, seconds, and standard deviation.
fn of_one_memory(time_s: &[f64], memory_s: f64, sd: f64) -> Lasting {
    let memory = |row: usize| match row.checked_sub(1) {
        Some(before) => (-(time_s[row] - time_s[before]).max(0.0) / memory_s).exp(),
        None => 0.0,
    };
    Lasting { variance: vec![sd * sd; time_s.len()], memory: (0..time_s.len()).map(memory).collect(), of_reading: true }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;
    use crate::{
        pipeline::wanders::tests::{NOISE, beside_a_drift, is_inverse, noise, settles},
        whitening::whitener::Noise,
    };
    use nalgebra::DMatrix;

    const ROWS: usize = 900;

    /// Covariance of a wander and white noise: `s^2 exp(-|t_i - t_j| / memory)`, and the white variance of one row; uneven rows.
    #[test]
    fn the_filter_of_a_wander_is_the_inverse_of_its_covariance() {
        let time: Vec<f64> = (0..40).map(|row| f64::from(row) + 3.0 * f64::from(row / 7)).collect();
        let (sd, white, memory) = (2.0, 0.3, 11.0);
        let of = |i: usize, j: usize| sd * sd * (-(time[i] - time[j]).abs() / memory).exp();
        let covariance = DMatrix::from_fn(40, 40, |i, j| of(i, j) + if i == j { white * white } else { 0.0 });
        let other = Noise { white_sd: 1.0, ar_sd: 0.5, ar_correlation: 0.9 };
        is_inverse(&with_lasting(&noise(40, other), of_one_memory(&time, memory, sd), white), covariance);
    }

    /// Log odds of a wander against a drift that is fitted to what `zero` adds to a plate, under white noise as short stretches have it.
    fn odds(seed: u64, zero: impl Fn(&[f64]) -> Vec<f64>) -> (f64, bool) {
        let short = Noise { white_sd: 1.3 * NOISE, ar_sd: 0.0, ar_correlation: 0.0 };
        beside_a_drift((seed, ROWS, short), zero, |search, noise, named| {
            log_odds_of_a_wander(search, noise, 1, [&search.base().unwrap(), named]).unwrap()
        })
    }

    /// A load that settles as the logarithm of the cycles was told as a wander, though it predicts rows left out with a sixth of the error; a wander of a receiver was predicted with seven tenths by three names.
    #[test]
    fn what_foretells_most_of_the_misfit_is_no_wander() {
        assert!(foretells_most([0.0662, 0.0116]) && !foretells_most([2.58, 1.81]));
    }

    #[test]
    fn a_wander_that_comes_back_is_no_drift_and_a_drift_is_none() {
        let memory = (-1.0f64 / 25.0).exp();
        for seed in 1..4 {
            let wander = |steps: &[f64]| {
                let step = |at: &mut f64, step: &f64| {
                    *at = memory * *at + 4.0 * NOISE * (1.0 - memory * memory).sqrt() * step;
                    Some(*at)
                };
                steps.iter().scan(0.0, step).collect()
            };
            let (found, comes_back) = odds(seed, wander);
            assert!(found > 0.0 && comes_back, "{seed}: {found}");
            let (found, _) = odds(seed, |_| settles(ROWS));
            assert!(found < RIVAL.ln(), "{seed}: {found}");
        }
    }
}
