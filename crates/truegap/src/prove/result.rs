//! What a study comes to.
//!
//! Limits: counts and intervals; which rule counts what is the generator's.

use super::plan::Plan;
use serde::Serialize;
use truegap_generator::score::claim::Composed;
use truegap_generator::score::mechanisms::Judged;
use truegap_generator::score::targets::Row;

/// What a study comes to.
#[derive(Clone, Debug, Serialize)]
pub struct Score {
    /// what was asked for, seed included
    pub plan: Plan,
    /// version of the program
    pub version: &'static str,
    /// SHA-256 of `commitments.txt`
    pub commitments_sha256: String,
    /// SHA-256 of `answers.txt`, which was complete before the key was opened
    pub answers_sha256: String,
    /// the targets of `diagnosis.md`, with counts and intervals
    pub targets: Vec<Row>,
    /// single causes in bands of detectability
    pub by_detectability: Vec<Row>,
    /// simpler rules on the same fits
    pub controls: Vec<Control>,
    /// median share of the held-out misfit that a Gaussian process without physics removes, and the cases it rests on: singles and pairs at d >= 16
    pub process_misfit_removed: Option<(f64, usize)>,
    /// one by one
    pub cases: Vec<CaseScore>,
    /// recordings that the diagnosis refused, with its reason; they are in no share
    pub refused: Vec<(String, String)>,
    /// cases whose model could not be tried on a fresh history, with the reason
    pub not_tried_afresh: Vec<(String, String)>,
    /// targets, outcomes by cause and wrong claims, as a person reads them
    #[serde(skip)]
    pub table: String,
}

/// One rule of the controls.
#[derive(Clone, Debug, Serialize)]
pub struct Control {
    /// the rule
    pub says: String,
    /// the targets, counted for it
    pub targets: Vec<Row>,
}

/// One case.
#[derive(Clone, Debug, Serialize)]
pub struct CaseScore {
    /// its name
    pub case: String,
    /// kind of protocol
    pub protocol: String,
    /// what was concealed; a stranger as `stranger:NAME`
    pub concealed: Vec<String>,
    /// detectability of all causes together
    pub detectability: f64,
    /// verdict
    pub verdict: String,
    /// effects named, with the probability stated
    pub named: Vec<(String, Option<f64>)>,
    /// how good that was
    pub outcome: String,
    /// what the words say, where the cause is in no library that the diagnosis had
    #[serde(skip_serializing_if = "Option::is_none")]
    pub words: Option<Worded>,
    /// share of the misfit removed on a fresh history
    pub fresh_misfit_removed: Option<f64>,
    /// wall-clock time of the diagnosis, s
    pub seconds: Option<f64>,
}

/// A mechanism composed of words, and which of them are right.
#[derive(Clone, Debug, Serialize)]
pub struct Worded {
    /// the likeliest words; none where no mechanism was listed
    pub said: Option<Composed>,
    /// which are right
    pub right: Judged,
}

impl Score {
    /// Whether every target that has cases is met.
    pub fn is_met(&self) -> bool {
        self.targets.iter().all(|row| row.met != Some(false)) && self.refused.is_empty()
    }
}
