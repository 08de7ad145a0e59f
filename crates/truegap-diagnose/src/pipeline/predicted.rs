//! Rows left out are predicted, and what they say of the decision.
//!
//! Limits: models that the search has fitted; a number for whatever happens is not judged.

use crate::{
    adequacy::lack_of_fit::Adequacy,
    answer::Reserved,
    fit::model::Model,
    pipeline::{
        alone::{Alone, alone, left_over, white},
        prepare::Prepared,
    },
    selection::{
        candidates::{Search, Tried},
        posterior::Selection,
        tuning::RIGHT_FAMILY,
        verdict::{Decision, Verdict, foretold, stated, stepped_back},
    },
    text::{significant, spoken},
    validation::{
        among_rivals::{Named, best_foreteller},
        cross_validation::{AllRows, HeldOutFit, compared, held_out},
        step_back::{LeftOut, step_back},
        veto::{Against, Unseen},
    },
    whitening::noise_model::NoiseModel,
};

/// The decision with predictions of rows left out counted.
pub(crate) struct Predicted {
    /// errors on rows left out
    pub unseen: Unseen,
    pub decision: Decision,
    /// adequacy of the model stood behind, where it is another one now
    pub after: Option<Adequacy>,
    /// why nothing is named, where that is so
    pub vetoed: Option<Reserved>,
    /// what is not claimed beside the rest, for a reader
    pub left_out: Vec<String>,
}

/// The base model by itself: how it is told, and what it foretells of rows left out.
#[derive(Clone)]
pub(crate) struct ByBase {
    /// calibrated by least squares, where that is another one
    pub alone: Option<Alone>,
    /// predictions of rows left out
    pub unseen: HeldOutFit,
}

/// Predicts rows left out by the base model, which is calibrated by least squares as well where something is `missing`.
pub(crate) fn by_base(prepared: &Prepared<'_>, search: &Search<'_>, base: &Tried, missing: bool) -> ByBase {
    let all = prepared.all_rows();
    let alone = missing.then(|| alone(prepared, search, all, base)).flatten();
    let under_noise = held_out(search, &prepared.searched_noise, base, all);
    let unseen = match &alone {
        Some(alone) => held_out(search, &alone.noise, &alone.tried, all).scored_as(&under_noise),
        None => under_noise,
    };
    ByBase { alone, unseen }
}

/// Predicts rows left out: what predicts them much worse than the base model is not claimed, nor an effect without which the others predict them better. What predicts them well is
/// stood behind even where its rest stands far out of the noise, unless nothing may be named (`may_name`).
pub(crate) fn predicted(
    prepared: &Prepared<'_>,
    search: &Search<'_>,
    selection: &Selection,
    decision: Decision,
    by_base: &ByBase,
    may_name: bool,
) -> Predicted {
    let noise = &prepared.searched_noise;
    let all = prepared.all_rows();
    let ByBase { alone, unseen: base } = by_base;
    let of = |tried: &Tried| {
        let squares = alone.as_ref().and_then(|_| by_least_squares(search, noise, tried, all));
        nearer(held_out(search, noise, tried, all), squares)
    };
    let nothing = |decision| (Unseen::nothing(base.clone()), decision);
    let free_form = |e: usize| search.library[e].free_form();
    // what stands out of the noise in what a model leaves may be small beside what it foretells
    let asked = if selection.models[decision.model].effects.is_empty() {
        let unsettled = may_name && decision.verdict == Verdict::Unexplained && decision.unmodelled.is_none();
        stated(selection).filter(|model| unsettled && selection.models[*model].effects.iter().all(|e| !free_form(*e)))
    } else {
        Some(decision.model)
    };
    let Some(asked) = asked else {
        let (unseen, decision) = nothing(decision);
        return Predicted { unseen, decision, after: None, vetoed: None, left_out: Vec::new() };
    };
    let first = Named { model: asked, unseen: of(&selection.models[asked]) };
    let (asked, start, decision) = match best_foreteller(selection, (&first, &decision.sets), of) {
        Some((better, sets)) if decision.model == asked => {
            (better.model, better.unseen, Decision { model: better.model, sets, ..decision })
        }
        _ => (asked, first.unseen, decision),
    };
    let start = (asked, start);
    let (model, named, left_out) = step_back(selection, start, base, of, free_form);
    let unit = search.problem.simulator.unit();
    let id = |e: usize| search.library[e].id().to_string();
    let told = |left: &LeftOut| {
        format!(
            "{} would fit as well, but without it rows left out are predicted {} ({}), so it is not claimed",
            spoken(&id(left.effect)),
            left.against.others_predict(),
            measured(left.against, unit)
        )
    };
    let told: Vec<String> = left_out.iter().map(told).collect();
    let named_before = decision.model == asked;
    let (decision, after) = if left_out.is_empty() {
        (decision, None)
    } else {
        let after = prepared.lack_of_fit.adequacy(&selection.models[model].fit);
        let decision = if named_before { stepped_back(selection, &decision, model, &after) } else { decision };
        (decision, Some(after))
    };
    let chosen = &selection.models[model];
    let unseen = Unseen::of((base.clone(), &selection.base().fit), (named, &chosen.fit));
    let foretells = chosen.effects.iter().all(|e| !free_form(*e));
    let (decision, after) = match decision.verdict {
        Verdict::Unexplained if foretells && may_name => {
            match unseen.foretold(prepared.noise.floor(), prepared.noise.rows).filter(|r| *r >= RIGHT_FAMILY) {
                Some(removed) => {
                    (foretold(selection, model, removed), Some(prepared.lack_of_fit.adequacy(&selection.models[model].fit)))
                }
                None => (decision, after),
            }
        }
        _ => (decision, after),
    };
    if let Some(against) = unseen.worse().filter(|_| foretells && (named_before || decision.model == model)) {
        let ids = chosen.effects.iter().map(|e| id(*e)).collect::<Vec<_>>().join(" and ");
        let says = format!(
            "there is a mismatch, but its cause is not decided: {ids} would fit it, and rows left out are predicted {} by the calibrated model alone ({})",
            against.others_predict(),
            measured(against, unit)
        );
        let (unseen, decision) = nothing(Decision::nothing(Verdict::Undecided, selection.base));
        let vetoed = Some(Reserved { says, withheld: false, input_missing: false });
        return Predicted { unseen, decision, after: None, vetoed, left_out: told };
    }
    // a verdict that names nothing has no model whose predictions could be told, nor effects that are told beside it
    if decision.model != model {
        let told = if named_before { told } else { Vec::new() };
        return Predicted {
            unseen: Unseen::nothing(base.clone()),
            decision,
            after: after.filter(|_| named_before),
            vetoed: None,
            left_out: told,
        };
    }
    Predicted { unseen, decision, after, vetoed: None, left_out: told }
}

/// What speaks against a model, for a reader.
fn measured(against: Against, unit: &str) -> String {
    match against {
        Against::Errors([without, with]) => format!("{} against {} {unit}", significant(without, 3), significant(with, 3)),
        Against::Score(lost) if lost <= 0.0 => "measured in the noise, it gains no more than trying many effects does".into(),
        Against::Score(lost) => {
            format!("measured in the noise, by {} squares of its standard deviation over all rows", significant(lost, 2))
        }
    }
}

/// Predictions of rows left out by a model that is calibrated by least squares: under white noise as large as what it leaves over.
fn by_least_squares(search: &Search<'_>, noise: &NoiseModel, tried: &Tried, all: AllRows<'_>) -> Option<HeldOutFit> {
    let effects = tried.effects.iter().map(|e| search.library[*e]).collect();
    let size = left_over(&Model::new(all.problem, search.context, effects), &tried.fit.z)?;
    let predicted = held_out(search, &white(noise, size), tried, all);
    Some(HeldOutFit { how: format!("{}; calibrated by least squares", predicted.how), ..predicted })
}

/// What a model foretells, calibrated under the noise or, as the base model is where that is told alone, by least squares: else the two ways to calibrate would be compared, and not the
/// two models.
fn nearer(under_noise: HeldOutFit, squares: Option<HeldOutFit>) -> HeldOutFit {
    let better = |squares: &HeldOutFit| compared(&under_noise, squares).is_some_and(|both| both.rmse[1] < both.rmse[0]);
    match squares.filter(better) {
        Some(squares) => squares.scored_as(&under_noise),
        None => under_noise,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::validation::cross_validation::PartError;

    fn predicted(squares: f64) -> HeldOutFit {
        let part = PartError { name: "run 1".into(), squares: Some(squares), rows: 4, score: None };
        HeldOutFit { how: String::new(), prediction: Vec::new(), parts: vec![part] }
    }

    /// Calibrated by least squares, the base model leaves 4. A model that leaves 9 under the noise and 2 by least squares is no worse.
    #[test]
    fn where_least_squares_predict_better_they_are_told() {
        let told = |under_noise, squares: Option<f64>| nearer(predicted(under_noise), squares.map(predicted)).parts[0].squares;
        assert_eq!(told(9.0, Some(2.0)), Some(2.0));
        assert_eq!(told(3.0, Some(4.0)), Some(3.0));
        assert_eq!(told(9.0, None), Some(9.0));
    }
}
