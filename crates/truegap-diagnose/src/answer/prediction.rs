//! What may be predicted where nothing may be named: the likeliest model of the library as a flexible term, with no claim about the cause.
//!
//! Limits: its freedom is that of the library's effects, at most three at once; what they leave is located, not modelled.

use crate::{
    answer::{
        errors::{in_sample, permutation_control, respond, unseen},
        fit_facts::{BeforeAfter, FlexibleTerm, PredictionOnly},
        found::Found,
        numbers::{fitted, parameters},
    },
    effects::sentence::sentence,
    explain::locate::{Mismatch, locate},
    selection::{
        candidates::Tried,
        verdict::{Verdict, stated},
    },
    text::two,
    validation::cross_validation::{HeldOutFit, compared, misfit_removed},
};

/// The term, and its predictions row by row.
pub(crate) struct Flexible {
    /// what is said of it
    pub facts: PredictionOnly,
    /// fitted to all rows
    pub prediction: Vec<f64>,
    /// of rows left out
    pub held_out: Vec<f64>,
}

/// The likeliest model as a flexible term, where something is missing that the library does not explain; `base` and `before` are the base model on every row and on
/// rows left out.
///
/// `None` where something is named, nothing of the library helps, or the term predicts rows that it did not see no better than the base model.
pub(crate) fn flexible(found: &Found<'_>, base: &[f64], before: &HeldOutFit) -> Option<Flexible> {
    if found.decision.verdict != Verdict::Unexplained || found.decision.removed <= 0.0 {
        return None;
    }
    let tried = &found.selection.models[stated(found.selection)?];
    let after = unseen(found, tried);
    let [rmse_before, rmse_after] = smaller(before, &after)?;
    let prediction = respond(found, tried).ok()?;
    let in_sample = in_sample(found, base, &prediction)?;
    let unit = found.search.problem.simulator.unit();
    let pair = |before: f64, after: f64| {
        let (before, after) = two(before, after, unit);
        format!("{before} to {after}")
    };
    let facts = PredictionOnly {
        says: format!(
            "for prediction only, without a claim about the cause: a flexible term brings the error from {}, on rows left out from {}",
            pair(in_sample.rmse_before, in_sample.rmse_after),
            pair(rmse_before, rmse_after)
        ),
        terms: terms(found, tried),
        in_sample,
        held_out: BeforeAfter { rmse_before, rmse_after },
        misfit_removed: misfit_removed(rmse_before, rmse_after, found.noise.floor(), found.noise.rows),
        permutation_control: permutation_control(found, tried),
        remains: remains(found, tried),
    };
    Some(Flexible { facts, prediction, held_out: after.prediction })
}

/// Errors of base model and term on rows left out, where that of the term is the smaller one: what predicts worse serves no prediction.
fn smaller(before: &HeldOutFit, after: &HeldOutFit) -> Option<[f64; 2]> {
    let [rmse_before, rmse_after] = compared(before, after)?.rmse;
    (rmse_after < rmse_before).then_some([rmse_before, rmse_after])
}

/// Where recording and `tried` differ.
pub(crate) fn located(found: &Found<'_>, tried: &Tried) -> Vec<Mismatch> {
    locate(found.search.problem, &tried.fit, found.lack_of_fit, found.directions)
}

/// The same of a model that holds more than the calibrated one.
pub(crate) fn remains(found: &Found<'_>, tried: &Tried) -> Vec<Mismatch> {
    let mut list = located(found, tried);
    list.iter_mut().for_each(|m| m.says = m.says.replacen("calibrated model differ", "fuller model still differ", 1));
    list
}

/// The parts of the term, in the library's words for what they are shaped like.
fn terms(found: &Found<'_>, tried: &Tried) -> Vec<FlexibleTerm> {
    let model = found.search.model(&tried.effects);
    let term = |(index, effect): (usize, &usize)| FlexibleTerm {
        shaped_like: found.id(*effect),
        says: sentence(found.search.library[*effect], &fitted(found, tried, model.range_of(index)), found.search.context, &[]),
        parameters: parameters(found, tried, model.range_of(index)),
    };
    tried.effects.iter().enumerate().map(term).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::validation::cross_validation::PartError;

    /// Four rows left out with this error.
    fn predicted(error: f64) -> HeldOutFit {
        let part = PartError { name: "run 1".into(), squares: Some(4.0 * error * error), rows: 4, score: None, warned: None };
        HeldOutFit { parts: vec![part], ..HeldOutFit::default() }
    }

    /// "On rows left out from 2370 to 4470" was offered for prediction.
    #[test]
    fn a_term_that_predicts_rows_left_out_no_better_is_not_offered() {
        let offered = |before: f64, after: f64| smaller(&predicted(before), &predicted(after));
        assert_eq!(offered(4470.0, 2370.0), Some([4470.0, 2370.0]));
        for after in [4470.0, 2370.0, f64::NAN] {
            assert_eq!(offered(2370.0, after), None, "{after}");
        }
    }
}
