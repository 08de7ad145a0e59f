//! What a model is worth before the recording is seen: fewer effects are likelier, many candidates share what their number is worth, and an effect that is usual has more of it.
//!
//! Beside a base model without plates an effect is as usual as the right names of real recordings say, which were written down before these were diagnosed; beside plates, and where nothing is known of it, all are alike.
//!
//! **Source:** `validation/stated/usual.py`; priors from many like problems: Efron, Large-Scale Inference (2010), ch. 1.
//!
//! Limits: effects of one model are taken to have nothing to do with one another.

use crate::{
    effects::number_of::number_of,
    selection::{
        candidates::{Search, Tried},
        tuning::NUMBER_PRIOR,
    },
};

/// How usual effects are, 1 on average: `validation/stated/usual.py`.
const USUAL: &str = include_str!("../../tables/usual_names.csv");

/// Log prior of a model with `count` of `library` effects that are all alike.
pub(crate) fn log_prior(count: usize, library: usize) -> f64 {
    let combinations: f64 = (0..count).map(|i| (library.max(count) - i) as f64 / (i + 1) as f64).product();
    (number_prior(count) / combinations).ln()
}

/// Log prior of one thing more beside `count` effects, over that of those alone; minus infinity where there are as many as there may be.
pub(crate) fn one_more(count: usize) -> f64 {
    (number_prior(count + 1) / number_prior(count)).ln()
}

fn number_prior(count: usize) -> f64 {
    NUMBER_PRIOR.get(count).copied().unwrap_or(0.0)
}

/// Prior of models with effects of a library.
#[derive(Clone, Debug, PartialEq)]
pub struct ModelPrior {
    /// how usual each effect of the library is
    usual: Vec<f64>,
    /// sum over all sets of 0, 1, 2 and 3 effects of the products of how usual these are
    of_number: [f64; NUMBER_PRIOR.len()],
}

impl ModelPrior {
    /// Of the library of a search, beside its base model.
    pub(crate) fn of(search: &Search<'_>) -> Self {
        let plates = search.context.has_plates();
        Self::with(search.library.iter().map(|effect| usual(effect.id().0, plates)).collect())
    }

    /// Of so many effects that are all alike.
    #[cfg(test)]
    pub(crate) fn alike(library: usize) -> Self {
        Self::with(vec![1.0; library])
    }

    fn with(usual: Vec<f64>) -> Self {
        let mut of_number = [0.0; NUMBER_PRIOR.len()];
        of_number[0] = 1.0;
        for own in &usual {
            for count in (1..of_number.len()).rev() {
                of_number[count] += own * of_number[count - 1];
            }
        }
        Self { usual, of_number }
    }

    /// Effects of the library.
    pub(crate) fn library(&self) -> usize {
        self.usual.len()
    }

    /// Log prior of a model with these effects; what is not of the library is one of so many that are alike.
    pub(crate) fn log(&self, effects: &[usize]) -> f64 {
        let count = effects.len();
        if count > self.usual.len() {
            return log_prior(count, self.usual.len());
        }
        let usual = |effect: &usize| self.usual.get(*effect).copied().unwrap_or(1.0);
        let sets = self.of_number.get(count).copied().unwrap_or(f64::INFINITY);
        (number_prior(count) * effects.iter().map(usual).product::<f64>() / sets).ln()
    }

    /// Log posterior of a model, up to a constant: its log evidence over `temper`, and its log prior.
    pub(crate) fn weight(&self, temper: f64) -> impl Fn(&Tried) -> f64 + Copy + Sync + '_ {
        move |m| m.fit.log_evidence / temper + self.log(&m.effects)
    }
}

/// How usual an effect is beside a base model with or without `plates`; 1 where nothing is known of it.
fn usual(effect: &str, plates: bool) -> f64 {
    if plates { 1.0 } else { number_of(effect, USUAL).unwrap_or(1.0) }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Sets of each number share what that number is worth, whatever effects are usual.
    #[test]
    fn all_models_together_are_certain() {
        for usual in [vec![1.0; 5], vec![2.0, 0.1, 1.0, 0.5, 3.0]] {
            let prior = ModelPrior::with(usual.clone());
            let sets = (0_usize..1 << 5).map(|set| (0..5).filter(|e| set & (1 << e) != 0).collect::<Vec<_>>());
            let mut by_number = [0.0; NUMBER_PRIOR.len()];
            sets.filter(|set| set.len() < NUMBER_PRIOR.len()).for_each(|set| by_number[set.len()] += prior.log(&set).exp());
            for (found, wanted) in by_number.iter().zip(NUMBER_PRIOR) {
                approx::assert_relative_eq!(*found, wanted, max_relative = 1e-12);
            }
            // a usual effect is likelier by as much, alone and beside others
            let ratio = |one: &[usize], other: &[usize]| (prior.log(one) - prior.log(other)).exp();
            approx::assert_relative_eq!(ratio(&[0], &[1]), usual[0] / usual[1], max_relative = 1e-12);
            approx::assert_relative_eq!(ratio(&[0, 2], &[1, 2]), usual[0] / usual[1], max_relative = 1e-12);
        }
    }

    #[test]
    fn effects_that_are_alike_share_evenly() {
        let prior = ModelPrior::alike(7);
        for effects in [&[][..], &[3], &[0, 6], &[1, 2, 5]] {
            approx::assert_relative_eq!(prior.log(effects), log_prior(effects.len(), 7), max_relative = 1e-12);
        }
        // more effects than there may be, or than there are
        assert_eq!(prior.log(&[0, 1, 2, 3]), f64::NEG_INFINITY);
        assert!(ModelPrior::alike(0).log(&[0]).is_finite());
    }

    /// Of 359 real recordings in which a gain could have been seen that ages, none had it for its one right name; many had a bend.
    #[test]
    fn what_is_usual_counts_beside_a_base_model_without_plates() {
        assert!(usual("gain_ageing", false) < 0.2 && usual("nonlinearity", false) > 2.0);
        assert_eq!((usual("gain_ageing", true), usual("an effect of your own", false)), (1.0, 1.0));
        let library = crate::effects::collection::Library::default();
        for row in USUAL.lines().skip(1) {
            assert!(library.find(row.split(',').next().unwrap()).is_some(), "{row}");
        }
    }
}
