//! Readings of a sensor without the physics that a diagnosis has added to its model.
//!
//! Limits: the correction is as right as the model file; nothing is fitted. The input of the base model is estimated from the reading, everything else that base
//! model and effects follow has to be recorded.

mod document;
mod error;
pub mod firmware;
mod input;
mod needed;

pub use document::{Compensated, Compensation, Estimated, Gained, SCHEMA, check};
pub use error::CompensateError;

use super::beside_model::{model_facts, opened, recording_facts, says_the_same, took_part};
pub use crate::models::Wanted;
use crate::models::{
    ModelFile, ModelFileError, Parted, Programs, RunningModel, corrected_for, of_recording, only_carried, refused,
};
use input::{Sought, Way};
use std::path::Path;
use truegap_core::{Inputs, Recording, ends};
use truegap_diagnose::answer::AddedEffect;
use truegap_diagnose::compensation::{self, Inverse, Limits, Models};
use truegap_diagnose::text::{listed, significant, spoken};
use truegap_diagnose::{Library, rms};

/// Part of the rows that may be far beyond what the base model gives. Such a row has no input, and gets what was added at the end of the range: where most rows do, the
/// answer is no correction by this model.
const OUTSIDE: f64 = 0.5;
/// Part of the range of the base model's readings from which on a row is far beyond it: noise and a zero that has moved put a sensor at rest a little below its least reading.
const FAR: f64 = 0.1;
/// Ranges of the input, where the model was fitted, from whose middle on an estimated input is far beyond them: what was added has taken the slope of the base model then.
const FAR_INPUT: f64 = 10.0;

/// Corrects the readings of `recording` by the model file `file`; `channel` is its sensor column where it holds several, `wanted` what it is
/// corrected for besides what is claimed.
///
/// # Errors
/// [`CompensateError`] where the two do not belong together, a column is missing, or a model has no answer.
pub fn compensate(
    file: &Path,
    recording: Recording,
    channel: Option<&str>,
    wanted: Wanted,
) -> Result<Compensated, CompensateError> {
    compensate_with(&ModelFile::open(file)?, file, recording, channel, wanted, &Programs::default())
}

/// As [`compensate`], by a model that was read already; `file` is its name, `programs` answer where its base model is a program or a function.
///
/// # Errors
/// As [`compensate`].
pub fn compensate_with(
    written: &ModelFile,
    file: &Path,
    recording: Recording,
    channel: Option<&str>,
    wanted: Wanted,
    programs: &Programs,
) -> Result<Compensated, CompensateError> {
    let (mut recording, name) = opened(recording, channel)?;
    let model = written.build_of(file, programs)?;
    model.as_followed(&mut recording.inputs);
    let (file, same) = (file.display().to_string(), took_part(written, &recording) && !written.sha256.trim().contains(' '));
    if recording.response_unit != written.unit {
        return Err(CompensateError::Unit { recording: name, found: recording.response_unit, wanted: written.unit.clone() });
    }
    says_the_same(written, &recording, &name)?;
    let (low, high) = ends(recording.response.iter().copied());
    if !(high - low).is_finite() {
        return Err(CompensateError::Range { recording: name, low, high, unit: recording.response_unit });
    }
    let parted = model.parted(&Library::default(), &recording.inputs, same, wanted);
    if corrected_for(&parted.kept).next().is_none() {
        return Err(nothing(file, &parted));
    }
    let task = Task { model: &model, parted: &parted, recording: &recording, name: &name, file: &file };
    let way = Way::of(&written.base, model.simulator());
    task.has_columns(&way)?;
    let found = task.corrected(&way)?;
    let error = task.error(&way, &found.corrected, same)?;
    let answer = task.answer(written, &way, found, error);
    match answer.not_finite() {
        None => Ok(answer),
        Some(what) => Err(CompensateError::NotFinite { recording: name, what }),
    }
}

/// Puts back into corrected readings what effects add that stay in them: the model with these less the model without.
fn leave_in(corrected: &mut [f64], with: &[f64], without: &[f64]) {
    corrected.iter_mut().zip(with.iter().zip(without)).for_each(|(value, (with, without))| *value += with - without);
}

fn nothing(model: String, parted: &Parted) -> CompensateError {
    let reasons: Vec<String> = parted.left_out.iter().map(|left| format!("{} ({})", spoken(&left.effect), left.why)).collect();
    match reasons.is_empty() {
        true => CompensateError::NothingAdded { model },
        false => CompensateError::NothingLeft { model, reasons: listed(&reasons, "and") },
    }
}

/// A recording to be corrected by a model.
struct Task<'a> {
    model: &'a RunningModel,
    parted: &'a Parted,
    recording: &'a Recording,
    name: &'a str,
    file: &'a str,
}

impl Task<'_> {
    fn inputs(&self) -> &Inputs {
        &self.recording.inputs
    }

    fn placed(&self, error: ModelFileError) -> CompensateError {
        refused(error, of_recording(self.name.to_owned())).into()
    }

    /// Whether everything is recorded that is not estimated.
    fn has_columns(&self, way: &Way) -> Result<(), CompensateError> {
        let simulator = self.model.simulator();
        let sought = if let Way::Estimated(sought) = way { Some(sought) } else { None };
        let absent = |role: &&truegap_core::Role| self.inputs().column(**role).is_none();
        let needs = simulator.needs().iter().filter(absent).map(|role| input::Column::Of(*role));
        let needs: Vec<_> = needs.filter(|column| sought.is_none_or(|sought| sought.column != *column)).collect();
        if let (Way::Recorded, false) = (way, needs.is_empty()) {
            let columns = listed(&needs.iter().map(input::Column::name).collect::<Vec<_>>(), "and");
            return Err(CompensateError::NotInverted { model: self.file.into(), base: simulator.name().into(), columns });
        }
        let of_base = needs.into_iter().next().map(|column| needed::Missing { column, effect: None });
        match of_base.or_else(|| needed::missing(self.model, &self.parted.kept, sought, self.inputs())) {
            None => Ok(()),
            Some(needed::Missing { column, effect }) => Err(CompensateError::Missing {
                recording: self.name.into(),
                column: column.name(),
                who: effect.map_or_else(|| format!("the base model `{}`", simulator.name()), |id| format!("`{id}`")),
                map: column.map(),
            }),
        }
    }

    fn corrected(&self, way: &Way) -> Result<compensation::Compensated, CompensateError> {
        let with = |effects: &[AddedEffect], input: &[f64]| match way {
            Way::Estimated(Sought { column, .. }) => {
                let mut inputs = self.inputs().clone();
                column.put(&mut inputs, Some(input.to_vec()));
                self.model.respond_with(effects, &inputs)
            }
            Way::Known | Way::Recorded => self.model.respond_with(effects, self.inputs()),
        };
        let (base, augmented) = (|input: &[f64]| with(&[], input), |input: &[f64]| with(&self.parted.kept, input));
        let models = Models { base: &base, augmented: &augmented };
        let inverse = self.inverse(way, &models)?;
        let limits = Limits::of(self.model.scales().noise_sd);
        let found = compensation::compensated(&self.recording.response, &models, &inverse, &limits);
        let mut found = found.map_err(|error| self.placed(error))?;
        self.is_within(way, &inverse, &found)?;
        let carried = only_carried(&self.parted.kept);
        if !carried.is_empty() {
            // the input is estimated with all that the reading shows; what is only carried stays in it
            let [bare, carrying] = [&[][..], &carried].map(|effects| with(effects, &found.input));
            let (bare, carrying) = (bare.map_err(|e| self.placed(e))?, carrying.map_err(|e| self.placed(e))?);
            leave_in(&mut found.corrected, &carrying, &bare);
        }
        Ok(found)
    }

    /// How a reading leads to the input that is sought.
    fn inverse(&self, way: &Way, models: &Models<'_, ModelFileError>) -> Result<Inverse, CompensateError> {
        let rows = self.recording.len();
        let Way::Estimated(Sought { column, span, straight }) = way else { return Ok(Inverse::Known) };
        let inverse = if *straight { Inverse::straight(models, rows, span.width) } else { Inverse::curve(models, rows, *span) };
        let inverse = inverse.map_err(|error| self.placed(error))?;
        if !inverse.moves() {
            let (model, base) = (self.file.to_owned(), self.model.simulator().name().to_owned());
            return Err(CompensateError::StandsStill { model, base, column: column.name() });
        }
        Ok(inverse)
    }

    /// Refuses readings that are for the most part no readings of this model.
    fn is_within(&self, way: &Way, inverse: &Inverse, found: &compensation::Compensated) -> Result<(), CompensateError> {
        let rows = self.recording.len();
        if let Way::Estimated(Sought { column, span, straight: true }) = way {
            let is_far = |input: &&f64| ((**input - span.zero) / span.width - 0.5).abs() > FAR_INPUT;
            let far = found.input.iter().filter(is_far).count();
            if far as f64 > OUTSIDE * rows as f64 {
                let (model, base) = (self.file.to_owned(), self.model.simulator().name().to_owned());
                let told = |[a, b]: [f64; 2]| {
                    format!("{} to {} {}", significant(a, 3), significant(b, 3), column.unit(self.model.simulator()))
                };
                let [estimated, fitted] = [ends(found.input.iter().copied()).into(), [span.zero, span.zero + span.width]]
                    .map(|range| told(range).trim_end().to_owned());
                return Err(CompensateError::HardlyMoves { model, base, column: column.name(), far, rows, estimated, fitted });
            }
        }
        let (Way::Estimated(Sought { column, .. }), Some(gives)) = (way, inverse.gives()) else { return Ok(()) };
        let outside = inverse.far_outside(&found.corrected, FAR);
        if outside as f64 <= OUTSIDE * rows as f64 {
            return Ok(());
        }
        let read: [f64; 2] = ends(found.corrected.iter().copied()).into();
        let unit = &self.recording.response_unit;
        let [read, gives] = [read, gives].map(|[a, b]| format!("{} to {} {unit}", significant(a, 4), significant(b, 4)));
        let (recording, model) = (self.name.to_owned(), self.file.to_owned());
        Err(CompensateError::Outside { recording, model, outside, rows, input: column.name(), read, gives })
    }

    /// Errors against the base model at the recorded input, on the clock of the reading where that is known; `None` where the input was not recorded.
    fn error(&self, way: &Way, corrected: &[f64], same: bool) -> Result<Option<Gained>, CompensateError> {
        let recorded = match way {
            Way::Estimated(Sought { column, .. }) => column.values(self.inputs()).is_some(),
            Way::Known | Way::Recorded => true,
        };
        if !recorded {
            return Ok(None);
        }
        let clocks = if same { self.parted.clocks.as_slice() } else { &[] };
        let stays = [clocks, &only_carried(&self.parted.kept)].concat();
        let truth = self.model.respond_with(&stays, self.inputs()).map_err(|error| self.placed(error))?;
        let rmse = |column: &[f64]| rms(column.iter().zip(&truth).map(|(value, truth)| value - truth));
        Ok(Some(Gained { before: rmse(&self.recording.response), after: rmse(corrected) }))
    }

    fn answer(&self, written: &ModelFile, way: &Way, found: compensation::Compensated, error: Option<Gained>) -> Compensated {
        let (recording, simulator) = (self.recording, self.model.simulator());
        let time = recording.inputs.time_s.clone().map(|time| ("time_s".to_owned(), time));
        let mut columns: Vec<(String, Vec<f64>)> = time.into_iter().collect();
        columns.push(("reading".into(), recording.response.clone()));
        columns.push(("corrected".into(), found.corrected));
        let mut estimated = None;
        if let Way::Estimated(Sought { column, .. }) = way {
            columns.push((column.estimate(), found.input));
            let unit = column.unit(simulator);
            estimated = Some(Estimated { input: column.name(), unit, rows_outside: found.outside });
        }
        let mut document = Compensation {
            schema: SCHEMA,
            made_by: format!("truegap {}", env!("CARGO_PKG_VERSION")),
            model: model_facts(self.model, written, self.file),
            recording: recording_facts(recording, self.name),
            unit: written.unit.clone(),
            corrected_for: corrected_for(&self.parted.kept).collect(),
            left_out: self.parted.left_out.clone(),
            estimated,
            passes: found.passes,
            stopped: found.stopped,
            left: found.left,
            noise: self.model.scales().noise_sd,
            noise_growth: found.noise_growth,
            error,
            says: String::new(),
            notes: self.notes(way, found.outside),
        };
        document.says = document.sentence();
        Compensated { document, run: recording.inputs.run.clone(), columns }
    }

    fn notes(&self, way: &Way, outside: usize) -> Vec<String> {
        let left_out = |left: &crate::models::LeftOut| format!("not corrected for {}: {}", spoken(&left.effect), left.why);
        let mut notes: Vec<String> = self.parted.left_out.iter().map(left_out).collect();
        match way {
            Way::Recorded => notes.push(format!(
                "the base model `{}` may answer a row by the rows before it, so its recorded input is used: without that column there is no correction",
                self.model.simulator().name()
            )),
            Way::Estimated(Sought { column, .. }) if outside > 0 => notes.push(format!(
                "in {outside} of {} rows no {} of the base model gives the corrected reading; what was added is taken at the nearest",
                self.recording.len(),
                column.name()
            )),
            _ => {}
        }
        notes
    }
}
