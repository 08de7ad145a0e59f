//! What the tool stands behind, effect by effect.
//!
//! Limits: decides nothing; what is named here was decided in [`crate::selection::verdict`].

use crate::{
    answer::tuning::{NOTHING, PLAINLY_SEEN, SURE},
    answer::{
        diagnosis::Finding,
        errors::unseen,
        fit_facts::BeforeAfterUnit,
        found::Found,
        numbers::{fitted, parameters},
        stated::{Place, stated},
    },
    discovery::marginals::WordProbabilities,
    effects::sentence::{nothing_stands_out, sentence, sentence_of_seen},
    selection::detectability::detectability,
    text::significant,
    validation::cross_validation::{HeldOutFit, compared},
};

/// Effects of the model stood behind.
pub(crate) struct Named {
    /// those that are claimed
    pub findings: Vec<Finding>,
    /// place of each in that model
    pub order: Vec<usize>,
    /// those that it only carries
    pub carried: Vec<Finding>,
}

/// The effects of the model stood behind, what matters most on rows left out first; `before` and `after` are the predictions of rows left out by the base model and by that model.
pub(crate) fn findings(found: &Found<'_>, before: &HeldOutFit, after: &HeldOutFit) -> Named {
    let effects = &found.chosen().effects;
    let mut all: Vec<(usize, Finding)> = (0..effects.len()).map(|index| (index, finding(found, index, before, after))).collect();
    all.sort_by(|a, b| lost_without(&b.1.held_out).total_cmp(&lost_without(&a.1.held_out)));
    let (claimed, carried): (Vec<_>, Vec<_>) = all.into_iter().partition(|(index, _)| !found.carries(effects[*index]));
    let (order, findings): (_, Vec<Finding>) = claimed.into_iter().unzip();
    let carried = carried.into_iter().map(|(_, finding)| finding).collect::<Vec<_>>();
    let (plates, count) = (found.search.context.has_plates(), findings.len());
    let state = |finding: Finding, place: Place| {
        let probability = stated(&finding.effect, finding.probability_among_models, place, plates);
        Finding { probability, ..finding }
    };
    let findings = findings.into_iter().enumerate().map(|(index, one)| state(one, Place::of(index, count))).collect();
    let carried = carried.into_iter().map(|one| state(one, Place::Carried)).collect();
    Named { findings, order, carried }
}

/// How many times larger the error on rows left out is without a finding; 0 where it was not asked.
fn lost_without(held_out: &BeforeAfterUnit) -> f64 {
    match (held_out.rmse_before, held_out.rmse_after) {
        (Some(without), Some(with)) if with > 0.0 => without / with,
        _ => 0.0,
    }
}

fn finding(found: &Found<'_>, index: usize, before: &HeldOutFit, after: &HeldOutFit) -> Finding {
    let (chosen, told) = (found.chosen(), found.told(found.chosen()));
    let effect = chosen.effects[index];
    let own = found.search.model(&chosen.effects).range_of(index);
    let detectability = detectability(found.search, chosen, index);
    let model = found.search.model(&chosen.effects);
    let of = |(place, effect): (usize, &usize)| (found.search.library[*effect].id(), fitted(found, told, model.range_of(place)));
    let beside: Vec<_> = chosen.effects.iter().enumerate().map(of).collect();
    let is_seen = detectability.is_some_and(|d| d >= PLAINLY_SEEN);
    let tell = if is_seen { sentence_of_seen } else { sentence };
    let sentence = tell(found.search.library[effect], &fitted(found, told, own.clone()), found.search.context, &beside);
    let without = without(found, index);
    let both = compared(without.as_ref().unwrap_or(before), after);
    let rivals = found.decision.sets.get(index).map(|set| set.iter().filter(|e| **e != effect).map(|e| found.id(*e)).collect());
    let among_models = found.selection.effect_probability[effect];
    Finding {
        effect: found.id(effect),
        probability: among_models,
        probability_among_models: among_models,
        says: match detectability {
            Some(d) if d < NOTHING && among_models > SURE => nothing_stands_out(&found.id(effect)),
            Some(d) if d < PLAINLY_SEEN => {
                format!("most consistent with: {sentence} (detectability {})", significant(d, 2))
            }
            _ => sentence,
        },
        detectability,
        parameters: parameters(found, told, own),
        held_out: BeforeAfterUnit {
            rmse_before: both.as_ref().map(|c| c.rmse[0]),
            rmse_after: both.as_ref().map(|c| c.rmse[1]),
            unit: found.search.problem.simulator.unit().into(),
        },
        rivals: rivals.unwrap_or_default(),
        words: in_words(found, index),
    }
}

/// What a finding is in words, its name open among those that may stand in its place.
fn in_words(found: &Found<'_>, index: usize) -> WordProbabilities {
    let own = found.chosen().effects[index];
    let set = found.decision.sets.get(index).filter(|set| set.contains(&own)).cloned().unwrap_or_else(|| vec![own]);
    let said = |e: &usize| found.search.library[*e].in_words(found.search.context);
    let each: Vec<_> = set.iter().map(|e| (said(e), found.selection.effect_probability[*e])).collect();
    if each.iter().any(|(_, weight)| *weight > 0.0) {
        WordProbabilities::of_effects(&each)
    } else {
        WordProbabilities::of_effects(&[(said(&own), 1.0)])
    }
}

/// Rows left out as all findings but one predict them; `None` where it was the only one.
fn without(found: &Found<'_>, index: usize) -> Option<HeldOutFit> {
    let chosen = found.chosen();
    let others: Vec<usize> = chosen.effects.iter().enumerate().filter(|(i, _)| *i != index).map(|(_, e)| *e).collect();
    let tried = found.selection.with(&others).filter(|t| !t.effects.is_empty())?;
    Some(unseen(found, tried))
}
