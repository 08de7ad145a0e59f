//! What a diagnosis claims.
//!
//! Limits: the contract of `design.md`, schema `truegap.diagnosis/1`; unknown fields are ignored.

use serde_json::Value;
use std::collections::BTreeSet;

/// Verdicts of the contract.
const VERDICTS: [&str; 6] = ["agrees", "explained", "ambiguous", "wrong_form", "unexplained", "undecided"];

/// The claims of one diagnosis.
#[derive(Debug, Clone, PartialEq)]
pub struct Claim {
    /// Verdict.
    pub verdict: String,
    /// Effects named, with the probability stated where there is one.
    pub findings: Vec<(String, Option<f64>)>,
    /// Sets that the recording cannot tell apart.
    pub ambiguity: Vec<BTreeSet<String>>,
    /// Share of the reproducible held-out misfit removed, as stated.
    pub misfit_removed: Option<f64>,
}

/// Why a diagnosis cannot be scored.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum ClaimError {
    /// No verdict, or none of the six.
    #[error("verdict is `{found}`; write one of agrees, explained, ambiguous, wrong_form, unexplained, undecided")]
    Verdict {
        /// What stood there.
        found: String,
    },
    /// A field has another shape than the contract's.
    #[error("`{field}` is not as in schema truegap.diagnosis/1; see design.md")]
    Shape {
        /// Field.
        field: &'static str,
    },
}

impl Claim {
    /// Reads the content of a `diagnosis.json`.
    pub fn read(diagnosis: &Value) -> Result<Self, ClaimError> {
        let verdict = diagnosis["verdict"].as_str().unwrap_or_default().to_owned();
        if !VERDICTS.contains(&verdict.as_str()) {
            return Err(ClaimError::Verdict { found: diagnosis["verdict"].to_string() });
        }
        let findings = list(diagnosis, "findings")?
            .iter()
            .map(|finding| Some((finding["effect"].as_str()?.to_owned(), finding["probability"].as_f64())))
            .collect::<Option<Vec<_>>>()
            .ok_or(ClaimError::Shape { field: "findings" })?;
        let ambiguity = list(diagnosis, "ambiguity")?
            .iter()
            .map(|set| set.as_array()?.iter().map(|id| id.as_str().map(str::to_owned)).collect())
            .collect::<Option<Vec<_>>>()
            .ok_or(ClaimError::Shape { field: "ambiguity" })?;
        let misfit_removed = diagnosis["fit"]["held_out"]["misfit_removed"].as_f64();
        // `unexplained` may stand in the list as a flexible term; it names no physics.
        let findings = findings.into_iter().filter(|(effect, _)| effect != "unexplained").collect();
        Ok(Self { verdict, findings, ambiguity, misfit_removed })
    }

    /// The effects named.
    pub fn named(&self) -> BTreeSet<&str> {
        self.findings.iter().map(|(effect, _)| effect.as_str()).collect()
    }
}

/// The array at `field`; absent or null counts as empty.
fn list<'a>(diagnosis: &'a Value, field: &'static str) -> Result<&'a [Value], ClaimError> {
    match &diagnosis[field] {
        Value::Null => Ok(&[]),
        Value::Array(items) => Ok(items),
        _ => Err(ClaimError::Shape { field }),
    }
}
