//! From a decision to the words and numbers of `diagnosis.json`, built once.
//!
//! Limits: decides nothing; what is stated here was decided in [`crate::selection::verdict`].

use crate::{
    answer::{
        alternatives::{ambiguity, bank_facts, candidates, smallest_visible, unmodelled},
        diagnosis::{AdequacyFacts, BaseFacts, Diagnosis, NotTestable, SCHEMA},
        discovered::{discovered, model_of},
        errors::{concealed, fit_facts, in_sample, respond, unseen},
        findings::{Named, findings},
        found::Found,
        known::Known,
        next::next,
        numbers::{augmented, noise, parameters},
        outcome::Outcome,
        prediction::{flexible, located, remains},
        reference::{against, reference},
        traces::Traces,
        words::{STOPPED, says},
    },
    data::error::{DiagnoseError, FEWEST_ROWS},
    explain::{conflicts::conflicts, locate::map},
    quality::preconditions::doubts,
    seeds::SEEDS,
    selection::verdict::Verdict,
};
use std::time::Instant;

/// Puts the answer together; `not_testable` are effects that were not tried, with the reason, and the clock was `started` when the diagnosis began.
///
/// # Errors
/// [`DiagnoseError::Simulation`] where a single row has no answer although the block averages that were searched had one.
pub(crate) fn outcome(
    found: &Found<'_>,
    known: Known,
    not_testable: Vec<NotTestable>,
    started: Instant,
) -> Result<Outcome, DiagnoseError> {
    let (base, chosen) = (found.selection.base(), found.chosen());
    let before = respond(found, found.base_alone)?;
    let after = respond(found, found.told(chosen))?;
    let (unseen_before, unseen_after) = (&found.unseen.base, found.unseen.stood_behind());
    let in_sample =
        in_sample(found, &before, &after).ok_or(DiagnoseError::TooFewRows { rows: before.len(), needed: FEWEST_ROWS })?;
    let fit = fit_facts(found, in_sample, unseen_before, unseen_after);
    let reference = reference(found);
    let Named { findings, order, carried } = findings(found, unseen_before, unseen_after);
    let with_mechanisms = model_of(found).map(|tried| match found.chosen().key() == tried.key() {
        true => unseen_after.clone(),
        false => unseen(found, tried),
    });
    let mechanisms = discovered(found, unseen_before, with_mechanisms.as_ref());
    let conflicts = conflicts(found.search, base);
    let (term, flexible_rows, flexible_unseen) = match flexible(found, &before, unseen_before) {
        Some(term) => (Some(term.facts), term.prediction, term.held_out),
        None => (None, Vec::new(), Vec::new()),
    };
    let (concealed_column, course) =
        found.slow.map(|(slow, hidden)| slow.opened(found.search, base, found.all.problem, hidden)).unzip();
    let stopped = found.interrupted.then(|| STOPPED.to_owned()).into_iter();
    let remarks = stopped.chain(found.left_out.iter().cloned()).chain(doubts(found.all.problem));
    let traces = Traces {
        noise_sd: (0..before.len()).map(|row| found.noise.row_sd(row)).collect(),
        before,
        after,
        held_out_before: unseen_before.prediction.clone(),
        held_out_after: unseen_after.prediction.clone(),
        flexible: flexible_rows,
        held_out_flexible: flexible_unseen,
        map_before: map(found.search.problem, &base.fit.residual),
        map_after: map(found.search.problem, &chosen.fit.residual),
        course,
    };
    let diagnosis = Diagnosis {
        schema: SCHEMA,
        version: env!("CARGO_PKG_VERSION"),
        recording: known.recording,
        base: base_facts(found, known.sensor),
        noise: noise(found),
        verdict: found.decision.verdict,
        probability_agrees: found.selection.probability_agrees(),
        says: says(found, (&findings, &order), &carried),
        concealed: concealed(found, &conflicts, &fit),
        conflicts,
        mismatch: if found.decision.verdict == Verdict::Agrees { Vec::new() } else { located(found, base) },
        remains: if found.leaves_something() { remains(found, chosen) } else { Vec::new() },
        discovered: mechanisms,
        candidates: candidates(found),
        unmodelled: unmodelled(found),
        ambiguity: ambiguity(found, &order),
        reference_says: against(&reference, &fit, !findings.is_empty()),
        reference,
        fit,
        findings,
        carried,
        prediction_only: term,
        permuted_searches: found.permuted_searches.clone(),
        confirmation: None,
        not_testable,
        smallest_visible: smallest_visible(found),
        next_experiment: next(found),
        bank: found.bank.map(|bank| bank_facts(found, bank)),
        adequacy: adequacy_facts(found),
        evidence_check: found.selection.check,
        notices: known.notices,
        concealed_column,
        recording_issues: remarks.chain(known.remarks).collect(),
        seeds: Some(SEEDS),
        seconds: started.elapsed().as_secs_f64(),
    };
    Ok(Outcome { diagnosis, traces, augmented: augmented(found), interrupted: found.interrupted })
}

/// The base model and its parameters, alone and beside what was found.
fn base_facts(found: &Found<'_>, sensor: Option<String>) -> BaseFacts {
    let own = 0..found.selection.base().fit.z.len();
    BaseFacts {
        model: found.search.problem.simulator.name().into(),
        sensor,
        parameters: parameters(found, found.base_alone, own.clone()),
        parameters_after: parameters(found, found.told(found.chosen()), own),
    }
}

/// What the lack-of-fit tests say before and after, and the interference that is left.
fn adequacy_facts(found: &Found<'_>) -> AdequacyFacts {
    AdequacyFacts {
        before: Some(found.before),
        after: Some(found.after),
        burst: Some(found.interference.burst),
        tone: Some(found.interference.tone),
        interference: found.is_about_interference(),
        removed: found.decision.removed,
    }
}
