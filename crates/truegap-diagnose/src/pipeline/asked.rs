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
use std::sync::{Mutex, MutexGuard, PoisonError};

/// Most numbers that are kept: predictions of every row for each model.
const MOST_KEPT: usize = 2_000_000;

/// Answers so far.
#[derive(Default)]
pub(crate) struct Asked(Mutex<Vec<(Question, HeldOutFit)>>);

/// What an answer follows from.
#[derive(Clone, PartialEq)]
struct Question {
    effects: Vec<usize>,
    z: Vec<f64>,
    held: Vec<Number>,
    squares: bool,
}

impl Asked {
    /// What `ask` says of a model, calibrated by least squares or not (`squares`); what it said before, where the same was asked.
    pub fn answer(&self, search: &Search<'_>, tried: &Tried, squares: bool, ask: impl FnOnce() -> HeldOutFit) -> HeldOutFit {
        let (effects, z) = (tried.effects.clone(), tried.fit.z.clone());
        self.once(Question { effects, z, held: search.context.held.clone(), squares }, ask)
    }

    fn once(&self, question: Question, ask: impl FnOnce() -> HeldOutFit) -> HeldOutFit {
        let known = self.list().iter().find(|(before, _)| *before == question).map(|(_, answer)| answer.clone());
        known.unwrap_or_else(|| {
            // the list is free meanwhile: an answer is computed side by side with others
            let answer = ask();
            let mut list = self.list();
            if (list.len() + 1) * answer.prediction.len() <= MOST_KEPT {
                list.push((question, answer.clone()));
            }
            answer
        })
    }

    fn list(&self) -> MutexGuard<'_, Vec<(Question, HeldOutFit)>> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use truegap_core::EffectId;

    /// Another model, another place of the same, a number that is held, or another way to calibrate is another question.
    #[test]
    fn the_same_is_asked_once_and_what_differs_is_asked_anew() {
        let first = Question { effects: vec![1, 4], z: vec![0.5, -1.0], held: Vec::new(), squares: false };
        let others = [
            first.clone(),
            Question { effects: vec![1, 3], ..first.clone() },
            Question { z: vec![0.5, -1.0 + 1e-12], ..first.clone() },
            Question { held: vec![(EffectId("a"), "b")], ..first.clone() },
            Question { squares: true, ..first.clone() },
        ];
        let asked = Asked::default();
        let answer =
            |says: &str| HeldOutFit { how: says.into(), prediction: vec![1.0], parts: Vec::new(), ..HeldOutFit::default() };
        let found: Vec<String> =
            [first].into_iter().chain(others).enumerate().map(|(i, q)| asked.once(q, || answer(&i.to_string())).how).collect();
        assert_eq!(found, ["0", "0", "2", "3", "4", "5"]);
    }
}
