//! One recording of the bank: what was put in, and what was said of it.
//!
//! Limits: of the models only those that matter are kept.

use crate::{
    selection::{candidates::Search, examine::Examined, verdict::Verdict},
    validation::tuning::KEPT_LOG_PROBABILITY,
};
use serde::{Deserialize, Serialize};

/// What a simulated recording conceals.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Truth {
    /// ids of the effects
    pub effects: Vec<String>,
    /// made by the effects' sibling equations
    pub sibling: bool,
    /// a cause that no library holds
    #[serde(rename = "stranger")]
    pub unmodelled: Option<String>,
    /// detectability of all together; 0 where nothing is concealed
    pub detectability: f64,
}

/// One recording of the bank, answered.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct BankCase {
    /// what was put in
    pub truth: Truth,
    /// verdict, as in `diagnosis.json`
    pub verdict: String,
    /// effects named
    pub named: Vec<String>,
    /// sets that could not be told apart
    pub sets: Vec<Vec<String>>,
    /// models with their log probabilities, likeliest first
    pub models: Vec<(Vec<String>, f64)>,
    /// causes outside the library: effects that each stands beside, and its log odds against all models together
    pub unmodelled: Vec<(Vec<String>, f64)>,
}

impl BankCase {
    /// The answer in names.
    pub fn of(truth: Truth, answer: &Examined, search: &Search<'_>) -> Self {
        let names = |effects: &[usize]| effects.iter().map(|e| search.library[*e].id().to_string()).collect::<Vec<_>>();
        let (selection, decision) = (&answer.selection, &answer.decision);
        let models = selection.models.iter().zip(&selection.probability).map(|(m, p)| (names(&m.effects), p.ln()));
        let outside = selection.unmodelled.iter().map(|(u, odds)| (names(&u.effects), odds.ln()));
        let ambiguous = decision.verdict == Verdict::Ambiguous;
        Self {
            truth,
            verdict: decision.verdict.word().to_owned(),
            named: names(&selection.models[decision.model].effects),
            sets: if ambiguous { decision.sets.iter().map(|s| names(s)).filter(|s| s.len() > 1).collect() } else { Vec::new() },
            models: models.filter(|(_, p)| *p > KEPT_LOG_PROBABILITY).collect(),
            unmodelled: outside.filter(|(_, odds)| *odds > KEPT_LOG_PROBABILITY).collect(),
        }
    }

    /// Whether exactly the concealed effects are named; for none and for unmodelled causes, whether nothing is.
    pub fn right(&self) -> bool {
        let mut named = self.named.clone();
        let mut concealed = self.truth.effects.clone();
        named.sort();
        concealed.sort();
        named == concealed
    }

    /// Whether what is concealed was named, or stands in a set with what was.
    pub fn within(&self) -> bool {
        let held = |e: &String| self.named.contains(e) || self.sets.iter().any(|s| s.contains(e));
        let excused = |n: &String| {
            let shared = |s: &Vec<String>| s.contains(n) && s.iter().any(|e| self.truth.effects.contains(e));
            self.truth.effects.contains(n) || self.sets.iter().any(shared)
        };
        self.truth.effects.iter().all(held) && self.named.iter().all(excused)
    }
}
