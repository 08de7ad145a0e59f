//! A mechanism from outside the library, as `diagnosis.json` has it.
//!
//! Limits: plain data.

use crate::{
    answer::{fit_facts::BeforeAfterUnit, parameter_facts::ParameterFacts},
    discovery::marginals::WordProbabilities,
    effects::composed::{file::MechanismFile, mechanism::Sentence},
};
use serde::Serialize;

/// A mechanism that no library lists.
#[derive(Clone, Debug, Serialize)]
pub struct DiscoveredFacts {
    /// where in the chain
    pub place: String,
    /// what it follows
    pub driver: String,
    /// how in time
    pub kinetics: String,
    /// the law
    pub form: String,
    /// how it acts
    pub action: String,
    /// the words with their varieties, as a model file has them
    pub sentence: Sentence,
    /// whether the verdict stands behind it
    pub named: bool,
    /// whether the model stood behind holds it without a claim: it predicts rows left out, beside what is named
    pub carried: bool,
    /// whether the library has an answer, which this puts into words as if no effect had a name
    pub in_other_words: bool,
    /// log odds of what was composed against all of the library and all unmodelled courses together; natural logarithm; absent where it stands beside as many effects as a model may have
    pub log_odds: Option<f64>,
    /// probability of each value of each word
    pub probability: WordProbabilities,
    /// the words as a clause
    pub clause: String,
    /// sentence with numbers
    pub says: String,
    /// known physics that the words fit, each with a source; no claim
    pub could_be: Vec<String>,
    /// fitted numbers
    pub parameters: Vec<ParameterFacts>,
    /// error on rows left out, of the calibrated base model and with everything that the mechanism's model holds
    pub held_out: BeforeAfterUnit,
    /// share of turned histories in which the same freedom removes as much by chance
    pub control_p_value: f64,
    /// columns that were weighed
    pub weighed: usize,
    /// the mechanism as a file, for other recordings
    #[serde(skip)]
    pub file: MechanismFile,
}
