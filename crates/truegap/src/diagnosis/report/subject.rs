//! What a report is about: the diagnosis, the columns behind it, and how it came to be.
//!
//! Limits: borrowed; nothing is computed but units.

use super::text::Scale;
use truegap_core::Inputs;
use truegap_diagnose::Library;
use truegap_diagnose::answer::{Diagnosis, Traces};

/// Everything that a report draws and tells.
#[derive(Clone, Copy)]
pub struct Subject<'a> {
    /// the answer
    pub diagnosis: &'a Diagnosis,
    /// predictions, a row of the recording each, in the unit of `diagnosis.fit.unit`
    pub traces: &'a Traces,
    /// what was done, SI
    pub inputs: &'a Inputs,
    /// what was read, in the unit of `diagnosis.fit.unit`
    pub response: &'a [f64],
    /// how the report came to be
    pub provenance: &'a Provenance,
    /// the effects that were known
    pub library: &'a Library,
}

/// Where a diagnosis comes from.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Provenance {
    /// command line
    pub command: String,
    /// date and time, UTC
    pub made_at: String,
    /// files read, with their SHA-256
    pub files: Vec<(String, String)>,
    /// whether the search was stopped before its end
    pub interrupted: bool,
    /// whether augmented.toml and prediction.csv were written beside the report
    pub has_model: bool,
}

impl Subject<'_> {
    /// Unit for values of the response.
    pub(super) fn value_scale(&self) -> Scale {
        let largest = self.response.iter().filter(|v| v.is_finite()).fold(0.0, |m: f64, v| m.max(v.abs()));
        Scale::of(&self.diagnosis.fit.unit, largest)
    }

    /// Unit for errors of the response.
    pub(super) fn error_scale(&self) -> Scale {
        error_scale(self.diagnosis)
    }

    /// Recorded less `predicted`, in `scale`'s unit.
    pub(super) fn residual(&self, predicted: &[f64], scale: &Scale) -> Vec<f64> {
        self.response.iter().zip(predicted).map(|(r, p)| scale.factor * (r - p)).collect()
    }

    /// Whether anything was added to the base model.
    pub(super) fn is_augmented(&self) -> bool {
        !self.diagnosis.findings.is_empty()
    }
}

/// Ratio up to which the smallest error still reads well in the unit of the largest.
const APART: f64 = 300.0;

/// Unit in which the errors of a diagnosis read well: that of the largest, unless the smallest would be lost in it.
pub(super) fn error_scale(diagnosis: &Diagnosis) -> Scale {
    let fit = &diagnosis.fit;
    let (large, small) = (fit.in_sample.rmse_before, fit.in_sample.rmse_after.max(fit.noise_floor));
    Scale::of(&fit.unit, if small > 0.0 && large > APART * small { small } else { large })
}
