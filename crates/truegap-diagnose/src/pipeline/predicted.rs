//! Rows left out are predicted, and what they say of the decision.
//!
//! Limits: models that the search has fitted; a number for whatever happens is not judged.

use crate::{
    adequacy::lack_of_fit::Adequacy,
    answer::Reserved,
    pipeline::{
        calibrated::{ByBase, predictions},
        prepare::Prepared,
    },
    selection::{
        candidates::{Search, Tried},
        posterior::Selection,
        tuning::{RIGHT_FAMILY, SURE},
        verdict::{Decision, Verdict, foretold, removed_by, stated, stepped_back},
    },
    stats::rmse_of_both,
    text::{percent_of, significant},
    validation::{
        among_rivals::{Named, best_foreteller, exchanged},
        cross_validation::{HeldOutFit, compared},
        step_back::{Known, LeftOut, step_back},
        tuning::{CLEARLY_WORSE, MOST_RIVALS, NEXT_TO_NOTHING},
        veto::{Against, Unseen},
    },
};
use std::cell::LazyCell;

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
    /// effects of the model that was asked last and is not stood behind
    pub refuted: Vec<usize>,
}

impl Predicted {
    /// The same with another model stood behind: whatever took the one before back says nothing of it.
    #[must_use]
    pub(crate) fn with(self, unseen: Unseen, decision: Decision, after: Adequacy) -> Self {
        Self { unseen, decision, after: Some(after), vetoed: None, ..self }
    }

    /// The same with the base model stood behind by this decision.
    #[must_use]
    pub(crate) fn with_nothing(self, decision: Decision, by_base: &ByBase) -> Self {
        let unseen = Unseen::nothing(by_base.unseen.clone());
        Self { unseen, decision, after: None, vetoed: None, refuted: Vec::new(), ..self }
    }
}

/// Predicts rows left out: what predicts them much worse than the base model is not claimed, nor an effect without which the others predict them better. What predicts them well is
/// stood behind even where its rest stands far out of the noise, unless nothing may be named (`may_name`); what changes next to nothing there is not, where tests still see a difference, nor
/// what leaves larger errors even on the rows that it was fitted to.
pub(crate) fn predicted(
    prepared: &Prepared<'_>,
    search: &Search<'_>,
    selection: &Selection,
    decision: Decision,
    by_base: &ByBase,
    may_name: bool,
) -> Predicted {
    let rows = RowsLeftOut { prepared, search, selection, by_base, may_name };
    match rows.asked(&decision) {
        Some(model) => rows.judged(model, decision),
        None => rows.nothing(decision, None, Vec::new()),
    }
}

/// What rows left out are asked with.
struct RowsLeftOut<'s, 'a> {
    prepared: &'s Prepared<'a>,
    search: &'s Search<'s>,
    selection: &'s Selection,
    by_base: &'s ByBase,
    may_name: bool,
}

impl RowsLeftOut<'_, '_> {
    /// The model whose predictions are asked for: that of the decision, or the likeliest one where what stands out of the noise in its rest may be small beside what it foretells.
    fn asked(&self, decision: &Decision) -> Option<usize> {
        if !self.effects(decision.model).is_empty() {
            return Some(decision.model);
        }
        let open = self.may_name && decision.verdict == Verdict::Unexplained && decision.unmodelled.is_none();
        stated(self.selection).filter(|model| open && self.foretells(*model))
    }

    fn judged(&self, asked: usize, decision: Decision) -> Predicted {
        let of = |tried: &Tried| self.predictions(tried);
        let first = Named { model: asked, unseen: of(&self.selection.models[asked]) };
        let named_before = decision.model == asked;
        let (start, decision) = match best_foreteller(self.selection, (&first, &decision.sets), of) {
            Some((better, sets)) if named_before => {
                let decision = Decision { model: better.model, sets, ..decision };
                ((better.model, better.unseen), decision)
            }
            _ => ((asked, first.unseen), decision),
        };
        let library = (self.prepared.testable.len(), |e: usize| self.search.library[e].free_form());
        let stands_out = |model: usize, beside: &Unseen| self.stands_out(model, beside);
        let (enough, holds) = (|smaller: usize| self.could_be_named(smaller), |model: usize| self.holds(model));
        let measured = self.prepared.noise_is_known();
        let known = Known { measured, enough: &enough, holds: &holds, stands_out: &stands_out };
        let fuller = start.0;
        let (model, named, left_out) = step_back(self.selection, start, &self.by_base.unseen, of, library, known);
        let unseen =
            Unseen::of((self.by_base.unseen.clone(), &self.selection.base().fit), (named, &self.selection.models[model].fit))
                .where_it_holds(self.holds(model));
        let stepped = !left_out.is_empty() && named_before;
        let decision = if stepped { stepped_back(self.selection, &decision, model, &self.left_by(model)) } else { decision };
        let rivals = if stepped && decision.model == model { self.as_near(model, unseen.stood_behind()) } else { Vec::new() };
        let decision = rivals.into_iter().fold(decision, Decision::with_rival);
        let told = if named_before { left_out.iter().map(|left| self.told(left)).collect() } else { Vec::new() };
        let concluded = self.concluded((fuller, model), unseen, (decision, stepped), told);
        let refuted = if concluded.decision.model == model { Vec::new() } else { self.effects(model).to_vec() };
        Predicted { refuted, ..concluded }
    }

    /// What may stand in the place of an effect of a smaller model where the noise was not measured: the effect and its rivals, which were weighed beside effects that are not claimed. Rows
    /// left out tell those apart that predict them clearly better.
    fn as_near(&self, model: usize, named: &HeldOutFit) -> Vec<(usize, usize)> {
        if self.prepared.noise_is_known() {
            return Vec::new();
        }
        let near = |tried: &Tried| {
            let both = compared(named, &self.predictions(tried));
            both.is_some_and(|both| both.rmse[1] < CLEARLY_WORSE * both.rmse[0])
        };
        let library = self.prepared.testable.len();
        let of_library = exchanged(self.selection, model).into_iter().filter(|((_, new), _)| *new < library);
        let rivals = of_library.take(MOST_RIVALS);
        rivals.filter(|(_, place)| near(&self.selection.models[*place])).map(|(pair, _)| pair).collect()
    }

    /// The decision once a model and what it foretells are known; the `fuller` model from which it was `stepped` back to, and what was left out on the way.
    fn concluded(
        &self,
        (fuller, model): (usize, usize),
        unseen: Unseen,
        (decision, stepped): (Decision, bool),
        told: Vec<String>,
    ) -> Predicted {
        let foretells = self.foretells(model) && self.may_name;
        let removed = unseen.removed(self.prepared.noise.floor(), self.prepared.noise.rows).filter(|_| foretells);
        let enough = |share: f64| share >= RIGHT_FAMILY || self.is_a_sure_part(model, &unseen);
        let most = removed.filter(|share| enough(*share) && unseen.in_most_parts());
        let rescued = decision.verdict == Verdict::Unexplained && most.is_some();
        let decision = match most.filter(|_| rescued) {
            Some(share) => foretold(self.selection, model, share),
            None => decision,
        };
        if decision.model != model {
            let after = stepped.then(|| self.left_by(model));
            return self.nothing(decision, after, told);
        }
        let stands_out = || self.stands_out(model, &unseen);
        let against = unseen.against(self.tells_small_from_chance(model), stands_out).filter(|_| self.foretells(model));
        let (rows, floor) = (self.prepared.problem.response.len(), self.prepared.noise.floor());
        let farther = LazyCell::new(|| self.errors(model).filter(|errors| unseen.farther(*errors, rows, floor)));
        match against {
            // what is farther even from the rows that it was fitted to is no mismatch of which the cause is open
            Some(Against::Score(_)) if farther.is_some() => {}
            Some(little @ Against::Little(_)) => {
                let says = self.says_too_little(model, little);
                return self.nothing(self.too_little(fuller, model), None, [told, vec![says]].concat());
            }
            Some(against) => {
                let undecided = Decision::nothing(Verdict::Undecided, self.selection.base);
                return Predicted { vetoed: Some(self.refused(model, against)), ..self.nothing(undecided, None, told) };
            }
            None => {}
        }
        if let Some([without, with]) = *farther {
            let verdict = if self.left_by(self.selection.base).fires() { Verdict::Unexplained } else { Verdict::Agrees };
            let says = self.says_farther(model, [without, with]);
            return self.nothing(Decision::nothing(verdict, self.selection.base), None, [told, vec![says]].concat());
        }
        if let Some(share) = removed.filter(|share| *share < NEXT_TO_NOTHING && self.left_by(model).fires()) {
            let decision = Decision { removed: share.max(0.0), ..Decision::nothing(Verdict::Unexplained, self.selection.base) };
            return self.nothing(decision, None, [told, vec![self.says_next_to_nothing(model, share)]].concat());
        }
        let after = (stepped || rescued).then(|| self.left_by(model));
        Predicted { unseen, decision, after, vetoed: None, left_out: told, refuted: Vec::new() }
    }

    /// The answer of a decision that names nothing.
    fn nothing(&self, decision: Decision, after: Option<Adequacy>, left_out: Vec<String>) -> Predicted {
        Predicted {
            unseen: Unseen::nothing(self.by_base.unseen.clone()),
            decision,
            after,
            vetoed: None,
            left_out,
            refuted: Vec::new(),
        }
    }

    /// Nothing is named since it would change next to nothing: the base model agrees where that is all that tests see, what was left out before as well.
    fn too_little(&self, fuller: usize, model: usize) -> Decision {
        let all_that_is_seen = |model: usize| !self.left_by(model).fires();
        let verdict = if all_that_is_seen(model) || all_that_is_seen(fuller) { Verdict::Agrees } else { Verdict::Unexplained };
        Decision::nothing(verdict, self.selection.base)
    }

    /// Whether effects are sure, and felt on rows left out, beside a base model without plates: such a model describes, what is left of an instrument is always more than its noise, and a
    /// cause that makes half of it is one. Beside plates what an effect leaves is another physics, which it may stand for.
    fn is_a_sure_part(&self, model: usize, unseen: &Unseen) -> bool {
        let sure = self.effects(model).iter().all(|e| self.selection.effect_probability[*e] >= SURE);
        !self.search.context.has_plates() && self.is_of_the_library(model) && sure && unseen.is_felt()
    }

    /// Whether what effects of the library foretell stands far out of what they leave where that is slow: a noise that lasts, which nobody measured, would be there as well. A base model
    /// without plates describes, so that something small is always beside it; and mechanisms are composed to follow whatever there is.
    fn stands_out(&self, model: usize, unseen: &Unseen) -> bool {
        if !self.search.context.has_plates() || !self.is_of_the_library(model) {
            return false;
        }
        let left = self.left_by(model);
        !left.fires() && unseen.stands_out_of(left.slow_level() * self.prepared.lack_of_fit.slack())
    }

    /// Whether the noise is known so well that a model is weighed by it, where it makes next to no error smaller. Steps of a coarse reading err by rule and not by chance: a mechanism that
    /// is composed to follow whatever there is follows them.
    fn tells_small_from_chance(&self, model: usize) -> bool {
        self.prepared.noise_is_known() && (self.prepared.noise.step <= 0.0 || self.is_of_the_library(model))
    }

    /// Whether none of its effects was composed of words.
    fn is_of_the_library(&self, model: usize) -> bool {
        self.effects(model).iter().all(|e| *e < self.prepared.testable.len())
    }

    /// Whether tests see nothing in what a model leaves.
    fn holds(&self, model: usize) -> bool {
        !self.left_by(model).fires()
    }

    /// Whether a model leaves little enough to be named by itself.
    fn could_be_named(&self, model: usize) -> bool {
        let (base, tried) = (self.selection.base(), &self.selection.models[model]);
        let after = self.left_by(model);
        !after.fires() || removed_by(tried.fit.explains_beyond(&base.fit), &after) >= RIGHT_FAMILY
    }

    fn effects(&self, model: usize) -> &[usize] {
        &self.selection.models[model].effects
    }

    /// Whether a model foretells rows left out at all: a number for each run foretells nothing of another run.
    fn foretells(&self, model: usize) -> bool {
        self.effects(model).iter().all(|e| !self.search.library[*e].free_form())
    }

    /// What lack-of-fit tests say of a model.
    fn left_by(&self, model: usize) -> Adequacy {
        self.prepared.lack_of_fit.adequacy(&self.selection.models[model].fit)
    }

    fn predictions(&self, tried: &Tried) -> HeldOutFit {
        predictions(self.prepared, self.search, self.by_base, tried)
    }

    fn id(&self, effect: usize) -> String {
        self.search.library[effect].id().to_string()
    }

    /// Effects for a reader.
    fn names(&self, effects: &[usize]) -> String {
        self.prepared.names(effects)
    }

    fn told(&self, left: &LeftOut) -> String {
        format!(
            "{} would fit as well, but without it rows left out are predicted {} ({}), so it is not claimed",
            self.names(&left.effects),
            left.against.others_predict(),
            self.measured(left.against)
        )
    }

    /// Errors of the base model and of another on every row, which both were fitted to, in the unit of the reading; `None` where one of them has no answer.
    fn errors(&self, model: usize) -> Option<[f64; 2]> {
        let problem = self.prepared.problem;
        let of = |place: usize| {
            let tried = &self.selection.models[place];
            self.search.model_over(problem, &tried.effects).respond(&tried.fit.z).ok()
        };
        rmse_of_both([&of(self.selection.base)?, &of(model)?], &self.prepared.all_rows().told(), 0..problem.response.len())
    }

    fn says_farther(&self, model: usize, [without, with]: [f64; 2]) -> String {
        format!(
            "{} would be likelier, but its errors are larger even on the rows that it was fitted to ({} against {} {}), so it is not claimed",
            self.names(self.effects(model)),
            significant(with, 3),
            significant(without, 3),
            self.search.problem.simulator.unit()
        )
    }

    fn says_next_to_nothing(&self, model: usize, share: f64) -> String {
        let names = self.names(self.effects(model));
        let removes = if share > 0.0 { format!("{} of", percent_of(share)) } else { "nothing of".into() };
        format!(
            "{names} would fit, but that removes {removes} the misfit on rows left out, and tests still see a difference, so it is not claimed"
        )
    }

    fn says_too_little(&self, model: usize, against: Against) -> String {
        format!(
            "{} would fit, but without it rows left out are predicted {} ({}), so it is not claimed",
            self.names(self.effects(model)),
            against.others_predict(),
            self.measured(against)
        )
    }

    /// Why nothing is named where rows left out speak against the model.
    fn refused(&self, model: usize, against: Against) -> Reserved {
        let ids = self.effects(model).iter().map(|e| self.id(*e)).collect::<Vec<_>>().join(" and ");
        let says = format!(
            "there is a mismatch, but its cause is not decided: {ids} would fit it, and rows left out are predicted {} by the calibrated model alone ({})",
            against.others_predict(),
            self.measured(against)
        );
        Reserved { says, withheld: false, input_missing: false }
    }

    /// What speaks against a model, for a reader.
    fn measured(&self, against: Against) -> String {
        let unit = self.search.problem.simulator.unit();
        match against {
            Against::Errors([without, with]) => format!("{} against {} {unit}", significant(without, 3), significant(with, 3)),
            Against::Little([without, with]) => format!(
                "{} against {} {unit}: {}",
                significant(without, 3),
                significant(with, 3),
                self.prepared.noise.does_as_much()
            ),
            Against::Score(lost) if lost <= 0.0 => "measured in the noise, it gains no more than trying many effects does".into(),
            Against::Score(lost) => {
                format!("measured in the noise, by {} squares of its standard deviation over all rows", significant(lost, 2))
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fit::score_test::JointTest;

    /// A regime change was refused and rows left out chose a drift: the sentence still told that the regime change was refused.
    #[test]
    fn what_took_one_model_back_says_nothing_of_the_next() {
        let test = JointTest { statistic: 0.0, freedom: 1, p_value: 1.0 };
        let after = Adequacy { smooth: test, stretches: test, line_p_value: 1.0, line_at: (0, 0.0), left_over_noise: 1.0 };
        let undecided = Decision::nothing(Verdict::Undecided, 0);
        let refused = Reserved { says: "refused".into(), withheld: false, input_missing: false };
        let nothing = || Unseen::nothing(HeldOutFit::default());
        let first = Predicted {
            unseen: nothing(),
            decision: undecided,
            after: None,
            vetoed: Some(refused),
            left_out: vec!["a doubt".into()],
            refuted: Vec::new(),
        };
        let second = first.with(nothing(), Decision { model: 1, ..Decision::nothing(Verdict::Explained, 0) }, after);
        assert_eq!((second.vetoed, second.decision.verdict), (None, Verdict::Explained));
        assert_eq!(second.left_out, ["a doubt"]);
    }
}
