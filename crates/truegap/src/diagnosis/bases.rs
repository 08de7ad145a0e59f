//! Base models of recordings that are diagnosed together: one for each specimen.
//!
//! Limits: recordings are of one specimen where model, sensor and options under [base] are the same.

use super::DiagnosisError;
use super::request::{Opened, together};
use crate::models::{Base, base_model_with};
use truegap_core::Recording;

/// Parameters of the stack that belong to a material, and are therefore common to sensors of different size.
pub(super) const MATERIALS: [&str; 2] = ["young_rtv", "softening_rtv"];

/// A base model for each specimen, and the specimen of each recording.
pub(super) struct Bases {
    /// one a specimen
    pub bases: Vec<Base>,
    /// index into `bases`, one a recording; empty where there is one recording
    pub specimen: Vec<usize>,
}

impl Bases {
    /// Model of a recording.
    pub fn simulator(&self, recording: usize) -> &dyn truegap_core::Simulator {
        self.bases[self.specimen.get(recording).copied().unwrap_or(0)].simulator.as_ref()
    }
}

/// The base models of what was opened.
pub(super) fn bases(opened: &Opened) -> Result<Bases, DiagnosisError> {
    if opened.parts.is_empty() {
        return Ok(Bases { bases: vec![base_model_with(&opened.recording, &opened.programs)?], specimen: Vec::new() });
    }
    let keys: Vec<String> = opened.parts.iter().map(key).collect();
    let mut distinct: Vec<&String> = Vec::new();
    for key in &keys {
        if !distinct.contains(&key) {
            distinct.push(key);
        }
    }
    let of_key = |wanted: &&String| -> Result<Base, DiagnosisError> {
        let members = opened.parts.iter().zip(&keys).filter(|(_, key)| key == wanted);
        let members: Vec<Recording> = members.map(|(part, _)| part.clone()).collect();
        Ok(base_model_with(&together(&members)?, &opened.programs)?)
    };
    let bases = distinct.iter().map(of_key).collect::<Result<Vec<_>, _>>()?;
    let specimen = keys.iter().map(|key| distinct.iter().position(|k| *k == key).unwrap_or(0)).collect();
    Ok(Bases { bases, specimen })
}

/// What tells specimens apart: the sensor's file where there is one, else its name.
fn key(recording: &Recording) -> String {
    let base = &recording.base;
    let beside = base.sensor.as_ref().and_then(|name| recording.path.parent().map(|folder| folder.join(name)));
    let file = beside.and_then(|path| path.canonicalize().ok()).map(|path| path.display().to_string());
    format!("{} {:?} {:?} {:?}", base.model, file.or_else(|| base.sensor.clone()), base.warp, base.further)
}
