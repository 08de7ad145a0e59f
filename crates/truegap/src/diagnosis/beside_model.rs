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
    "{recording}: {what} is {found}, and {wanted} in the model file; correct it there (under [base], [drivers] or [units]), or give the model of such a recording"
)]
#[allow(missing_docs)] // the fields are named by the message
pub struct SaysOtherwise {
    pub recording: String,
    pub what: String,
    pub found: String,
    pub wanted: String,
}

/// Refuses a recording whose base model, sensor or unit of a driver is stated and is not that of the model.
pub(super) fn says_the_same(written: &ModelFile, recording: &Recording, name: &str) -> Result<(), SaysOtherwise> {
    let refused = |what: &str, found: &str, wanted: &str| {
        let (found, wanted) = (format!("`{found}`"), format!("`{wanted}`"));
        Err(SaysOtherwise { recording: name.to_owned(), what: what.to_owned(), found, wanted })
    };
    for driver in &recording.inputs.drivers {
        if let Some(wanted) = written.drivers.get(&driver.name).filter(|wanted| **wanted != driver.unit) {
            return refused(&format!("the unit of the driver `{}`", driver.name), &driver.unit, wanted);
        }
    }
    let assumed = recording.notes.iter().any(|note| matches!(note, Note::BaseAssumed { .. }));
    if assumed || !recording.base.is_stated() {
        return Ok(());
    }
    let (stated, base) = (&recording.base, &written.base);
    if stated.model != word(base) {
        return refused("its base model", &stated.model, word(base));
    }
    if let (Some(found), Some(own)) = (&stated.sensor, base.sensor()) {
        let called = |sensor: Sensor| sensor.name;
        let found = find_sensor(found, recording.path.parent()).map_or_else(|_| found.clone(), called);
        let text = written.sensor.as_ref().and_then(|text| Sensor::from_toml(text, "sensor of the model file").ok());
        let wanted = text.map_or_else(|| own.to_owned(), called);
        if found != wanted {
            return refused("its sensor", &found, &wanted);
        }
    }
    match (stated.further.get("driver").and_then(toml::Value::as_str), base) {
        (Some(found), BaseModel::Linear { driver, .. }) => {
            let wanted = match driver {
                Followed::Column(driver) => driver.role.key(),
                Followed::Named(driver) => &driver.name,
            };
            if found == wanted { Ok(()) } else { refused("what its base model follows", found, wanted) }
        }
        _ => Ok(()),
    }
}

/// The word under `[base]`.
fn word(base: &BaseModel) -> &'static str {
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
