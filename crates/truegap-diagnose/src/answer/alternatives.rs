//! What stands beside the findings: every effect tried alone, sets that cannot be told apart, unmodelled causes, sizes that would have been seen,
//! and what the recovery bank says of all of them.
//!
//! Limits: decides nothing.

use crate::{
    answer::tuning::{NOT_NEGLIGIBLE, SEEN},
    answer::{
        diagnosis::{Candidate, SmallestVisible, UnmodelledCause},
        found::Found,
    },
    effects::memory::elapsed_s,
    selection::{detectability::visible_size, unmodelled::Unmodelled, verdict::Verdict},
    validation::recovery::confusion::Bank,
};

/// Id that stands for what no effect of the library explains.
const UNEXPLAINED: &str = "unexplained";

/// The bank with the rows that matter for what is named, and for its rivals.
pub(crate) fn bank_facts(found: &Found<'_>, bank: &Bank) -> serde_json::Value {
    let mut effects: Vec<usize> = found.chosen().effects.clone();
    effects.extend(found.decision.sets.iter().flatten());
    let mut seen = std::collections::BTreeSet::new();
    effects.retain(|e| seen.insert(*e));
    let mut lines = bank.says_overall();
    lines.extend(effects.iter().flat_map(|e| bank.says(&found.id(*e))));
    let mut value = serde_json::to_value(bank).unwrap_or_default();
    value["says"] = lines.into();
    value
}

/// Every effect tried alone, likeliest first.
pub(crate) fn candidates(found: &Found<'_>) -> Vec<Candidate> {
    let base = &found.selection.base().fit;
    let single = |effect: usize| {
        found.selection.with(&[effect]).map(|t| Candidate {
            effect: found.id(effect),
            probability: found.selection.effect_probability[effect],
            score: t.fit.log_evidence - base.log_evidence,
            chi2_drop: base.chi2 - t.fit.chi2,
            freedom: t.fit.z.len() - base.z.len(),
        })
    };
    let mut list: Vec<Candidate> = found.weighed().filter_map(single).collect();
    list.sort_by(|a, b| b.probability.total_cmp(&a.probability).then(b.score.total_cmp(&a.score)));
    list
}

/// Sets whose members this recording cannot tell apart, in the `order` of the findings.
pub(crate) fn ambiguity(found: &Found<'_>, order: &[usize]) -> Vec<Vec<String>> {
    if found.decision.verdict != Verdict::Ambiguous {
        return Vec::new();
    }
    named_sets(found, order).into_iter().filter(|names| names.len() > 1).collect()
}

/// What stands in the place of each finding, itself first, in the `order` of the findings.
pub(crate) fn named_sets(found: &Found<'_>, order: &[usize]) -> Vec<Vec<String>> {
    let names = |set: &Vec<usize>| {
        let unmodelled = found.decision.unmodelled_rivals.then(|| UNEXPLAINED.to_owned());
        set.iter().map(|e| found.id(*e)).chain(unmodelled).collect()
    };
    order.iter().filter_map(|place| found.decision.sets.get(*place)).map(names).collect()
}

/// What the reading does, and where, where it does so at one place.
pub(crate) fn says_of(found: &Found<'_>, unmodelled: &Unmodelled) -> String {
    let says = unmodelled.cause.says();
    let inputs = found.search.problem.inputs;
    unmodelled.row.map_or_else(
        || says.to_owned(),
        |row| format!("{says} (clearest in run {}, near {:.0} s)", inputs.run[row], elapsed_s(inputs, row)),
    )
}

/// Unmodelled causes that are not negligible.
pub(crate) fn unmodelled(found: &Found<'_>) -> Vec<UnmodelledCause> {
    let cause = |(u, probability): (&Unmodelled, f64)| UnmodelledCause {
        says: says_of(found, u),
        beside: u.effects.iter().map(|e| found.id(*e)).collect(),
        probability,
    };
    found.selection.unmodelled_probabilities().map(cause).filter(|u| u.probability > NOT_NEGLIGIBLE).collect()
}

/// The smallest size of each effect that is not named at which it would have been seen.
pub(crate) fn smallest_visible(found: &Found<'_>) -> Vec<SmallestVisible> {
    let named = &found.chosen().effects;
    let base = found.selection.base();
    let visible = |effect: usize| {
        let tried = found.selection.with(&[effect])?;
        let parameter = found.search.model(&tried.effects).parameters[base.fit.z.len()].clone();
        let size = visible_size(found.search, base, tried, SEEN)?;
        Some(SmallestVisible { effect: found.id(effect), parameter: parameter.name, unit: parameter.unit, size })
    };
    found.weighed().filter(|e| !named.contains(e)).filter_map(visible).collect()
}
