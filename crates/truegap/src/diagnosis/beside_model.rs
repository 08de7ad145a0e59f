//! A recording beside a model file: how it is opened, whether it says of itself what the model says, and what an answer tells of the two.
//!
//! Limits: whether the model says anything of it is for [`super::confirm`] and [`super::compensate`] to say.

use super::DiagnosisError;
use super::request::{Request, named, open};
use crate::models::{ModelFile, RunningModel};
use crate::predict::find_sensor;
use sha2::{Digest, Sha256};
use truegap_core::{Note, Recording, Sensor};
use truegap_diagnose::answer::{ModelFacts, OtherFacts};
use truegap_model::{BaseModel, Followed};

/// What a recording says of itself and its model otherwise.
#[derive(Debug, thiserror::Error)]
#[error(
    "{recording}: {what} is {found}, and {wanted} in {of}; correct it there (under [base], [drivers] or [units]), or give the model of such a recording"
)]
#[allow(missing_docs)] // the fields are named by the message
pub struct SaysOtherwise {
    pub recording: String,
    pub what: String,
    pub found: String,
    pub wanted: String,
    pub of: &'static str,
}

/// Refuses a recording whose base model, sensor or unit of a driver is stated and is not that of the model.
pub(super) fn says_the_same(written: &ModelFile, recording: &Recording, name: &str) -> Result<(), SaysOtherwise> {
    let own = written.drivers.iter().map(|(name, unit)| (name.as_str(), unit.as_str()));
    let pairs = Pairs { recording, name, of: "the model file" };
    pairs.units(own)?;
    let text = written.sensor.as_ref().and_then(|text| Sensor::from_toml(text, "sensor of the model file").ok());
    let follows = match &written.base {
        BaseModel::Linear { driver: Followed::Column(driver), .. } => Some(driver.role.key()),
        BaseModel::Linear { driver: Followed::Named(driver), .. } => Some(driver.name.as_str()),
        _ => None,
    };
    let sensor = written.base.sensor().map(|own| text.map_or_else(|| own.to_owned(), |sensor| sensor.name));
    pairs.base(word(&written.base), sensor, follows)
}

/// The same beside a recording that is to be diagnosed, before that is done; what the command says of both goes before what their files say.
pub(super) fn says_the_same_as(part: &Recording, recording: &Recording, name: &str) -> Result<(), SaysOtherwise> {
    let own = part.inputs.drivers.iter().map(|driver| (driver.name.as_str(), driver.unit.as_str()));
    let pairs = Pairs { recording, name, of: "the recording that is diagnosed" };
    pairs.units(own)?;
    match states_a_base(part) {
        true => pairs.base(&part.base.model, sensor_of(part), follows(part)),
        false => Ok(()),
    }
}

fn states_a_base(recording: &Recording) -> bool {
    recording.base.is_stated() && !recording.notes.iter().any(|note| matches!(note, Note::BaseAssumed { .. }))
}

/// The name of the stated sensor of a `stack`: another base model takes any word for a specimen.
fn sensor_of(recording: &Recording) -> Option<String> {
    let stated = recording.base.sensor.as_ref().filter(|_| recording.base.model == "stack")?;
    let found = find_sensor(stated, recording.path.parent());
    Some(found.map_or_else(|_| stated.clone(), |sensor| sensor.name))
}

fn follows(recording: &Recording) -> Option<&str> {
    recording.base.further.get("driver").and_then(toml::Value::as_str)
}

/// What a recording states beside what is stated elsewhere, in `of`.
struct Pairs<'a> {
    recording: &'a Recording,
    name: &'a str,
    of: &'static str,
}

impl Pairs<'_> {
    fn alike(&self, what: &str, found: &str, wanted: &str) -> Result<(), SaysOtherwise> {
        if found == wanted {
            return Ok(());
        }
        let (recording, what, of) = (self.name.to_owned(), what.to_owned(), self.of);
        Err(SaysOtherwise { recording, what, found: format!("`{found}`"), wanted: format!("`{wanted}`"), of })
    }

    fn units<'u>(&self, mut own: impl Iterator<Item = (&'u str, &'u str)>) -> Result<(), SaysOtherwise> {
        own.try_for_each(|(name, wanted)| {
            let driver = self.recording.inputs.drivers.iter().find(|driver| driver.name == name);
            driver.map_or(Ok(()), |driver| self.alike(&format!("the unit of the driver `{name}`"), &driver.unit, wanted))
        })
    }

    fn base(&self, model: &str, sensor: Option<String>, followed: Option<&str>) -> Result<(), SaysOtherwise> {
        if !states_a_base(self.recording) {
            return Ok(());
        }
        self.alike("its base model", &self.recording.base.model, model)?;
        if let (Some(found), Some(wanted)) = (sensor_of(self.recording), sensor) {
            self.alike("its sensor", &found, &wanted)?;
        }
        match (follows(self.recording), followed) {
            (Some(found), Some(wanted)) => self.alike("what its base model follows", found, wanted),
            _ => Ok(()),
        }
    }
}

/// The word under `[base]`.
pub(super) fn word(base: &BaseModel) -> &'static str {
    match base {
        BaseModel::Stack { .. } => "stack",
        BaseModel::ParallelPlate { .. } => "parallel-plate",
        BaseModel::GapPlate { .. } => "gap-plate",
        BaseModel::Constant { .. } => "constant",
        BaseModel::External { .. } => "external",
        BaseModel::Linear { .. } => "linear",
        BaseModel::Table { .. } => "table",
        BaseModel::Command { .. } => "command",
        BaseModel::Function { .. } => "function",
    }
}

/// SHA-256 of the readings as numbers: of a table that was saved again, with other bytes, it is the same.
pub(super) fn hash_of_readings(recording: &Recording) -> String {
    let mut hash = Sha256::new();
    recording.response.iter().for_each(|value| hash.update(value.to_bits().to_le_bytes()));
    hash.finalize().iter().map(|byte| format!("{byte:02x}")).collect()
}

/// Whether the model was fitted to this recording, or to one of the same readings.
pub(super) fn took_part(written: &ModelFile, recording: &Recording) -> bool {
    let among = |hashes: &str, hash: &str| !hash.is_empty() && hashes.split_whitespace().any(|known| known == hash);
    let readings = written.readings_sha256.as_deref().unwrap_or_default();
    among(&written.sha256, &recording.sha256) || among(readings, &hash_of_readings(recording))
}

/// The recording as a diagnosis would take it, and its name; `channel` is its sensor column where it holds several.
pub(super) fn opened(recording: Recording, channel: Option<&str>) -> Result<(Recording, String), DiagnosisError> {
    let name = named(&recording);
    let request = Request { channel: channel.map(str::to_owned), ..Request::default() };
    Ok((open(vec![recording], &request)?.recording, name))
}

/// The model, for the record; `file` is its name.
pub(super) fn model_facts(model: &RunningModel, written: &ModelFile, file: &str) -> ModelFacts {
    ModelFacts {
        file: file.to_owned(),
        recording: written.recording.clone(),
        sha256: written.sha256.clone(),
        verdict: written.verdict.clone(),
        effects: model.effects(),
        base_is_known: model.base_is_known(),
    }
}

/// The recording, for the record; `name` is where it comes from.
pub(super) fn recording_facts(recording: &Recording, name: &str) -> OtherFacts {
    OtherFacts {
        source: name.to_owned(),
        sha256: recording.sha256.clone(),
        rows: recording.len(),
        runs: recording.inputs.runs().len(),
    }
}
