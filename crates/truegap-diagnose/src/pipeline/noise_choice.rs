//! Which noise a recording has, where rest does not tell: the noise under which the likeliest account of the whole recording is likelier.
//!
//! Limits: noise with one memory against slow noise, and another memory only where slow noise would be taken or was; the accounts weighed are the base model, the likeliest model, either with its likeliest unmodelled cause, and the
//! mechanism composed of words.

use crate::{
    data::error::DiagnoseError,
    discovery::{
        compose::Composition,
        discover::{Discovery, with_mechanisms},
    },
    effects::effect::Effect,
    fit::{levenberg_marquardt::FitOptions, maximum_a_posteriori::fit, model::Model},
    noise::{
        beyond_the_ends::mirrored,
        slow_rivals::{lasting_rivals, memory_rivals, slow_rivals},
        tuning::CLEARLY_COLOURED,
    },
    pipeline::{judged::Told, prepare::Prepared},
    selection::{
        candidates::Tried,
        examine::Examined,
        posterior::Selection,
        prior::{log_prior, one_more},
        tuning::UNMODELLED_PRIOR,
        verdict::Verdict,
    },
    whitening::{noise_model::NoiseModel, whitener::Whitener},
};
use std::sync::atomic::Ordering;

/// Sentences that mechanisms are composed to, about: beforehand each is that much less likely than an effect of the library.
const SENTENCES: f64 = 5000.0;

/// The recording made ready once more, where slow noise makes it likelier than the noise that was taken: with the slow noise, or with one of another memory where that is likelier still. Where rest was taken for slow noise: with one
/// of a memory that rest allows, where that is likelier. `None` where no other noise is likelier, or where nothing differs anyway.
///
/// # Errors
/// Those of the simulator.
pub(crate) fn with_the_likelier_noise<'a>(
    prepared: &Prepared<'a>,
    examined: &Examined,
    composition: Option<&Composition>,
    told: &Told<'a>,
) -> Result<Option<Prepared<'a>>, DiagnoseError> {
    let lasts = prepared.noise.lasts();
    if examined.decision.verdict == Verdict::Agrees && !lasts || told.stop.load(Ordering::Relaxed) {
        return Ok(None);
    }
    let selection = &examined.selection;
    let mechanisms = composition.map_or(&[][..], |c| c.mechanisms.as_slice());
    let accounts = accounts(selection, composition);
    let misfits = accounts.iter().map(|tried| misfit(prepared, tried, mechanisms)).collect::<Result<Vec<_>, _>>()?;
    let Some(least) = misfits.last() else { return Ok(None) };
    let filter = |noise: &NoiseModel| noise.whitener(&prepared.problem.runs(), None);
    let lowest = |noise: &NoiseModel| {
        let filter = filter(noise);
        misfits.iter().map(|m| deviance(&filter, m)).fold(f64::INFINITY, f64::min)
    };
    let clean = mirrored(least, &prepared.problem.runs(), &prepared.noise.untold);
    let likeliest = |rivals: Vec<NoiseModel>| {
        let rivals = rivals.into_iter().map(|noise| (lowest(&noise), noise));
        rivals.min_by(|a, b| a.0.total_cmp(&b.0)).map(|(_, noise)| noise)
    };
    let every_row = filter(&prepared.noise);
    let of = |(tried, misfit): (&&Tried, &Vec<f64>)| {
        evidence(prepared, tried, deviance(&every_row, misfit)) + unmodelled(selection, tried)
    };
    let taken = accounts.iter().zip(&misfits).map(of).fold(f64::NEG_INFINITY, f64::max);
    let under = |noise: Option<NoiseModel>| {
        let weighed = |noise| likeliest_account(prepared, noise, &accounts, mechanisms, told);
        noise.map(weighed).transpose()
    };
    let clearly = |(log, _): &(f64, Prepared<'_>)| *log > taken + CLEARLY_COLOURED;
    if lasts {
        let of_one_memory = under(likeliest(lasting_rivals(prepared.problem, &prepared.noise)))?;
        return Ok(of_one_memory.filter(clearly).map(|(_, of_one_memory)| of_one_memory));
    }
    let slower = under(likeliest(slow_rivals(prepared.problem, &clean, &prepared.noise)))?;
    let Some((slow, slower)) = slower.filter(clearly) else { return Ok(None) };
    // short stretches at rest do not tell one memory from none either, and slow noise would win by what any memory gains
    match under(likeliest(memory_rivals(prepared.problem, &clean, &prepared.noise)))? {
        Some((log, of_one_memory)) if log >= slow => Ok(Some(of_one_memory)),
        _ => Ok(Some(slower)),
    }
}

/// Log evidence of the likeliest of these accounts under a noise, and the recording made ready with it.
fn likeliest_account<'a>(
    prepared: &Prepared<'a>,
    noise: NoiseModel,
    accounts: &[&Tried],
    mechanisms: &[Discovery],
    told: &Told<'a>,
) -> Result<(f64, Prepared<'a>), DiagnoseError> {
    let under = Prepared::new(prepared.problem, noise, told.options)?;
    let every_row = under.noise.whitener(&prepared.problem.runs(), None);
    let mut likeliest = f64::NEG_INFINITY;
    for tried in accounts {
        let again = refitted(&under, tried, mechanisms, told)?;
        let misfit = misfit(&under, &again, mechanisms)?;
        likeliest = likeliest.max(evidence(&under, &again, deviance(&every_row, &misfit)));
    }
    Ok((likeliest, under))
}

/// The base model and, where they are others, the likeliest model that names something and that with mechanisms composed of words.
fn accounts<'t>(selection: &'t Selection, composition: Option<&'t Composition>) -> Vec<&'t Tried> {
    let named = selection.likeliest_named().map(|index| &selection.models[index]);
    std::iter::once(selection.base()).chain(named).chain(composition.map(|c| &c.tried)).collect()
}

/// What a model leaves of every row; effects behind those of the library are `mechanisms`.
fn misfit(prepared: &Prepared<'_>, tried: &Tried, mechanisms: &[Discovery]) -> Result<Vec<f64>, DiagnoseError> {
    let mut library = prepared.testable.clone();
    library.extend(mechanisms.iter().map(|m| &m.effect as &dyn Effect));
    let effects = tried.effects.iter().map(|e| library[*e]).collect();
    Ok(Model::new(prepared.problem, &prepared.context, effects).misfit(&tried.fit.z)?)
}

/// Minus twice the log likelihood of what is left of every row, under the noise of this filter.
pub(crate) fn deviance(every_row: &Whitener, misfit: &[f64]) -> f64 {
    let mut column = misfit.to_vec();
    every_row.apply(&mut column);
    every_row.deviance(&column)
}

/// Log evidence and log prior of a model, by the likelihood of every row (`deviance`) in place of that of the rows that are searched: the constant of the noise counts here.
fn evidence(prepared: &Prepared<'_>, tried: &Tried, deviance: f64) -> f64 {
    let prior = log_prior(0, prepared.testable.len()) + prior_of(prepared.testable.len(), tried);
    tried.fit.log_evidence + 0.5 * (tried.fit.chi2 - deviance) + prior
}

/// Log prior of a model over that of the base model, beside a library of so many effects: a mechanism composed of words is one of as many as there are sentences.
pub(crate) fn prior_of(library: usize, tried: &Tried) -> f64 {
    let composed = tried.effects.iter().filter(|e| **e >= library).count();
    let of_number = log_prior(tried.effects.len(), library) - log_prior(0, library);
    // more effects than the library alone may have: each is one of it
    let of_number = if of_number.is_finite() { of_number } else { -(tried.effects.len() as f64) * (library as f64).ln() };
    of_number - composed as f64 * (SENTENCES / library as f64).ln()
}

/// What the likeliest unmodelled cause adds beside a model; 0 where it adds nothing.
pub(crate) fn unmodelled(selection: &Selection, tried: &Tried) -> f64 {
    let beside = selection.unmodelled.iter().filter(|(u, _)| u.effects == tried.key());
    let most = beside.map(|(u, _)| u.gain).fold(f64::NEG_INFINITY, f64::max);
    (most + one_more(tried.effects.len()) + UNMODELLED_PRIOR.ln()).max(0.0)
}

/// The same model calibrated under the noise of `prepared`.
fn refitted(prepared: &Prepared<'_>, tried: &Tried, mechanisms: &[Discovery], told: &Told<'_>) -> Result<Tried, DiagnoseError> {
    let searched = prepared.searched();
    let library = &prepared.search(&searched, told.progress, told.stop);
    let search = with_mechanisms(library, mechanisms);
    if tried.effects.is_empty() {
        return Ok(search.base()?);
    }
    let fit = fit(&search.model(&tried.effects), search.whitener, &tried.fit.z, &FitOptions::default())?;
    Ok(Tried { effects: tried.effects.clone(), fit })
}
