//! A model file judged on a recording that took no part in it: is what was added borne out there?
//!
//! Limits: nothing is refitted but a gain and an offset of the reading and a clock, where that is said. Rows that a diagnosis would leave out are left out.

mod document;
mod error;
mod judged;
mod rivals;

pub use document::{Confirmed, FILES, SCHEMA, words};
pub use error::ConfirmError;
pub use judged::Free;
pub use truegap_diagnose::answer::{AmongRivals, Confirmation, Errors, ModelFacts, OtherFacts, RivalErrors};

use super::beside_model::{model_facts, opened, recording_facts, says_the_same, says_the_same_as, took_part};
use super::request::named;
use super::screen::without_outliers;
use crate::diagnosis::Diagnosed;
use crate::models::{LeftOut, ModelFile, OF_RECORDER, Programs, RunningModel, of_recording, refused};
use document::says;
use judged::Judged;
use rivals::among_rivals;
use std::path::Path;
use truegap_core::recording::BaseSpec;
use truegap_core::{Recording, ends};
use truegap_diagnose::answer;
use truegap_diagnose::confirmation::{Judgement, LEVEL, NoiseFloor, noise_floor};
use truegap_diagnose::quality::FEWEST_ROWS;
use truegap_diagnose::text::{listed, spoken};
use truegap_diagnose::{Library, Problem};

/// Stands for the file of a model that was found in the same run.
const OF_THIS_RUN: &str = "augmented.toml of this run";

/// Judges the model file `file` on `recording`; `channel` is its sensor column where it holds several.
///
/// # Errors
/// [`ConfirmError`] where the two do not belong together or a model has no answer.
pub fn confirm(file: &Path, recording: Recording, channel: Option<&str>, free: Free) -> Result<Confirmed, ConfirmError> {
    confirm_with(&ModelFile::open(file)?, file, recording, channel, free, &Programs::default())
}

/// As [`confirm`], of a model that was read already; `file` is its name, `programs` answer where its base model is a program or a function.
///
/// # Errors
/// As [`confirm`].
pub fn confirm_with(
    written: &ModelFile,
    file: &Path,
    recording: Recording,
    channel: Option<&str>,
    free: Free,
    programs: &Programs,
) -> Result<Confirmed, ConfirmError> {
    let (recording, name) = opened(recording, channel)?;
    enough_rows(&recording, &name)?;
    judge(written, &file.display().to_string(), recording, name, free, programs)
}

/// Refuses a recording of so few rows that no two predictions of it can be told apart.
fn enough_rows(recording: &Recording, name: &str) -> Result<(), ConfirmError> {
    match recording.len() {
        rows if rows < FEWEST_ROWS => Err(ConfirmError::TooFewRows { recording: name.to_owned(), rows }),
        _ => Ok(()),
    }
}

/// The recording that a diagnosis is to be judged on, looked at before the diagnosis is made: one that took part, or is read in another unit, is refused here.
///
/// # Errors
/// [`ConfirmError`].
pub fn other(recording: Recording, channel: Option<&str>, took_part: &[Recording]) -> Result<Recording, ConfirmError> {
    let (recording, name) = opened(recording, channel)?;
    enough_rows(&recording, &name)?;
    // saved again, by another program, the same rows have other bytes
    let same = |part: &Recording| part.response == recording.response;
    if took_part.iter().any(|part| !part.sha256.is_empty() && part.sha256 == recording.sha256 || same(part)) {
        return Err(ConfirmError::TookPart { recording: name });
    }
    took_part.iter().try_for_each(|part| says_the_same_as(part, &recording, &name))?;
    match took_part.first().filter(|part| part.response_unit != recording.response_unit) {
        None => Ok(recording),
        Some(part) => {
            let (found, wanted) = (recording.response_unit, part.response_unit.clone());
            Err(ConfirmError::Unit { recording: name, found, wanted })
        }
    }
}

/// Judges what `diagnosed` ended with on `recording`, which took no part, and puts the answer, or why there is none, into the diagnosis.
pub fn confirm_within(diagnosed: &mut Diagnosed, mut recording: Recording, free: Free) {
    let name = named(&recording);
    // it says of itself what the first one did, and the command may have said otherwise of both
    recording.base = BaseSpec::default();
    let judged = match diagnosed.model_file() {
        Ok(written) => judge(&written, OF_THIS_RUN, recording, name.clone(), free, &diagnosed.programs),
        Err(error) => Err(error.into()),
    };
    diagnosed.outcome.diagnosis.confirmation = Some(match judged {
        Ok(confirmed) => answer::Confirmed::Judged(Box::new(confirmed.document)),
        Err(error) => answer::Confirmed::Refused { source: name, refused: error.to_string() },
    });
}

/// Judges a model on a recording; `file` and `name` are where they come from, for a reader.
fn judge(
    written: &ModelFile,
    file: &str,
    mut recording: Recording,
    name: String,
    free: Free,
    programs: &Programs,
) -> Result<Confirmed, ConfirmError> {
    let (model, left_out) = written.build_of(Path::new(file), programs)?.elsewhere(&Library::default(), &recording.inputs);
    if model.effects().is_empty() && !left_out.is_empty() {
        let reasons: Vec<String> = left_out.iter().map(|left| format!("{}: {}", spoken(&left.effect), left.why)).collect();
        return Err(ConfirmError::LeftOut { model: file.to_owned(), reasons: listed(&reasons, "and") });
    }
    model.as_followed(&mut recording.inputs);
    let mut notes = belong_together(&model, written, file, &recording, &name)?;
    if free.clock && recording.inputs.time_s.is_none() {
        return Err(ConfirmError::NoClock { recording: name });
    }
    let (recording, notices) = without_outliers(recording, model.simulator());
    enough_rows(&recording, &name)?;
    notes.extend(notices.into_iter().map(|notice| notice.says));
    let no_answer = |error| refused(error, of_recording(name.clone()));
    let asked = |free: Free| Judged::new(&model, &recording, free).map_err(no_answer);
    let judged = asked(free)?;
    let freed = asked(Free { gain: true, offset: true, ..free })?.test.judgement;
    notes.extend(left_out.iter().map(|left| not_carried_over(left, free)));
    let problem = Problem { inputs: &recording.inputs, response: &recording.response, simulator: model.simulator() };
    let left: Vec<f64> = judged.columns[1].iter().zip(&recording.response).map(|(p, r)| r - p).collect();
    let noise = noise_floor(&problem, &left).map_err(|source| ConfirmError::Noise { recording: name.clone(), source })?;
    if freed != judged.test.judgement {
        notes.push(format!(
            "with a gain and an offset of the reading free (--free gain,offset) the verdict would be `{}`: what decides is level or scale, not the course",
            words(freed)
        ));
    }
    let recorded = recording_facts(&recording, &name);
    let facts = model_facts(&model, written, file);
    let rivals = among_rivals((written, &model.effects()), &judged, &recording, free, programs);
    let [base, augmented] = judged.columns.clone();
    let document = Confirmation {
        free: free.words(),
        rivals,
        notes,
        ..document(judged, facts, recorded, noise, written.unit.clone(), freed)
    };
    Ok(Confirmed { document, recording, base, augmented })
}

/// What is told of an effect that is left out here.
fn not_carried_over(left: &LeftOut, free: Free) -> String {
    let instead = match (left.why == OF_RECORDER, free.clock) {
        (false, _) => "",
        (true, true) => ": another recording has its own; base and augmented model have each been given a clock of this one",
        (true, false) => {
            ": another recording has its own; where this one has two clocks as well, --free gain,offset,clock gives both models a clock of it"
        }
    };
    format!("{} is left out here: {}{instead}", spoken(&left.effect), left.why)
}

/// Whether this recording can say anything of this model; notes where it can with a reserve.
fn belong_together(
    model: &RunningModel,
    written: &ModelFile,
    file: &str,
    recording: &Recording,
    name: &str,
) -> Result<Vec<String>, ConfirmError> {
    let (library, effects) = (Library::default(), model.effects());
    let (file, name) = (file.to_owned(), name.to_owned());
    if effects.is_empty() {
        return Err(ConfirmError::NothingAdded { model: file });
    }
    if took_part(written, recording) {
        return Err(ConfirmError::TookPart { recording: name });
    }
    if recording.response_unit != written.unit {
        return Err(ConfirmError::Unit { recording: name, found: recording.response_unit.clone(), wanted: written.unit.clone() });
    }
    says_the_same(written, recording, &name)?;
    let bound = model.bound_to_runs(&library);
    if !bound.is_empty() {
        return Err(ConfirmError::BoundToRuns { model: file, effects: bound.join(", ") });
    }
    let (low, high) = ends(recording.response.iter().copied());
    let hidden = model.not_shown_by(&recording.inputs, high - low, &library);
    let reasons: Vec<String> = hidden.iter().map(|(id, why)| format!("{} ({why})", spoken(id))).collect();
    if hidden.len() == effects.len() {
        return Err(ConfirmError::NotShown { recording: name, reasons: listed(&reasons, "and") });
    }
    let mut notes: Vec<String> = reasons.iter().map(|reason| format!("the recording could not show {reason}")).collect();
    if !model.base_is_known() {
        notes.push(
            "the model file has no [[base_alone]]: the base model is taken at the values of the augmented fit, without the added physics; diagnose again for the \
             base model as it was calibrated alone"
                .into(),
        );
    }
    Ok(notes)
}

/// The answer for base and augmented model, without what is said beside it.
fn document(
    judged: Judged,
    model: ModelFacts,
    recording: OtherFacts,
    noise: NoiseFloor,
    unit: String,
    freed: Judgement,
) -> Confirmation {
    let [base, augmented] = judged.errors;
    Confirmation {
        schema: SCHEMA,
        made_by: format!("truegap {}", env!("CARGO_PKG_VERSION")),
        says: says(&judged.test, [&base, &augmented], &noise, &unit, &model.effects),
        model,
        recording,
        unit,
        free: Vec::new(),
        base,
        augmented,
        noise,
        level: LEVEL,
        verdict: judged.test.judgement,
        test: judged.test,
        verdict_if_gain_and_offset_are_free: freed,
        rivals: None,
        notes: Vec::new(),
    }
}
