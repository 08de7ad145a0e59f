//! The scorer: diagnoses against opened answers, by the rules of the README of the shared blind recordings.
//!
//! Limits: reads the verdict, findings, sets, mechanisms, stated numbers and held-out errors of a diagnosis, and nothing else of it.

pub mod calibration;
pub mod claim;
pub mod coverage;
pub mod family;
pub mod folder;
pub mod interval;
pub mod judge;
pub mod mechanisms;
pub mod misfit;
pub mod stated;
pub mod table;
pub mod targets;
pub mod told;
pub mod truth;
pub mod words;

use claim::{Claim, ClaimError};
use judge::{Outcome, judge};
use serde_json::Value;
use stated::{Number, numbers};
use truth::Truth;

/// One case with its diagnosis.
#[derive(Debug, Clone)]
pub struct Scored {
    /// What was concealed.
    pub truth: Truth,
    /// What was said.
    pub claim: Claim,
    /// How good that was.
    pub outcome: Outcome,
    /// Share of the misfit removed on fresh histories (see `misfit`), where somebody measured it.
    pub fresh_misfit_removed: Option<f64>,
    /// Seconds that the diagnosis took, where somebody measured it.
    pub seconds: Option<f64>,
    /// Numbers stated, beside what was drawn.
    pub numbers: Vec<Number>,
}

/// Scores `diagnosis` (the content of a `diagnosis.json`) against `truth`.
pub fn score(truth: Truth, diagnosis: &Value) -> Result<Scored, ClaimError> {
    let claim = Claim::read(diagnosis)?;
    let outcome = judge(&truth, &claim);
    let numbers = numbers(&truth.drawn, diagnosis);
    Ok(Scored { truth, claim, outcome, fresh_misfit_removed: None, seconds: None, numbers })
}
