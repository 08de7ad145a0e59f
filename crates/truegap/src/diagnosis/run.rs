//! From recordings that were opened to a diagnosis with everything that its report needs.
//!
//! Limits: the base model is the recording's (or the request's); nothing is kept on disk here.

use super::asking::counted;
use super::bases::{Bases, MATERIALS};
use super::ceilings::ceiling_named;
use super::clock::utc_now;
use super::course::Course;
use super::diagnosed::Diagnosed;
use super::request::{Opened, Request, named};
use super::rows::rows_of_each;
use super::screen::{Screened, reserve, screen};
use super::{DiagnosisError, bank_store, followed};
use crate::diagnosis::report::Provenance;
use crate::models::Base;
use std::sync::atomic::AtomicBool;
use truegap_core::units::{readable, twelve_digits};
use truegap_core::{Inputs, Recording, Role, SimulationError, Simulator};
use truegap_diagnose::answer::OneRecording;
use truegap_diagnose::joint::{Member, Together};
use truegap_diagnose::quality::{FEWEST_ROWS, Notice};
use truegap_diagnose::{DiagnoseError, Known, Options, Outcome, Problem, Progress, RecordingFacts};

/// Diagnoses what was opened; `files` are what was read, with their SHA-256. `progress` is told the share of the whole that is over, which never falls.
///
/// # Errors
/// [`DiagnosisError`] where there is no base model or nothing can be concluded.
pub fn diagnose(
    opened: Opened,
    files: Vec<(String, String)>,
    request: &Request,
    progress: &(dyn Fn(Progress) + Sync),
    stop: &AtomicBool,
) -> Result<Diagnosed, DiagnosisError> {
    let rows = opened.recording.len();
    if rows < FEWEST_ROWS {
        // a base model that finds nothing that moves in so few rows would be the wrong thing to tell
        let source = DiagnoseError::TooFewRows { rows, needed: FEWEST_ROWS };
        return Err(DiagnosisError::Diagnose { recording: named(&opened.recording), source });
    }
    let course = Course::of(request);
    let asks = matches!(opened.recording.base.model.as_str(), "command" | "function");
    let programs = opened.programs.clone();
    let work =
        |progress: &(dyn Fn(Progress) + Sync)| under_way(opened, files, request, &|stage| progress(course.over_all(stage)), stop);
    if asks { counted(&programs, progress, stop, work) } else { work(progress) }
}

/// The diagnosis of what can tell something.
fn under_way(
    opened: Opened,
    files: Vec<(String, String)>,
    request: &Request,
    progress: &(dyn Fn(Progress) + Sync),
    stop: &AtomicBool,
) -> Result<Diagnosed, DiagnosisError> {
    let rows = opened.recording.len();
    progress(Progress { step: "rows", what: format!("what is wrong with {rows} of them"), done: 0.0 });
    let Screened { opened, bases, notices, clipped } = screen(opened)?;
    progress(Progress { step: "noise", what: format!("{rows} rows"), done: 0.0 });
    let run = Run { request, notices: &notices, progress, stop };
    let outcome = match opened.parts.is_empty() {
        true => of_one(&opened, &bases, &files, &run),
        false => of_several(&opened, &bases, &files, &run),
    };
    if let Some(failure) = opened.programs.failure() {
        // what was found without its answers is not what the recording says
        let source = DiagnoseError::Simulation(failure);
        return Err(DiagnosisError::Diagnose { recording: named(&opened.recording), source });
    }
    let outcome = outcome.map_err(|error| noticed(error, &notices))?;
    let base = bases.bases.into_iter().next().ok_or(DiagnosisError::NoRecording)?;
    let (provenance, library) = (provenance(files, request, outcome.interrupted), request.library.clone());
    let programs = opened.programs;
    let mut diagnosed =
        Diagnosed { recording: opened.recording, parts: opened.parts, base, outcome, provenance, library, programs };
    if let Some(clipped) = clipped.filter(|_| !notices.iter().any(|notice| notice.withholds)) {
        ceiling_named(&mut diagnosed, &clipped);
    }
    Ok(diagnosed)
}

fn provenance(files: Vec<(String, String)>, request: &Request, interrupted: bool) -> Provenance {
    Provenance { command: request.command.clone(), made_at: utc_now(), files, interrupted, has_model: true }
}

/// Where the model has no answer and something is known to be wrong with the recording, that is the reason to be told.
fn noticed(error: DiagnosisError, notices: &[Notice]) -> DiagnosisError {
    let why = notices.iter().find(|n| n.withholds);
    match (error, why) {
        (DiagnosisError::NoAnswer { recording, .. }, Some(why)) => {
            DiagnosisError::Untrusted { recording, says: why.says.clone() }
        }
        (error, _) => error,
    }
}

/// How a diagnosis is to be run.
struct Run<'a> {
    request: &'a Request,
    notices: &'a [Notice],
    progress: &'a (dyn Fn(Progress) + Sync),
    stop: &'a AtomicBool,
}

impl Run<'_> {
    fn diagnose(&self, opened: &Opened, problem: &Problem<'_>, known: Known) -> Result<Outcome, DiagnoseError> {
        let options = Options {
            library: self.request.library.clone(),
            effects: self.request.effects.clone(),
            compose: !self.request.library_only,
            select_in_folds: self.request.select_in_folds,
            permuted_searches: self.request.permuted_searches,
            hidden: opened.hidden.clone(),
            bank: self.request.bank.map(bank_store::options),
            ..Options::default()
        };
        let options = reserve(self.notices, options);
        truegap_diagnose::diagnose(problem, known, &options, self.progress, self.stop)
    }

    /// What is known before, `base` the base model of the only or first recording.
    fn known(&self, opened: &Opened, base: &Base, recording: RecordingFacts) -> Known {
        let notes = opened.recording.notes.iter().map(ToString::to_string);
        let hidden = self.request.conceal.iter().map(|c| format!("the column for {c} was hidden on request"));
        Known {
            recording,
            sensor: base.sensor.as_ref().map(|s| s.name.clone()),
            notices: self.notices.to_vec(),
            remarks: notes.chain(hidden).chain(followed::says(base, &opened.recording)).collect(),
        }
    }
}

fn of_one(opened: &Opened, bases: &Bases, files: &[(String, String)], run: &Run<'_>) -> Result<Outcome, DiagnosisError> {
    let recording = &opened.recording;
    let base = &bases.bases[0];
    let problem = Problem { inputs: &recording.inputs, response: &recording.response, simulator: base.simulator.as_ref() };
    let known = run.known(opened, base, facts(recording, files));
    run.diagnose(opened, &problem, known).map_err(|source| refused(source, recording, base, base.simulator.as_ref()))
}

fn of_several(opened: &Opened, bases: &Bases, files: &[(String, String)], run: &Run<'_>) -> Result<Outcome, DiagnosisError> {
    let members = members(opened, bases);
    let joint = Together::new(&members, &MATERIALS, opened.free)?;
    let problem = Problem { inputs: &joint.inputs, response: &joint.response, simulator: &joint.model };
    let mut facts = facts(&opened.recording, files);
    facts.recordings = each(opened, bases, files, &joint.inputs);
    facts.sharing = Some(joint.sharing.clone());
    let known = run.known(opened, &bases.bases[0], facts);
    run.diagnose(opened, &problem, known).map_err(|source| {
        let row = match &source {
            DiagnoseError::Simulation(SimulationError::GapCloses { row, .. } | SimulationError::NotFinite { row, .. }) => *row,
            _ => return DiagnosisError::Diagnose { recording: named(&opened.recording), source },
        };
        let (index, first) = part_of(&opened.parts, row);
        refused(moved_up(source, first), &opened.parts[index], &bases.bases[bases.specimen[index]], &joint.model)
    })
}

fn members<'a>(opened: &'a Opened, bases: &'a Bases) -> Vec<Member<'a>> {
    let member = |(part, specimen): (&'a Recording, &usize)| Member {
        name: named(part),
        simulator: bases.bases[*specimen].simulator.as_ref(),
        specimen: *specimen,
        inputs: &part.inputs,
        response: &part.response,
    };
    opened.parts.iter().zip(&bases.specimen).map(member).collect()
}

/// The recording that a joint row belongs to, and its first row.
fn part_of(parts: &[Recording], row: usize) -> (usize, usize) {
    let rows = rows_of_each(parts);
    let index = rows.iter().position(|rows| row < rows.end).unwrap_or(parts.len().saturating_sub(1));
    (index, rows.get(index).map_or(0, |rows| rows.start))
}

fn moved_up(source: DiagnoseError, rows: usize) -> DiagnoseError {
    match source {
        DiagnoseError::Simulation(SimulationError::GapCloses { row, load_si, strain }) => {
            DiagnoseError::Simulation(SimulationError::GapCloses { row: row - rows, load_si, strain })
        }
        DiagnoseError::Simulation(SimulationError::NotFinite { row, parameters }) => {
            DiagnoseError::Simulation(SimulationError::NotFinite { row: row - rows, parameters })
        }
        other => other,
    }
}

/// Each of several recordings, for the record.
fn each(opened: &Opened, bases: &Bases, files: &[(String, String)], joint: &Inputs) -> Vec<OneRecording> {
    let rows = rows_of_each(&opened.parts);
    let one = |(index, part): (usize, &Recording)| OneRecording {
        number: index + 1,
        source: files.get(index).map_or_else(|| named(part), |(name, _)| name.clone()),
        sensor: bases.bases[bases.specimen[index]].sensor.as_ref().map(|s| s.name.clone()),
        rows: part.len(),
        runs: part.inputs.runs().len(),
        first_run: joint.run.get(rows[index].start).copied().unwrap_or(1),
        sha256: part.sha256.clone(),
    };
    opened.parts.iter().enumerate().map(one).collect()
}

/// Rows are counted from 1 for the user, the load carries its unit, and the numbers that `asked` was asked with carry their names.
fn refused(source: DiagnoseError, recording: &Recording, base: &Base, asked: &dyn Simulator) -> DiagnosisError {
    let recording = named(recording);
    let (row, load_si, strain) = match source {
        DiagnoseError::Simulation(SimulationError::GapCloses { row, load_si, strain }) => (row, load_si, strain),
        DiagnoseError::Simulation(SimulationError::NotFinite { row, parameters }) => {
            let (model, parameters) = (base.simulator.name().to_owned(), with_names(asked, &parameters));
            return DiagnosisError::NoAnswer { recording, row: row + 1, model, parameters };
        }
        source => return DiagnosisError::Diagnose { recording, source },
    };
    let needs = base.simulator.needs();
    let unit = [Role::Pressure, Role::Gap].into_iter().find(|role| needs.contains(role)).unwrap_or(Role::Force).unit();
    let model = base.sensor.as_ref().map_or_else(|| base.simulator.name().to_owned(), |s| s.name.clone());
    DiagnosisError::GapCloses { recording, row: row + 1, load: twelve_digits(load_si), unit, model, strain }
}

/// ` with k = 2.1 N/mm, rest = 0 mm`; nothing where these are not the numbers of the model.
fn with_names(asked: &dyn Simulator, values: &[f64]) -> String {
    let known = asked.parameters();
    if values.is_empty() || known.len() != values.len() {
        return String::new();
    }
    let told = known.iter().zip(values).map(|(parameter, value)| {
        let unit = if parameter.unit == "1" { "" } else { parameter.unit.as_str() };
        format!("{} = {} {unit}", parameter.name, readable(*value)).trim_end().to_owned()
    });
    format!(" with {}", told.collect::<Vec<_>>().join(", "))
}

fn facts(recording: &Recording, files: &[(String, String)]) -> RecordingFacts {
    let names: Vec<&str> = files.iter().map(|(name, _)| name.as_str()).collect();
    let hashes: Vec<&str> = files.iter().map(|(_, hash)| hash.as_str()).collect();
    RecordingFacts {
        rows: recording.len(),
        runs: recording.inputs.runs().len(),
        sha256: hashes.join(" "),
        source: if names.is_empty() { named(recording) } else { names.join(", ") },
        ..RecordingFacts::default()
    }
}
