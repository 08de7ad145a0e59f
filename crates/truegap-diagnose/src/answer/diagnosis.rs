//! What a diagnosis says: the contents of `diagnosis.json` (`truegap.diagnosis/1`).
//!
//! Limits: plain data; nothing here decides anything.

use crate::{
    adequacy::{
        interference::{burst::Burst, tone::Tone},
        lack_of_fit::Adequacy,
    },
    answer::{
        confirmation::Confirmed,
        discovered_facts::DiscoveredFacts,
        fit_facts::{BeforeAfterUnit, FitFacts, PredictionOnly},
        parameter_facts::ParameterFacts,
        permuted_searches::PermutedSearches,
        tuning::DOUBTFUL,
    },
    discovery::marginals::WordProbabilities,
    explain::{
        conflicts::Conflict, hidden_input::slow_input::ConcealedColumn, locate::Mismatch, next_experiment::NextExperiment,
    },
    quality::notice::Notice,
    seeds::Seeds,
    selection::{model_space::EvidenceCheck, tuning::DETECTED, verdict::Verdict},
    validation::reference::Reference,
};
use serde::Serialize;

/// Identifier of the file format.
pub const SCHEMA: &str = "truegap.diagnosis/1";

/// The whole answer.
#[derive(Clone, Debug, Serialize)]
pub struct Diagnosis {
    /// always [`SCHEMA`]
    pub schema: &'static str,
    /// version of the program that made it
    pub version: &'static str,
    /// what was read
    pub recording: RecordingFacts,
    /// calibrated base model
    pub base: BaseFacts,
    /// noise as estimated, and from what
    pub noise: NoiseFacts,
    /// one of the six
    pub verdict: Verdict,
    /// posterior probability that nothing is missing, on the scale of all probabilities here: models of the library and unmodelled causes together make 1
    pub probability_agrees: f64,
    /// the verdict as a sentence with its reasons
    pub says: String,
    /// whether calibration had absorbed an effect
    pub concealed: bool,
    /// parameters pushed away from what is known of them, or different between regimes
    pub conflicts: Vec<Conflict>,
    /// where recording and calibrated base model differ
    pub mismatch: Vec<Mismatch>,
    /// where recording and the model with the findings still differ: for `wrong_form`, and for `explained` where something is left
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub remains: Vec<Mismatch>,
    /// effects that the tool stands behind
    pub findings: Vec<Finding>,
    /// smaller effects of the same model, without a claim to their names: an equation of a finding that is slightly off leaves as much
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub carried: Vec<Finding>,
    /// mechanisms composed of words: where the library left something, named or not, and else what it explains as if no effect had a name
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub discovered: Vec<DiscoveredFacts>,
    /// every effect tried alone, likeliest first
    pub candidates: Vec<Candidate>,
    /// causes outside the library that are not negligible, likeliest first
    #[serde(rename = "unlisted")]
    pub unmodelled: Vec<UnmodelledCause>,
    /// sets of which the recording cannot tell the members apart
    pub ambiguity: Vec<Vec<String>>,
    /// errors before and after
    pub fit: FitFacts,
    /// what a straight line and a smooth curve through the recorded inputs make of the same rows
    pub reference: Vec<Reference>,
    /// said where the straight line is better than the calibrated base model
    #[serde(skip_serializing_if = "Option::is_none")]
    pub reference_says: Option<String>,
    /// a term that serves prediction where nothing may be named
    #[serde(skip_serializing_if = "Option::is_none")]
    pub prediction_only: Option<PredictionOnly>,
    /// the whole search on permuted histories, where that was asked for
    #[serde(skip_serializing_if = "Option::is_none")]
    pub permuted_searches: Option<PermutedSearches>,
    /// what a recording that took no part says of the findings, where one was given
    #[serde(skip_serializing_if = "Option::is_none")]
    pub confirmation: Option<Confirmed>,
    /// effects that this recording could not have shown
    pub not_testable: Vec<NotTestable>,
    /// per effect, the smallest size that would have been seen
    pub smallest_visible: Vec<SmallestVisible>,
    /// what to measure next
    pub next_experiment: NextExperiment,
    /// rows of the recovery bank, where it was run
    #[serde(skip_serializing_if = "Option::is_none")]
    pub bank: Option<serde_json::Value>,
    /// tests of what is left over: of the base model, and of the likeliest model that names something
    pub adequacy: AdequacyFacts,
    /// how the approximation of the evidence fared against sampling
    pub evidence_check: EvidenceCheck,
    /// what is wrong with the recording: what, where, with unit, and how to fix it
    pub notices: Vec<Notice>,
    /// a column that was hidden on purpose, and how well its course was recovered without it
    #[serde(skip_serializing_if = "Option::is_none")]
    pub concealed_column: Option<ConcealedColumn>,
    /// doubts about the recording itself (dead channel, clipping, outliers, gaps in time)
    pub recording_issues: Vec<String>,
    /// seeds of everything that was drawn by chance; absent in answers of earlier versions
    #[serde(skip_serializing_if = "Option::is_none")]
    pub seeds: Option<Seeds>,
    /// wall-clock time, s
    pub seconds: f64,
}

/// Is a model adequate? Tests that know no effect.
#[derive(Clone, Debug, Default, Serialize)]
pub struct AdequacyFacts {
    /// of the calibrated base model
    pub before: Option<Adequacy>,
    /// of the likeliest model that names something
    pub after: Option<Adequacy>,
    /// the loudest burst in what the model stood behind leaves, on every row
    pub burst: Option<Burst>,
    /// the strongest tone in the same
    pub tone: Option<Tone>,
    /// whether one of these two is what there is to say, and nothing that is missing
    #[serde(rename = "heard")]
    pub interference: bool,
    /// share of the misfit that the latter removes
    pub removed: f64,
}

/// What was read.
#[derive(Clone, Debug, Default, Serialize)]
pub struct RecordingFacts {
    /// rows used
    pub rows: usize,
    /// runs
    pub runs: usize,
    /// SHA-256 of the CSV
    pub sha256: String,
    /// where it came from
    pub source: String,
    /// each of several recordings
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub recordings: Vec<OneRecording>,
    /// which parameters several recordings have in common
    #[serde(skip_serializing_if = "Option::is_none")]
    pub sharing: Option<crate::data::joint::share::Sharing>,
}

/// One of several recordings.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct OneRecording {
    /// number, from 1, as parameters and sentences have it
    pub number: usize,
    /// where it came from
    pub source: String,
    /// sensor, for `stack`
    #[serde(skip_serializing_if = "Option::is_none")]
    pub sensor: Option<String>,
    /// rows used
    pub rows: usize,
    /// runs
    pub runs: usize,
    /// number of its first run among all
    pub first_run: u32,
    /// SHA-256 of the CSV
    pub sha256: String,
}

/// The calibrated base model.
#[derive(Clone, Debug, Serialize)]
pub struct BaseFacts {
    /// `stack`, `parallel-plate`, ...
    pub model: String,
    /// sensor, for `stack`
    #[serde(skip_serializing_if = "Option::is_none")]
    pub sensor: Option<String>,
    /// parameters calibrated without any added effect
    pub parameters: Vec<ParameterFacts>,
    /// the same parameters with the findings added
    pub parameters_after: Vec<ParameterFacts>,
}

/// The noise model.
#[derive(Clone, Debug, Serialize)]
pub struct NoiseFacts {
    /// where it comes from, for a reader
    pub says: String,
    /// white standard deviation, response unit
    pub white_sd: f64,
    /// stationary standard deviation of the autoregressive part, response unit
    pub ar_sd: f64,
    /// its correlation from row to row
    pub ar_correlation: f64,
    /// standard deviation of what lasts beside these, response unit: slow noise like 1/f, or steps of the converter; 0 where there is none
    pub lasting_sd: f64,
    /// standard deviation of the recorded load, SI (N or Pa)
    pub load_sd: f64,
    /// standard deviation of the recorded temperature, K
    pub temperature_sd: f64,
    /// whether the noise could be measured apart from the mismatch
    pub measured: bool,
    /// of each of several recordings; the numbers above are those of the first
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub recordings: Vec<RecordingNoiseFacts>,
}

/// The noise of one of several recordings.
#[derive(Clone, Debug, Serialize)]
pub struct RecordingNoiseFacts {
    /// its number, from 1
    pub recording: usize,
    /// where it comes from, for a reader
    pub says: String,
    /// white standard deviation, response unit
    pub white_sd: f64,
    /// stationary standard deviation of the autoregressive part, response unit
    pub ar_sd: f64,
    /// its correlation from row to row
    pub ar_correlation: f64,
}

/// An effect that the tool stands behind.
#[derive(Clone, Debug, Serialize)]
pub struct Finding {
    /// stable id
    pub effect: String,
    /// probability that the name is right: how often names were that stood as high among the models, alone or beside others
    pub probability: f64,
    /// probability that it belongs to the model, were one of the models that were fitted the truth; verdicts follow this one
    pub probability_among_models: f64,
    /// sentence with numbers
    pub says: String,
    /// sqrt of what calibration cannot absorb, in noise units; null where the model has no answer without the effect
    pub detectability: Option<f64>,
    /// fitted parameters
    pub parameters: Vec<ParameterFacts>,
    /// error on runs left out, before and after this effect is added
    pub held_out: BeforeAfterUnit,
    /// effects that this recording cannot quite exclude in its place
    pub rivals: Vec<String>,
    /// what it is whatever its name: where it acts, what it follows, how in time, each with the probability that it and its rivals share out; empty where no words
    /// say it
    #[serde(skip_serializing_if = "WordProbabilities::is_empty")]
    pub words: WordProbabilities,
}

impl Diagnosis {
    /// Whether it is open that anything is missing: undecided, and "nothing is missing" is not excluded.
    pub fn is_open(&self) -> bool {
        self.verdict == Verdict::Undecided && self.probability_agrees >= DETECTED
    }
}

impl Finding {
    /// Whether the name is more often wrong than right, so that a sentence says "perhaps".
    pub fn is_doubtful(&self) -> bool {
        self.probability < DOUBTFUL
    }
}

/// One effect tried alone.
#[derive(Clone, Debug, Serialize)]
pub struct Candidate {
    /// id
    pub effect: String,
    /// posterior probability of belonging to the model
    pub probability: f64,
    /// gain in log evidence over the base model
    pub score: f64,
    /// fall of the sum of squares of the whitened residual
    pub chi2_drop: f64,
    /// free parameters that it adds
    pub freedom: usize,
}

/// A cause outside the library, weighed beside it.
#[derive(Clone, Debug, Serialize)]
pub struct UnmodelledCause {
    /// what the reading does
    pub says: String,
    /// effects of the library beside it
    pub beside: Vec<String>,
    /// posterior probability
    pub probability: f64,
}

/// An effect that this recording could not have shown.
#[derive(Clone, Debug, Serialize)]
pub struct NotTestable {
    /// id
    pub effect: String,
    /// why
    pub says: String,
}

impl NotTestable {
    /// Whether people would miss it: a rig that records for hours shows no cycle of a day, and nobody expects it to.
    pub fn would_be_missed(&self) -> bool {
        self.says != crate::effects::cycle::TOO_SHORT
    }
}

/// How small an effect may be and still be seen.
#[derive(Clone, Debug, Serialize)]
pub struct SmallestVisible {
    /// id
    pub effect: String,
    /// name of its size parameter
    pub parameter: String,
    /// unit of the size
    pub unit: String,
    /// size at detectability 6
    pub size: f64,
}
