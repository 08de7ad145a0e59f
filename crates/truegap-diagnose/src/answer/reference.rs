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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::answer::fit_facts::{BeforeAfter, HeldOut};

    fn fit(in_sample: [f64; 2], held_out: [f64; 2]) -> FitFacts {
        FitFacts {
            in_sample: BeforeAfter { rmse_before: in_sample[0], rmse_after: in_sample[1] },
            held_out: HeldOut {
                how: String::new(),
                rmse_before: Some(held_out[0]),
                rmse_after: Some(held_out[1]),
                misfit_removed: None,
                permutation_control: None,
                parts: Vec::new(),
                recordings: Vec::new(),
                selected_again: None,
            },
            noise_floor: 0.1,
            unit: "pF".into(),
        }
    }

    fn line(rmse: f64, held_out: f64) -> Vec<Reference> {
        vec![Reference { name: "straight_line", inputs: vec!["force".into()], rmse, held_out: Some(held_out) }]
    }

    /// 0.887 against 0.195, of which "96 % removed" was told.
    #[test]
    fn a_base_that_a_line_beats_is_told_and_one_that_it_does_not_beat_is_not() {
        let says = against(&line(0.195, 0.21), &fit([0.887, 0.15], [0.9, 0.16]), true).unwrap_or_default();
        assert!(
            says.contains("a straight line in force is nearer") && says.contains("195 fF against 887 fF in sample"),
            "{says}"
        );
        assert!(says.contains("210 fF against 900 fF on rows left out") && !says.contains("too"), "{says}");
        let says = against(&line(0.195, 0.21), &fit([0.887, 0.15], [0.9, 0.4]), true).unwrap_or_default();
        assert!(says.ends_with("it predicts rows left out better than the fuller model, too (210 fF against 400 fF)"), "{says}");
        // nearer in sample alone is what more freedom does, and a twentieth is no difference
        assert_eq!(against(&line(0.195, 0.95), &fit([0.887, 0.15], [0.9, 0.16]), true), None);
        assert_eq!(against(&line(0.86, 0.88), &fit([0.887, 0.15], [0.9, 0.16]), true), None);
        assert_eq!(against(&[], &fit([0.887, 0.15], [0.9, 0.16]), true), None);
    }
}
