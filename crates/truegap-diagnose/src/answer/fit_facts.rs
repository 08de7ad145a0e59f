//! Errors in sample and on rows left out, as `diagnosis.json` has them.
//!
//! Limits: plain data.

use crate::{answer::parameter_facts::ParameterFacts, explain::locate::Mismatch, selection::verdict::Verdict};
use serde::Serialize;

/// Errors before and after.
#[derive(Clone, Debug, Serialize)]
pub struct FitFacts {
    /// all rows fitted
    pub in_sample: BeforeAfter,
    /// rows left out
    pub held_out: HeldOut,
    /// noise of one row, response unit
    pub noise_floor: f64,
    /// response unit
    pub unit: String,
}

/// Root-mean-square errors.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct BeforeAfter {
    /// calibrated base model
    pub rmse_before: f64,
    /// with the findings
    pub rmse_after: f64,
}

/// Errors on rows that the fit did not see.
#[derive(Clone, Debug, Serialize)]
pub struct HeldOut {
    /// how rows were left out
    pub how: String,
    /// calibrated base model, over the rows that both models predict; absent (null) where there is none
    pub rmse_before: Option<f64>,
    /// with the findings, over the same rows
    pub rmse_after: Option<f64>,
    /// share of the reproducible misfit that the findings remove; absent where there is none to remove
    pub misfit_removed: Option<f64>,
    /// the same share for an added term of equal freedom driven by a permuted history
    #[serde(rename = "shuffled_control", skip_serializing_if = "Option::is_none")]
    pub permutation_control: Option<f64>,
    /// per part left out that both models predict: name, before, after
    pub parts: Vec<(String, f64, f64)>,
    /// of each of several recordings
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub recordings: Vec<RecordingError>,
    /// the choice made again without each part, where that was asked for
    #[serde(skip_serializing_if = "Option::is_none")]
    pub selected_again: Option<SelectedAgain>,
}

/// What is named where each part of the recording is left out of the choice as well, and the errors of that choice on it.
#[derive(Clone, Debug, Serialize)]
pub struct SelectedAgain {
    /// sentence with the counts
    pub says: String,
    /// parts without which the same effects are named as with all rows
    pub same: usize,
    /// error over all parts that could be predicted, each by what was chosen without it; absent (null) where there is none
    pub rmse: Option<f64>,
    /// each part left out
    pub parts: Vec<SelectedWithout>,
}

/// The choice without one part.
#[derive(Clone, Debug, Serialize)]
pub struct SelectedWithout {
    /// the part
    pub part: String,
    /// what was decided without it
    pub verdict: Verdict,
    /// effects named without it
    pub named: Vec<String>,
    /// error on its rows; absent (null) where they could not be predicted
    pub rmse: Option<f64>,
}

/// Errors on rows left out of one of several recordings.
#[derive(Clone, Debug, Serialize)]
pub struct RecordingError {
    /// its number, from 1
    pub recording: usize,
    /// calibrated base model, over the rows that both models predict; absent (null) where there is none
    pub rmse_before: Option<f64>,
    /// with the findings, over the same rows
    pub rmse_after: Option<f64>,
    /// noise of one row
    pub noise_floor: f64,
}

/// A flexible term, for prediction only: what the nearest effects of the library can follow of a mismatch that none of them explains.
#[derive(Clone, Debug, Serialize)]
pub struct PredictionOnly {
    /// sentence with numbers
    pub says: String,
    /// its parts; no claim about the cause
    pub terms: Vec<FlexibleTerm>,
    /// all rows fitted
    pub in_sample: BeforeAfter,
    /// rows left out, as in [`FitFacts::held_out`]
    pub held_out: BeforeAfter,
    /// share of the reproducible misfit that it removes on rows left out; absent where there is none to remove
    pub misfit_removed: Option<f64>,
    /// the same share for a term of equal freedom driven by a permuted history
    #[serde(rename = "shuffled_control", skip_serializing_if = "Option::is_none")]
    pub permutation_control: Option<f64>,
    /// where recording and prediction still differ
    pub remains: Vec<Mismatch>,
}

/// One part of a flexible term.
#[derive(Clone, Debug, Serialize)]
pub struct FlexibleTerm {
    /// id of the effect whose equation it borrows
    pub shaped_like: String,
    /// what that effect would say
    pub says: String,
    /// fitted parameters
    pub parameters: Vec<ParameterFacts>,
}

/// Root-mean-square errors with their unit.
#[derive(Clone, Debug, Serialize)]
pub struct BeforeAfterUnit {
    /// without the effect, over the rows that both models predict; absent (null) where there is none
    pub rmse_before: Option<f64>,
    /// with the effect, over the same rows
    pub rmse_after: Option<f64>,
    /// unit
    pub unit: String,
}
