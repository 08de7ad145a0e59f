//! `augmented.toml`: a calibrated base model with added physics, as a file that simulates by itself.
//!
//! Limits: values and standard deviations, no correlations between them; an effect is known by its id, so a program must have it in its library.

use super::left_out::{LeftOut, OF_A_DATE, OF_RECORDER};
use super::model_file_error::ModelFileError;
use crate::models::base::{Programs, foreseen};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use truegap_core::sensor::builtin_sensors;
use truegap_core::{Inputs, LOADS, Sensor, Simulator, Stage};
use truegap_diagnose::answer::{AddedEffect, NamedValue, RivalModel, Scales};
use truegap_diagnose::other_clock::OtherClock;
use truegap_diagnose::{Augmented, Context, Library, Outcome, mechanism::Driver};
use truegap_model::BaseModel;

/// Identifier of the file format.
pub const SCHEMA: &str = "truegap.model/1";

/// The file.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ModelFile {
    /// always [`SCHEMA`]
    pub schema: String,
    /// program and version
    pub made_by: String,
    /// recording that it was fitted to
    pub recording: String,
    /// SHA-256 of that recording
    pub sha256: String,
    /// SHA-256 of its readings as numbers, by which it is known where it was saved again; absent in files of earlier versions
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub readings_sha256: Option<String>,
    /// verdict of the diagnosis
    pub verdict: String,
    /// unit of the response
    pub unit: String,
    /// text of the sensor's file, where the base model has a sensor
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub sensor: Option<String>,
    /// units of the recording's drivers; absent in files of earlier versions
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub drivers: BTreeMap<String, String>,
    /// the base model and how it is built
    pub base: BaseModel,
    /// what the effects' equations take from the recording
    pub scales: Scales,
    /// calibrated parameters of the base model
    #[serde(rename = "parameter")]
    pub parameters: Vec<NamedValue>,
    /// the same parameters where the base model was calibrated alone; absent in files of earlier versions
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub base_alone: Vec<NamedValue>,
    /// added physics
    #[serde(rename = "effect", default, skip_serializing_if = "Vec::is_empty")]
    pub effects: Vec<AddedEffect>,
    /// the same model with a rival in the place of an effect, for each that the recording could not tell from it
    #[serde(rename = "rival", default, skip_serializing_if = "Vec::is_empty")]
    pub rivals: Vec<RivalModel>,
}

impl ModelFile {
    /// The model that a diagnosis ends with: `base` as its base model is built, `folder` that of the recording, where its sensor's file may lie.
    ///
    /// # Errors
    /// [`ModelFileError::SensorFile`] where the sensor's own file has gone.
    pub fn of(outcome: &Outcome, base: &BaseModel, folder: Option<&Path>) -> Result<Self, ModelFileError> {
        let (diagnosis, augmented) = (&outcome.diagnosis, &outcome.augmented);
        Ok(Self {
            schema: SCHEMA.into(),
            made_by: format!("truegap {}", diagnosis.version),
            recording: diagnosis.recording.source.clone(),
            sha256: diagnosis.recording.sha256.clone(),
            readings_sha256: None,
            verdict: diagnosis.verdict.word().into(),
            unit: diagnosis.fit.unit.clone(),
            sensor: base.sensor().map(|name| sensor_text(name, folder)).transpose()?,
            drivers: BTreeMap::new(),
            base: base.clone(),
            scales: augmented.scales.clone(),
            parameters: augmented.parameters.clone(),
            base_alone: augmented.base_alone.clone(),
            effects: augmented.effects.clone(),
            rivals: augmented.rivals.clone(),
        })
    }

    /// The file with a rival in the place of the effect that is named.
    #[must_use]
    pub fn with_rival(&self, rival: &RivalModel) -> Self {
        let (parameters, effects) = (rival.parameters.clone(), rival.effects.clone());
        Self { parameters, effects, rivals: Vec::new(), ..self.clone() }
    }

    /// The file's text.
    ///
    /// # Errors
    /// [`ModelFileError::Write`] where TOML cannot hold a number.
    pub fn to_toml(&self) -> Result<String, ModelFileError> {
        let head = "# Written by `truegap diagnose`; `truegap simulate --model` runs it. Values are in the unit beside them.\n";
        Ok(head.to_owned() + &toml::to_string(self)?)
    }

    /// Reads a file.
    ///
    /// # Errors
    /// [`ModelFileError`] where it is not there or not a model.
    pub fn open(file: &Path) -> Result<Self, ModelFileError> {
        let text = truegap_limits::read_text(file).map_err(|source| ModelFileError::Read { file: file.to_owned(), source })?;
        Self::parse(&text, file)
    }

    /// Reads a text; `file` is for messages.
    ///
    /// # Errors
    /// [`ModelFileError`] where it is not a model.
    pub fn parse(text: &str, file: &Path) -> Result<Self, ModelFileError> {
        #[derive(Deserialize)]
        struct Head {
            schema: String,
        }
        if text.trim_start().starts_with('{') {
            return Err(ModelFileError::Json { file: file.to_owned() });
        }
        let failed = |e: toml::de::Error| ModelFileError::Parse {
            file: file.to_owned(),
            message: e.to_string().trim().replace('\n', " "),
        };
        let head: Head = toml::from_str(text).map_err(failed)?;
        if head.schema != SCHEMA {
            return Err(ModelFileError::Schema { file: file.to_owned(), found: head.schema });
        }
        let read: Self = toml::from_str(text).map_err(failed)?;
        let given: toml::Table = toml::from_str(text).map_err(failed)?;
        read.check_words(&given).map_err(|error| error.of(file))?;
        Ok(read)
    }

    /// The model, ready to simulate.
    ///
    /// # Errors
    /// [`ModelFileError`] where base model, parameters and effects do not fit together.
    pub fn build(&self) -> Result<RunningModel, ModelFileError> {
        self.build_with(&Programs::default())
    }

    /// As [`ModelFile::build_with`], errors told with the name of the file.
    ///
    /// # Errors
    /// As [`ModelFile::build`].
    pub fn build_of(&self, file: &Path, programs: &Programs) -> Result<RunningModel, ModelFileError> {
        self.build_with(programs).map_err(|error| error.of(file))
    }

    /// As [`ModelFile::build`], asking `programs` where the base model is a program or a function.
    ///
    /// # Errors
    /// As [`ModelFile::build`].
    pub fn build_with(&self, programs: &Programs) -> Result<RunningModel, ModelFileError> {
        self.check_numbers()?;
        let sensor = self.sensor.as_ref().map(|text| Sensor::from_toml(text, "sensor of the model file")).transpose()?;
        let simulator = programs.model(&self.base, sensor.as_ref(), sensor.as_ref().and_then(foreseen))?;
        if self.unit != simulator.unit() {
            let (found, model, unit) = (self.unit.clone(), simulator.name().to_owned(), simulator.unit().to_owned());
            return Err(ModelFileError::Unit { found, model, unit });
        }
        let augmented = self.augmented(simulator.as_ref())?;
        let values = values(&augmented.parameters, simulator.as_ref())?;
        // a base without parameters is the same alone
        let is_known = !self.base_alone.is_empty() || values.is_empty();
        let alone = is_known.then(|| self::values(&augmented.base_alone, simulator.as_ref())).transpose()?;
        let mut model = RunningModel { simulator, values, alone, augmented };
        model.order_numbers()?;
        model.check()?;
        Ok(model)
    }
}

/// The values of a base model's parameters, in its order, from those of a file.
fn values(listed: &[NamedValue], simulator: &dyn Simulator) -> Result<Vec<f64>, ModelFileError> {
    let model = || simulator.name().to_owned();
    let needed = simulator.parameters();
    if let Some(surplus) = listed.iter().find(|p| needed.iter().all(|n| n.name != p.name)) {
        return Err(ModelFileError::SurplusParameter { name: surplus.name.clone(), model: model() });
    }
    let value = |name: &str| listed.iter().find(|p| p.name == name).map(|p| p.value);
    needed
        .iter()
        .map(|n| value(&n.name).ok_or_else(|| ModelFileError::MissingParameter { name: n.name.clone(), model: model() }))
        .collect()
}

fn sensor_text(name: &str, folder: Option<&Path>) -> Result<String, ModelFileError> {
    if let Some(built_in) = builtin_sensors().iter().find(|s| s.name == name) {
        return Ok(built_in.toml.to_owned());
    }
    let file = folder.map(|f| f.join(name)).filter(|path| path.is_file()).unwrap_or_else(|| PathBuf::from(name));
    truegap_limits::read_text(&file).map_err(|source| ModelFileError::SensorFile { file, source })
}

/// What an added effect follows: as its mechanism says, else as the library says of its id; `None` where no words say it.
pub(super) fn driver_of(added: &AddedEffect, library: &Library, context: &Context<'_>) -> Option<Driver> {
    match &added.mechanism {
        Some(mechanism) => Some(mechanism.sentence.driver.clone()),
        None => Some(library.find(&added.id)?.in_words(context)?.driver),
    }
}

/// Sets the numbers of an added effect to 0 that say how the recording began to which it was fitted: another one begins otherwise.
pub(super) fn begin_anew(added: &mut AddedEffect, library: &Library, context: &Context<'_>) {
    let of_start = library.find(&added.id).map_or(&[][..], |effect| effect.of_start(context));
    added.parameters.iter_mut().filter(|p| of_start.contains(&p.name.as_str())).for_each(|p| p.value = 0.0);
}

/// A model that simulates: base model, its calibrated values, added physics.
pub struct RunningModel {
    pub(super) simulator: Box<dyn Simulator>,
    pub(super) values: Vec<f64>,
    /// values where the base model was calibrated alone
    alone: Option<Vec<f64>>,
    pub(super) augmented: Augmented,
}

impl RunningModel {
    /// The base model.
    pub fn simulator(&self) -> &dyn Simulator {
        self.simulator.as_ref()
    }

    /// Response of each row, added physics included, in [`Simulator::unit`].
    ///
    /// # Errors
    /// [`ModelFileError::Simulation`] where a row has no physical answer or a column is missing.
    pub fn respond(&self, inputs: &Inputs) -> Result<Vec<f64>, ModelFileError> {
        self.respond_by(&OtherClock::default(), inputs)
    }

    /// The same with a clock of the inputs that differs from that of the response.
    ///
    /// # Errors
    /// As [`RunningModel::respond`].
    pub fn respond_by(&self, clock: &OtherClock, inputs: &Inputs) -> Result<Vec<f64>, ModelFileError> {
        self.respond_as(&self.augmented, inputs, clock)
    }

    /// The same with the effects of `augmented`.
    pub(super) fn respond_as(
        &self,
        augmented: &Augmented,
        inputs: &Inputs,
        clock: &OtherClock,
    ) -> Result<Vec<f64>, ModelFileError> {
        let library = Library::default();
        self.has_drivers(augmented, inputs, &library)?;
        let mut context = Context::new(inputs, self.simulator.as_ref(), 0.0, 0.0);
        augmented.apply_scales(&mut context);
        let stages = augmented.stages(&library, &context)?;
        let stages: Vec<&dyn Stage> = stages.iter().map(AsRef::as_ref).chain([clock as &dyn Stage]).collect();
        Ok(self.simulator.respond(&self.values, inputs, &stages)?)
    }

    /// `Ok` where every recorded driver that an added effect follows is among the inputs.
    fn has_drivers(&self, augmented: &Augmented, inputs: &Inputs, library: &Library) -> Result<(), ModelFileError> {
        let drivers = self.augmented.scales.moved.as_ref().map_or(&[][..], |fitted| fitted.drivers.as_slice());
        self.as_fitted(|context| {
            for added in &augmented.effects {
                let driver = driver_of(added, library, context);
                let Some(Driver::Recorded(column) | Driver::RateOf(column)) = driver else { continue };
                let is_driver = drivers.contains(&column);
                if is_driver && inputs.drivers.iter().all(|driver| driver.name != column) {
                    return Err(ModelFileError::MissingDriver { effect: added.id.clone(), column });
                }
            }
            Ok(())
        })
    }

    /// What `asked` says of the recording to which the effects were fitted: one row that has its drivers.
    pub(super) fn as_fitted<T>(&self, asked: impl FnOnce(&Context<'_>) -> T) -> T {
        let row = self.augmented.scales.moved.clone().unwrap_or_default().one_row();
        let mut context = Context::new(&row, self.simulator.as_ref(), 0.0, 0.0);
        self.augmented.apply_scales(&mut context);
        asked(&context)
    }

    /// Whether the values are known that the base model had where it was calibrated alone.
    pub fn base_is_known(&self) -> bool {
        self.alone.is_some()
    }

    /// Response of each row without the added physics: at the values of the base model alone, or at those of the augmented model where the file has no others.
    ///
    /// # Errors
    /// As [`RunningModel::respond`].
    pub fn respond_alone(&self, inputs: &Inputs) -> Result<Vec<f64>, ModelFileError> {
        self.respond_alone_by(&OtherClock::default(), inputs)
    }

    /// The same with a clock of the inputs that differs from that of the response.
    ///
    /// # Errors
    /// As [`RunningModel::respond`].
    pub fn respond_alone_by(&self, clock: &OtherClock, inputs: &Inputs) -> Result<Vec<f64>, ModelFileError> {
        Ok(self.simulator.respond(self.alone.as_ref().unwrap_or(&self.values), inputs, &[clock])?)
    }

    /// The added effects that have a number for each run: these mean nothing in the runs of another recording.
    pub fn bound_to_runs(&self, library: &Library) -> Vec<String> {
        let inputs = Inputs { run: vec![1], ..Inputs::default() };
        let context = |runs: usize| Context::new(&inputs, self.simulator.as_ref(), 0.0, 0.0).with_runs(runs);
        let (one, three) = (context(1), context(3));
        let effects = self.augmented.effects.iter().filter_map(|added| library.find(&added.id));
        let bound = effects.filter(|effect| effect.parameters(&one).len() != effect.parameters(&three).len());
        bound.map(|effect| effect.id().to_string()).collect()
    }

    /// The model for another recording, and the added effects that are left out there.
    ///
    /// Out are effects that belong to what recorded and not to what was recorded, such as clocks, and those that go with a date that is not known; a number that says how the first recording began is 0.
    #[must_use]
    pub fn elsewhere(mut self, library: &Library, inputs: &Inputs) -> (Self, Vec<LeftOut>) {
        let dated = self.knows_dates(inputs);
        let mut left_out = Vec::new();
        let mut kept = std::mem::take(&mut self.augmented.effects);
        kept.retain(|added| {
            let effect = library.find(&added.id);
            let why = effect.filter(|effect| effect.of_recorder()).map(|_| OF_RECORDER);
            let why = why.or_else(|| effect.filter(|effect| effect.by_date() && !dated).map(|_| OF_A_DATE));
            left_out.extend(why.map(|why| LeftOut { effect: added.id.clone(), why }));
            why.is_none()
        });
        self.as_fitted(|context| kept.iter_mut().for_each(|added| begin_anew(added, library, context)));
        self.augmented.effects = kept;
        (self, left_out)
    }

    /// Inputs as the effects follow them: a load that was a driver where they were fitted is one here.
    pub fn as_followed(&self, inputs: &mut Inputs) {
        let drivers = self.augmented.scales.moved.iter().flat_map(|moved| &moved.drivers);
        drivers.for_each(|name| LOADS.into_iter().filter(|role| role.key() == name).for_each(|role| inputs.load_as_driver(role)));
    }

    /// Whether the recording to which the effects were fitted and that of `inputs` both tell their dates.
    pub(super) fn knows_dates(&self, inputs: &Inputs) -> bool {
        inputs.began_s.is_some() && self.augmented.scales.moved.as_ref().is_some_and(|moved| moved.dated)
    }

    /// The added effects that `inputs` could not show, each with the reason; `span` is the range of the response.
    pub fn not_shown_by(&self, inputs: &Inputs, span: f64, library: &Library) -> Vec<(String, String)> {
        let context = Context::new(inputs, self.simulator.as_ref(), span, self.augmented.scales.noise_sd);
        let effects = self.augmented.effects.iter().filter_map(|added| library.find(&added.id));
        effects.filter_map(|effect| effect.testable(&context).err().map(|why| (effect.id().to_string(), why))).collect()
    }

    /// Ids of the added effects.
    pub fn effects(&self) -> Vec<String> {
        self.augmented.effects.iter().map(|added| added.id.clone()).collect()
    }
}
