//! The pipeline: noise, calibration, location, search, selection, verdict, held-out proof, next experiment.
//!
//! Limits: one recording (or several joined into one simulator) at a time.

use crate::{
    adequacy::{directions::directions, interference::heard::Heard, lack_of_fit::Gate},
    answer::{assemble::Answer, diagnosis::RecordingFacts, outcome::Outcome},
    data::{error::DiagnoseError, problem::Problem},
    effects::{effect::Effect, library},
    explain::{
        hidden_input::slow_input::{Hidden, SlowInput},
        next_experiment::NextExperiment,
    },
    fit::model::Model,
    fit::several_starts::LOOSE,
    noise::{
        block_average::thin,
        rescale::{quieter_than, too_loud},
        several::measured,
    },
    quality::preconditions::check,
    selection::{
        candidates::{Progress, Search},
        examine::{Examined, examine, judge},
        posterior::Selection,
        verdict::{Decision, Verdict, interrupted},
    },
    validation::{
        cross_validation::AllRows,
        recovery::fill::{BankOptions, Whole, fill},
    },
    whitening::noise_model::NoiseModel,
};
use std::sync::{
    Arc,
    atomic::{AtomicBool, Ordering},
};

/// Rows that are searched; longer recordings are searched on means of their quiet rows (see [`crate::noise::block_average`]) and predicted row by row.
const SEARCHED_ROWS: usize = 2500;

/// A longer recording is searched on more rows, so that its features stay apart, but never on more than these.
const MOST_SEARCHED_ROWS: usize = 8000;

fn searched_rows(rows: usize) -> usize {
    (rows / 50).clamp(SEARCHED_ROWS, MOST_SEARCHED_ROWS)
}

/// What a caller may choose.
#[derive(Clone, Debug, Default)]
pub struct Options {
    /// ids of the effects to try; all where empty
    pub effects: Vec<String>,
    /// columns that were hidden on purpose: the first is set beside the slow course that the recording asks for without it
    pub hidden: Vec<Hidden>,
    /// the only effects that may be named, and why, where something is wrong with the recording
    pub restricted: Option<(Vec<&'static str>, &'static str)>,
    /// why no physics may be named, where something is wrong with the recording
    pub withheld: Option<String>,
    /// recovery bank; none where absent
    pub bank: Option<Arc<BankOptions>>,
}

/// Diagnoses a recording.
///
/// # Errors
/// [`DiagnoseError`] where the recording cannot tell anything or the base model has no answer.
pub fn diagnose(
    problem: &Problem<'_>,
    facts: RecordingFacts,
    options: &Options,
    progress: &(dyn Fn(Progress) + Sync),
    stop: &AtomicBool,
) -> Result<Outcome, DiagnoseError> {
    let started = std::time::Instant::now();
    let halted = AtomicBool::new(true);
    let stop = if options.withheld.is_some() { &halted } else { stop };
    check(problem)?;
    let (quiet, noise) = measured(problem)?;
    let problem = &Problem { inputs: &quiet, response: problem.response, simulator: problem.simulator };
    let mut outcome = with_noise(problem, noise, false, facts, options, progress, stop)?;
    outcome.diagnosis.seconds = started.elapsed().as_secs_f64();
    Ok(outcome)
}

/// Diagnoses with this noise; once more where a model leaves less than it, unless it is `settled`.
fn with_noise(
    problem: &Problem<'_>,
    noise: NoiseModel,
    settled: bool,
    facts: RecordingFacts,
    options: &Options,
    progress: &(dyn Fn(Progress) + Sync),
    stop: &AtomicBool,
) -> Result<Outcome, DiagnoseError> {
    let context = problem.context(problem.span(), noise.floor());
    let everything = library();
    let (testable, not_testable) = part(&everything, &context, options);
    let thinned = thin(problem, &noise, searched_rows(problem.response.len()))?;
    let fewer = thinned.as_ref().map(|t| Problem { inputs: &t.inputs, response: &t.response, simulator: problem.simulator });
    let searched = fewer.as_ref().unwrap_or(problem);
    let searched_noise = thinned.as_ref().map_or_else(|| noise.clone(), |t| t.noise(&noise));
    let whitener = searched_noise.whitener(&searched.runs(), None);
    let loose = searched_noise.scaled(LOOSE).whitener(&searched.runs(), None);
    let search =
        Search { problem: searched, context: &context, library: testable, whitener: &whitener, loose: &loose, progress, stop };
    let directions = directions(searched.inputs, searched.simulator);
    let gate = Gate::new(&directions, &whitener, searched.runs(), searched_noise.uncertainty);
    let mut examined = examine(&search, &gate)?;
    if !settled
        && !stop.load(Ordering::Relaxed)
        && let Some(quieter) = once_more(problem, &search, &examined.selection, &noise)?
    {
        return with_noise(problem, quieter, true, facts, options, progress, stop);
    }
    // where nothing may be named, there is nothing to be right or wrong about
    let bank = match options.bank.as_ref().filter(|_| options.withheld.is_none()) {
        Some(wanted) => Some(fill(&search, Whole { problem, noise: &noise }, &examined, wanted)?),
        None => None,
    };
    if let Some(bank) = &bank {
        examined = judge(&search, &gate, examined.selection.sharpened(bank.power));
    }
    let Examined { selection, before, after, decision } = &examined;
    let slow = options.hidden.first().and_then(|hidden| SlowInput::of(&search, selection).map(|slow| (slow, hidden)));
    let stood_behind = &selection.models[decision.model];
    let effects = stood_behind.effects.iter().map(|e| search.library[*e]).collect();
    let heard = Heard::in_what_is_left(&Model::new(problem, &context, effects), &stood_behind.fit.z, &noise, gate.slack())?;
    let explained = 2.0 * (selection.base().fit.objective() - stood_behind.fit.objective());
    let decision = match heard.is_anything() {
        true => decision.clone().with_what_is_heard(selection.base, explained, heard.excess()),
        false => decision.clone(),
    };
    let (decision, because) = reserved(decision, selection, slow.as_ref().map(|(slow, _)| slow), options);
    let all = AllRows { problem, first: thinned.as_ref().map(|t| t.first.as_slice()) };
    let answer = Answer {
        search: &search,
        noise: &noise,
        searched_noise: &searched_noise,
        all,
        selection,
        decision: &decision,
        before: *before,
        after: *after,
        bank: bank.as_ref(),
        heard,
        gate: &gate,
        directions: &directions,
    };
    let mut outcome = answer.outcome(facts, not_testable);
    if let Some(because) = because {
        outcome.diagnosis.says = because;
        outcome.diagnosis.adequacy.heard = false;
    }
    if options.withheld.is_some() {
        outcome.diagnosis.concealed = false;
        outcome.diagnosis.next_experiment = NextExperiment { says: REPAIR_IT.into(), ..NextExperiment::default() };
    }
    if let Some((slow, hidden)) = slow {
        if slow.is_missing() {
            outcome.diagnosis.next_experiment = NextExperiment { says: RECORD_IT.into(), ..NextExperiment::default() };
        }
        let (column, trace) = slow.opened(&search, selection.base(), problem, hidden);
        outcome.diagnosis.concealed_column = Some(column);
        outcome.traces.course = Some(trace);
    }
    Ok(outcome)
}

/// The noise as the model that leaves least has it, where that leaves less than noise.
fn once_more(
    problem: &Problem<'_>,
    search: &Search<'_>,
    selection: &Selection,
    noise: &NoiseModel,
) -> Result<Option<NoiseModel>, DiagnoseError> {
    let Some(best) = selection.least() else { return Ok(None) };
    let rows = search.whitener.rows.max(1) as f64;
    if problem.simulator.joined().is_some() || best.fit.chi2 / rows > too_loud(noise) {
        return Ok(None);
    }
    let model = Model::new(problem, search.context, best.effects.iter().map(|e| search.library[*e]).collect());
    Ok(quieter_than(problem, &model.misfit(&best.fit.z)?, noise))
}

/// The decision, taken back where the recording may not be trusted or an input is missing that was hidden on purpose; with the reason.
fn reserved(
    decision: Decision,
    selection: &Selection,
    slow: Option<&SlowInput>,
    options: &Options,
) -> (Decision, Option<String>) {
    if let Some(why) = &options.withheld {
        return (interrupted(selection), Some(why.clone()));
    }
    match slow.filter(|slow| slow.is_missing()) {
        Some(slow) => (Decision { verdict: Verdict::Unexplained, ..interrupted(selection) }, Some(slow.says())),
        None => (decision, None),
    }
}

/// What to do where the recording may not be trusted.
const REPAIR_IT: &str = "repair what the notices name, and diagnose the recording again";

/// What to do where an input is missing.
const RECORD_IT: &str =
    "record what moves slowly beside the sensor: temperature, humidity, supply voltage, the state of the fixture";

/// Effects that the recording could show, and those that it could not, with the reason.
fn part<'a>(
    all: &'a [Box<dyn Effect>],
    context: &crate::data::context::Context<'_>,
    options: &Options,
) -> (Vec<&'a dyn Effect>, Vec<(String, String)>) {
    let (mut testable, mut not) = (Vec::new(), Vec::new());
    for effect in all {
        let id = effect.id().to_string();
        if !options.effects.is_empty() && !options.effects.contains(&id) {
            not.push((id, "left out on request".into()));
            continue;
        }
        if let Some((_, why)) = options.restricted.as_ref().filter(|(only, _)| !only.contains(&id.as_str())) {
            not.push((id, (*why).to_owned()));
            continue;
        }
        match effect.testable(context) {
            Ok(()) => testable.push(effect.as_ref()),
            Err(why) => not.push((id, why)),
        }
    }
    (testable, not)
}
