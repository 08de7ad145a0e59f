//! A recording beside a model file: how it is opened, and what an answer tells of the two.
//!
//! Limits: whether they belong together is for [`super::confirm`] and [`super::compensate`] to say.

use super::DiagnosisError;
use super::request::{Request, named, open};
use crate::models::{ModelFile, RunningModel};
use truegap_core::Recording;
use truegap_diagnose::answer::{ModelFacts, OtherFacts};

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
