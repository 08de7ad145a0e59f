//! What stands beside the findings: every effect tried alone, sets that cannot be told apart, causes outside the library, sizes that would have been seen,
//! and what the recovery bank says of all of them.
//!
//! Limits: decides nothing.

use crate::{
    answer::{
        assemble::Answer,
        diagnosis::{Candidate, SmallestVisible, UnlistedCause},
    },
    effects::memory::elapsed_s,
    selection::{detectability::visible_size, unmodelled::Unlisted, verdict::Verdict},
    validation::recovery::confusion::Bank,
};
/// Id that stands for what no effect of the library explains.
const UNEXPLAINED: &str = "unexplained";

/// Log evidence from which a cause outside the library is worth mentioning where nothing is named.
const NEARLY: f64 = 10.0;

/// Detectability at which an effect would have been seen.
const SEEN: f64 = 6.0;

impl Answer<'_> {
    /// The bank with the rows that matter for what is named, and for its rivals.
    pub(crate) fn bank_facts(&self, bank: &Bank) -> serde_json::Value {
        let mut effects: Vec<usize> = self.chosen().effects.clone();
        effects.extend(self.decision.sets.iter().flatten());
        let mut seen = std::collections::BTreeSet::new();
        effects.retain(|e| seen.insert(*e));
        let mut lines = bank.says_overall();
        lines.extend(effects.iter().flat_map(|e| bank.says(&self.id(*e))));
        let mut value = serde_json::to_value(bank).unwrap_or_default();
        value["says"] = lines.into();
        value
    }

    /// Every effect tried alone, likeliest first.
    pub(crate) fn candidates(&self) -> Vec<Candidate> {
        let base = &self.selection.base().fit;
        let single = |effect: usize| {
            self.selection.with(&[effect]).map(|t| Candidate {
                effect: self.id(effect),
                probability: self.selection.effect_probability[effect],
                score: t.fit.log_evidence - base.log_evidence,
                chi2_drop: base.chi2 - t.fit.chi2,
                freedom: t.fit.z.len() - base.z.len(),
            })
        };
        let mut list: Vec<Candidate> = (0..self.search.library.len()).filter_map(single).collect();
        list.sort_by(|a, b| b.probability.total_cmp(&a.probability).then(b.score.total_cmp(&a.score)));
        list
    }

    /// Sets whose members this recording cannot tell apart.
    pub(crate) fn ambiguity(&self) -> Vec<Vec<String>> {
        if self.decision.verdict != Verdict::Ambiguous {
            return Vec::new();
        }
        let several = |s: &&Vec<usize>| s.len() > 1 || self.decision.outside_rivals;
        let names = |s: &Vec<usize>| {
            let outside = self.decision.outside_rivals.then(|| UNEXPLAINED.to_owned());
            s.iter().map(|e| self.id(*e)).chain(outside).collect()
        };
        self.decision.sets.iter().filter(several).map(names).collect()
    }

    /// What the reading does, and where, where it does so at one place.
    pub(crate) fn says_of(&self, unlisted: &Unlisted) -> String {
        let says = unlisted.cause.says();
        let inputs = self.search.problem.inputs;
        unlisted.row.map_or_else(
            || says.to_owned(),
            |row| format!("{says} (clearest in run {}, near {:.0} s)", inputs.run[row], elapsed_s(inputs, row)),
        )
    }

    /// The tone, or else the loudest burst, of what the model stood behind leaves, in words; `None` where there is neither.
    pub(crate) fn heard_says(&self) -> Option<String> {
        let (tone, burst, inputs) = (self.heard.tone, self.heard.burst, self.all.problem.inputs);
        if tone.is_heard() {
            let at = tone.frequency_hz.map_or_else(|| format!("{:.4} cycles a row", tone.per_row), |hz| format!("{hz:.4} Hz"));
            return Some(format!(
                "a tone at {at} (as sampled; it may be a faster one), {:.2} times as large as the noise",
                tone.amplitude
            ));
        }
        burst.is_heard().then(|| {
            let (run, time) = (inputs.run[burst.row], elapsed_s(inputs, burst.row));
            let loudness = burst.loudness;
            format!("short bursts, the loudest in run {run} near {time:.0} s with {loudness:.1} times the scatter of the noise")
        })
    }

    /// The cause outside the library that comes nearest, where the library explains too little and none outside it is likelier.
    pub(crate) fn nearest_outside(&self) -> String {
        let nearest = self.selection.unlisted.first().filter(|(u, _)| u.gain > NEARLY);
        nearest.map_or_else(String::new, |(u, _)| format!("; of what lies outside it, nearest is that {}", self.says_of(u)))
    }

    /// Causes outside the library that are not negligible.
    pub(crate) fn unlisted(&self) -> Vec<UnlistedCause> {
        let cause = |(u, probability): (&Unlisted, f64)| UnlistedCause {
            says: self.says_of(u),
            beside: u.effects.iter().map(|e| self.id(*e)).collect(),
            probability,
        };
        self.selection.unlisted_probabilities().map(cause).filter(|u| u.probability > 0.01).collect()
    }

    /// The smallest size of each effect that is not named at which it would have been seen.
    pub(crate) fn smallest_visible(&self) -> Vec<SmallestVisible> {
        let named = &self.chosen().effects;
        let base = self.selection.base();
        let visible = |effect: usize| {
            let tried = self.selection.with(&[effect])?;
            let parameter = self.search.model(&tried.effects).parameters[base.fit.z.len()].clone();
            let size = visible_size(self.search, base, tried, SEEN)?;
            Some(SmallestVisible { effect: self.id(effect), parameter: parameter.name, unit: parameter.unit, size })
        };
        (0..self.search.library.len()).filter(|e| !named.contains(e)).filter_map(visible).collect()
    }
}
