//! A straight line and a smooth curve beside the models, and what is said where the line is the better one.
//!
//! Limits: says nothing of causes.

use crate::{
    answer::{fit_facts::FitFacts, found::Found},
    text::{listed, two},
    validation::{
        cross_validation::parts_of,
        reference::{Reference, references},
    },
};

/// Factor on the line's error from which a model counts as worse.
const WORSE: f64 = 1.05;

/// The reference rows, on the parts left out that base model and model stood behind predict.
pub(crate) fn reference(found: &Found<'_>) -> Vec<Reference> {
    let (_, parts) = parts_of(found.all.problem);
    references(found.all.problem, &parts, [&found.unseen.base, found.unseen.stood_behind()])
}

/// What is said where the straight line is better than the calibrated base model, in sample and on rows left out; and where it predicts rows left out better than
/// the fuller model, too.
pub(crate) fn against(reference: &[Reference], fit: &FitFacts, names: bool) -> Option<String> {
    let line = reference.iter().find(|r| r.name == "straight_line")?;
    let worse = |model: f64, line: f64| model > WORSE * line;
    let unseen = fit.held_out.rmse_before.zip(line.held_out);
    if !worse(fit.in_sample.rmse_before, line.rmse) || !unseen.is_none_or(|(base, line)| worse(base, line)) {
        return None;
    }
    let pair = |line: f64, model: f64| {
        let (line, model) = two(line, model, &fit.unit);
        format!("{line} against {model}")
    };
    let held = unseen.map_or_else(String::new, |(base, line)| format!(", {} on rows left out", pair(line, base)));
    let after = fit.held_out.rmse_after.zip(line.held_out).filter(|(after, line)| names && worse(*after, *line));
    let too = after.map_or_else(String::new, |(after, line)| {
        format!("; it predicts rows left out better than the fuller model, too ({})", pair(line, after))
    });
    Some(format!(
        "a straight line in {} is nearer than the calibrated base model: {} in sample{held}; what is removed of the misfit is to be read against that{too}",
        listed(&line.inputs, "and"),
        pair(line.rmse, fit.in_sample.rmse_before),
    ))
}
