//! What a diagnosis claims.
//!
//! Limits: the contract of `design.md`, schema `truegap.diagnosis/1`; unknown fields are ignored.

use serde::Serialize;
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
    /// The first mechanism composed of words, named or listed only.
    pub mechanism: Option<Composed>,
    /// What the answer is in words: that mechanism, or where there is none the effect named that stands out most, by the words of all that may stand in its place.
    pub in_words: Option<Composed>,
}

/// A mechanism composed of words: the likeliest value of each.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Composed {
    /// Where.
    pub place: String,
    /// What it follows.
    pub driver: String,
    /// How in time.
    pub kinetics: String,
    /// Whether the verdict stands behind it.
    pub named: bool,
    /// Share of the reproducible misfit that it removes on rows left out; none where there was nothing to remove.
    pub misfit_removed: Option<f64>,
}

impl Composed {
    /// The first of `discovered`; `floor` is the noise, in the unit of its errors.
    fn first(diagnosis: &Value) -> Option<Self> {
        let first = diagnosis["discovered"].as_array()?.first()?;
        Self::of(first, "probability", first["named"].as_bool().unwrap_or(false), diagnosis)
    }

    /// The words of the finding that stands out most.
    fn clearest(diagnosis: &Value) -> Option<Self> {
        let stands_out = |finding: &&Value| finding["detectability"].as_f64().unwrap_or(0.0);
        let clearest = diagnosis["findings"].as_array()?.iter().max_by(|a, b| stands_out(a).total_cmp(&stands_out(b)))?;
        Self::of(clearest, "words", true, diagnosis)
    }

    /// The likeliest words under `key`.
    fn of(said: &Value, key: &str, named: bool, diagnosis: &Value) -> Option<Self> {
        let floor = diagnosis["fit"]["noise_floor"].as_f64().unwrap_or(0.0);
        Some(Self {
            place: likeliest(said, key, "place")?,
            driver: likeliest(said, key, "driver")?,
            kinetics: likeliest(said, key, "kinetics")?,
            named,
            misfit_removed: removed(&said["held_out"], floor),
        })
    }
}

/// The value of a word with the largest probability; that of the best sentence where none are given.
fn likeliest(mechanism: &Value, key: &str, word: &str) -> Option<String> {
    let all = mechanism[key][word].as_object();
    let best = all.and_then(|all| all.iter().max_by(|a, b| a.1.as_f64().unwrap_or(0.0).total_cmp(&b.1.as_f64().unwrap_or(0.0))));
    best.map(|(value, _)| value.clone()).or_else(|| mechanism[word].as_str().map(str::to_owned))
}

/// `1 - (after^2 - floor^2) / (before^2 - floor^2)`; none where the error before is within a hundredth of the noise.
fn removed(held_out: &Value, floor: f64) -> Option<f64> {
    let (before, after) = (held_out["rmse_before"].as_f64()?, held_out["rmse_after"].as_f64()?);
    let there = before * before - floor * floor;
    (there > 0.02 * floor * floor).then(|| 1.0 - (after * after - floor * floor) / there)
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
        let mechanism = Composed::first(diagnosis);
        let in_words = mechanism.clone().or_else(|| Composed::clearest(diagnosis));
        Ok(Self { verdict, findings, ambiguity, misfit_removed, mechanism, in_words })
    }

    /// The effects of a library that are named: all but mechanisms composed of words.
    pub fn of_library(&self) -> BTreeSet<&str> {
        self.named().into_iter().filter(|name| !name.starts_with("discovered")).collect()
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
