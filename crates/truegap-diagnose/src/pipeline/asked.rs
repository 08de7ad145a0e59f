//! What models foretell of rows left out, so that one that is asked again is not fitted again.
//!
//! The same few models are asked by the choice of richer laws, by the one among rivals, by steps back and by the answer: each time a fit for every part that is left out.
//!
//! Limits: models of the library's effects on the rows of one recording under one noise.

use crate::{
    data::context::Number,
    selection::candidates::{Search, Tried},
    validation::cross_validation::HeldOutFit,
};
use std::sync::{Mutex, PoisonError};

/// Most numbers that are kept: predictions of every row for each model.
const MOST_KEPT: usize = 2_000_000;

/// Answers so far.
#[derive(Default)]
pub(crate) struct Asked(Mutex<Vec<(Question, HeldOutFit)>>);

/// What an answer follows from.
#[derive(PartialEq)]
struct Question {
    effects: Vec<usize>,
    z: Vec<f64>,
    held: Vec<Number>,
    squares: bool,
}

impl Asked {
    /// What `ask` says of a model, calibrated by least squares or not (`squares`); what it said before, where the same was asked.
    pub fn answer(&self, search: &Search<'_>, tried: &Tried, squares: bool, ask: impl FnOnce() -> HeldOutFit) -> HeldOutFit {
        let question =
            Question { effects: tried.effects.clone(), z: tried.fit.z.clone(), held: search.context.held.clone(), squares };
        let known = self.list().iter().find(|(before, _)| *before == question).map(|(_, answer)| answer.clone());
        known.unwrap_or_else(|| {
            let answer = ask();
            let mut list = self.list();
            if (list.len() + 1) * answer.prediction.len() <= MOST_KEPT {
                list.push((question, answer.clone()));
            }
            answer
        })
    }

    fn list(&self) -> std::sync::MutexGuard<'_, Vec<(Question, HeldOutFit)>> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }
}
