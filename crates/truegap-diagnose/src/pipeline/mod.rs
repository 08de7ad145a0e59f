//! The pipeline: noise, calibration, location, search, selection, verdict, held-out proof, next experiment.
//!
//! Limits: one recording (or several joined into one simulator) at a time.

mod alone;
mod asked;
mod beside_a_mean;
mod by_a_mean;
mod by_name;
mod by_rows_left_out;
mod calibrated;
mod carried;
mod conclude;
mod described;
mod interference;
mod judged;
mod lasting_noise;
mod laws_not_told_apart;
mod laws_on_limits;
mod level_choice;
mod noise_choice;
mod noise_that_lasts;
mod on_means;
mod options;
mod permuted_searches;
mod predicted;
mod prepare;
mod quieter;
pub(crate) mod recording;
mod richer_laws;
mod simple_laws;
mod wanders;
mod within_the_ends;
mod words_beside;

pub use options::{Options, Restriction};

use crate::{
    answer::{Known, Outcome},
    data::{context::Number, error::DiagnoseError, problem::Problem},
    noise::several::measured,
    quality::preconditions::check,
    selection::{
        candidates::{Progress, Search, Tried},
        examine::Examined,
    },
    validation::{
        held_numbers::{not_borne_out, with_held},
        tuning::CLEARLY_WORSE,
    },
    whitening::noise_model::NoiseModel,
};
use conclude::conclude;
use judged::{Told, composed, judged_again};
use noise_choice::with_the_likelier_noise;
use prepare::Prepared;
use richer_laws::richer;
use std::{
    hint::black_box,
    sync::atomic::{AtomicBool, Ordering},
    time::Instant,
};

/// Diagnoses a recording; `known` is what was known of it before, for the record.
///
/// # Errors
/// [`DiagnoseError`] where the recording cannot tell anything or the base model has no answer.
pub fn diagnose(
    problem: &Problem<'_>,
    known: impl Into<Known>,
    options: &Options,
    progress: &(dyn Fn(Progress) + Sync),
    stop: &AtomicBool,
) -> Result<Outcome, DiagnoseError> {
    let known = known.into();
    keep_room();
    // on a thread of the pool: what is split into parts there waits for no other thread to wake up
    rayon::scope(|_| searched(problem, known, options, progress, stop))
}

/// Lets the allocator keep what is freed: glibc's gives the derivatives of a step back to the system and gets them again for the next, page by page, until a piece as large as this was freed
/// once. Elsewhere it does nothing.
///
/// **Source:** mallopt(3), on the dynamic `M_MMAP_THRESHOLD`.
fn keep_room() {
    let mut room: Vec<u8> = Vec::new();
    // nothing is written to it, so that no page of it is ever taken
    let _ = black_box(&mut room).try_reserve_exact(KEPT_ROOM);
    drop(black_box(room));
}

/// Bytes, below the 32 MiB beyond which glibc learns nothing.
const KEPT_ROOM: usize = 24 << 20;

fn searched(
    problem: &Problem<'_>,
    known: Known,
    options: &Options,
    progress: &(dyn Fn(Progress) + Sync),
    stop: &AtomicBool,
) -> Result<Outcome, DiagnoseError> {
    let started = Instant::now();
    check(problem)?;
    let (denoised, noise) = measured(problem)?;
    let problem = &Problem { inputs: &denoised, response: problem.response, simulator: problem.simulator };
    // where nothing may be named, the base model is calibrated and nothing is searched
    let halted = AtomicBool::new(true);
    let told = Told { options, progress, asked: stop, stop: if options.withheld.is_some() { &halted } else { stop } };

    let mut prepared = Prepared::new(problem, noise, options)?;
    let mut examined = on_means::examined(&mut prepared, &told)?;
    // rows for which nothing was recorded on the response's clock tell nothing; what is named beside a shift at first may stand for a part of it, so that further ones are found once these are left out.
    // What the base model leaves may hide wild rows, which take the verdict and the noise with them; no noise is louder than what a model leaves; and rest in which the instrument is off says nothing of its
    // noise at work: everything is done once more with the noise as it is then
    let ends = Prepared::within_the_ends;
    for otherwise in [ends, ends, Prepared::with_wild_rows, Prepared::quieter, Prepared::at_work] {
        if !told.stop.load(Ordering::Relaxed)
            && let Some(noise) = otherwise(&prepared, &examined)?
        {
            prepared = Prepared::new(problem, noise, options)?;
            examined = on_means::examined(&mut prepared, &told)?;
        }
    }
    if let Some(richer) = richer(&mut prepared, &examined, &told)? {
        examined = richer;
        // a richer law leaves less, and the noise is no louder than that
        if let Some(noise) = prepared.quieter(&examined)? {
            examined = once_more(&mut prepared, noise, &told)?;
        }
    }
    let mut composition = composed(&prepared, &examined, &told);
    // where stretches at rest cannot tell slow noise from noise with one memory, the whole recording does
    let mut slowed = false;
    if let Some(likelier) = with_the_likelier_noise(&prepared, &examined, composition.as_ref(), &told)? {
        let held = std::mem::replace(&mut prepared, likelier).context.held;
        prepared.context.held = held;
        slowed = prepared.noise.lasts();
        examined = on_means::examined(&mut prepared, &told)?;
        composition = composed(&prepared, &examined, &told);
    }
    // it was weighed beside what was fitted under the noise before, and words may leave less than the library
    if !told.stop.load(Ordering::Relaxed)
        && let Some(noise) = prepared.quieter_in_the_end(&examined, composition.as_ref(), slowed)?
    {
        examined = once_more(&mut prepared, noise, &told)?;
        composition = composed(&prepared, &examined, &told);
    }
    // loud hours are no jumps
    if composition.is_none()
        && !told.stop.load(Ordering::Relaxed)
        && let Some(noise) = prepared.of_changing_level(&examined)?
    {
        examined = once_more(&mut prepared, noise, &told)?;
        composition = composed(&prepared, &examined, &told);
    }
    // a mechanism was composed beside the richer law
    if composition.is_none()
        && let Some(held) = held(&prepared, &examined, &told)
    {
        prepared.context.held.extend(held);
        let searched = prepared.searched();
        let search = prepared.search(&searched, progress, told.stop);
        examined = judged_again(&prepared, &search, with_held(&search, examined.selection, &prepared.context.held))?;
    }
    conclude(prepared, examined, composition, &told, known, started)
}

/// The same recording examined under another noise, its laws as rich as before.
fn once_more<'a>(prepared: &mut Prepared<'a>, noise: NoiseModel, told: &Told<'a>) -> Result<Examined, DiagnoseError> {
    let held = std::mem::take(&mut prepared.context.held);
    *prepared = Prepared::new(prepared.problem, noise, told.options)?;
    prepared.context.held = held;
    on_means::examined(prepared, told)
}

/// Numbers of the model stood behind that rows left out do not bear out; `None` where there are none.
fn held(prepared: &Prepared<'_>, examined: &Examined, told: &Told<'_>) -> Option<Vec<Number>> {
    let stood_behind = &examined.selection.models[examined.decision.model];
    if stood_behind.effects.is_empty() || told.stop.load(Ordering::Relaxed) {
        return None;
    }
    let searched = prepared.searched();
    let search = prepared.search(&searched, told.progress, told.stop);
    let under_noise = |search: &Search<'_>, tried: &Tried| prepared.foretold(search, tried);
    let held = not_borne_out(&search, stood_behind, &under_noise, CLEARLY_WORSE);
    (!held.is_empty()).then_some(held)
}
