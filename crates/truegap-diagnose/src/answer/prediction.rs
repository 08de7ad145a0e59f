//! What may be predicted where nothing may be named: the likeliest model of the library as a flexible term, with no claim about the cause.
//!
//! Limits: its freedom is that of the library's effects, at most three at once; what they leave is located, not modelled.

use crate::{
    answer::{
        assemble::Answer,
        fit_facts::{BeforeAfter, FlexibleTerm, PredictionOnly},
    },
    explain::locate::{Mismatch, locate},
    fit::model::Model,
    selection::{
        candidates::Tried,
        verdict::{Verdict, stated},
    },
    stats::rmse_of,
    validation::cross_validation::{HeldOutFit, held_out, misfit_removed},
};
/// The term, and its predictions row by row.
pub struct Flexible {
    /// what is said of it
    pub facts: PredictionOnly,
    /// fitted to all rows
    pub prediction: Vec<f64>,
    /// of rows left out
    pub held_out: Vec<f64>,
}

impl Answer<'_> {
    /// The likeliest model as a flexible term, where something is missing that the library does not explain; `base` and `before` are the base model on every row and on rows left
    /// out.
    ///
    /// `None` where something is named, or nothing of the library helps.
    pub(crate) fn flexible(&self, base: &[f64], before: &HeldOutFit) -> Option<Flexible> {
        if self.decision.verdict != Verdict::Unexplained || self.decision.removed <= 0.0 {
            return None;
        }
        let tried = &self.selection.models[stated(self.selection)?];
        let after = held_out(self.search, self.searched_noise, tried, self.all);
        let prediction = self.respond(tried);
        let floor = self.noise.floor();
        let in_sample = BeforeAfter { rmse_before: self.rmse(base), rmse_after: self.rmse(&prediction) };
        let unit = self.search.problem.simulator.unit();
        let facts = PredictionOnly {
            says: format!(
                "for prediction only, without a claim about the cause: a flexible term brings the error from {:.3} to {:.3} {unit}, on rows left out \
                 from {:.3} to {:.3} {unit}",
                in_sample.rmse_before, in_sample.rmse_after, before.rmse, after.rmse,
            ),
            terms: self.terms(tried),
            in_sample,
            held_out: BeforeAfter { rmse_before: before.rmse, rmse_after: after.rmse },
            misfit_removed: misfit_removed(before.rmse, after.rmse, floor, self.noise.rows),
            shuffled_control: self.shuffled(tried),
            remains: self.remains(tried),
        };
        Some(Flexible { facts, prediction, held_out: after.prediction })
    }

    /// Response of every row, as `tried` has it; empty where the simulator has no answer.
    pub(crate) fn respond(&self, tried: &Tried) -> Vec<f64> {
        let effects = tried.effects.iter().map(|e| self.search.library[*e]).collect();
        Model::new(self.all.problem, self.search.context, effects).respond(&tried.fit.z).unwrap_or_default()
    }

    /// Root-mean-square error of a prediction of every row.
    pub(crate) fn rmse(&self, prediction: &[f64]) -> f64 {
        rmse_of(prediction, self.all.problem.response, 0..prediction.len())
    }

    /// Where recording and `tried` differ.
    pub(crate) fn located(&self, tried: &Tried) -> Vec<Mismatch> {
        locate(self.search.problem, &tried.fit, self.gate, self.directions)
    }

    /// The same of a model that holds more than the calibrated one.
    pub(crate) fn remains(&self, tried: &Tried) -> Vec<Mismatch> {
        let mut found = self.located(tried);
        found.iter_mut().for_each(|m| m.says = m.says.replacen("calibrated model differ", "fuller model still differ", 1));
        found
    }

    /// The parts of the term, in the library's words for what they are shaped like.
    fn terms(&self, tried: &Tried) -> Vec<FlexibleTerm> {
        let model = self.search.model(&tried.effects);
        let term = |(index, effect): (usize, &usize)| FlexibleTerm {
            shaped_like: self.id(*effect),
            says: self.search.library[*effect].told(&self.fitted(tried, model.range_of(index)), self.search.context, &[]),
            parameters: self.parameters(tried, model.range_of(index)),
        };
        tried.effects.iter().enumerate().map(term).collect()
    }
}
