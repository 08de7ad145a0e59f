//! Rows left out have the last word: what predicts them worse than the calibrated base model in most parts, or with more than twice its error over all, is not claimed.
//!
//! One part alone may be hard for the right physics too: where it holds the only first loading, or all that came before a change.
//!
//! Limits: a number for each run, or for whatever happens, foretells nothing of a run left out and is not judged by it.

use crate::{
    validation::cross_validation::{HeldOutFit, compared},
    validation::tuning::{CLEARLY_WORSE, EXTRAPOLATED},
};

/// Predictions of rows left out, by the base model and by the model stood behind.
pub(crate) struct Unseen {
    /// calibrated base model
    pub base: HeldOutFit,
    /// the model stood behind; absent where it is the base model
    pub named: Option<HeldOutFit>,
}

impl Unseen {
    /// Predictions of the model stood behind.
    pub fn stood_behind(&self) -> &HeldOutFit {
        self.named.as_ref().unwrap_or(&self.base)
    }

    /// Errors of base and model on the rows that both predict, where the model's is larger by more than [`EXTRAPOLATED`], or clearly larger and larger in most parts.
    pub fn worse(&self) -> Option<[f64; 2]> {
        let compared = compared(&self.base, self.named.as_ref()?)?;
        let [base, named] = compared.rmse;
        let parts = compared.parts.iter().filter(|(_, base, named)| named > base).count();
        let mostly = named > CLEARLY_WORSE * base && 2 * parts > compared.parts.len();
        (named > EXTRAPOLATED * base || mostly).then_some([base, named])
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::validation::cross_validation::PartError;

    fn predicted(errors: &[f64]) -> HeldOutFit {
        let part = |squares: &f64| PartError { name: "run 1".into(), squares: Some(*squares), rows: 4 };
        HeldOutFit { how: String::new(), prediction: Vec::new(), parts: errors.iter().map(part).collect() }
    }

    #[test]
    fn a_model_that_predicts_worse_is_told_from_one_that_predicts_better() {
        let worse = Unseen { base: predicted(&[4.0, 4.0]), named: Some(predicted(&[2.0, 70.0])) };
        assert_eq!(worse.worse(), Some([1.0, 3.0]));
        assert_eq!(Unseen { base: predicted(&[4.0]), named: Some(predicted(&[1.0])) }.worse(), None);
        // an error that extrapolation makes in one part is no proof against it, one in most parts is
        let of = |named: &[f64]| Unseen { base: predicted(&[4.0, 4.0, 4.0]), named: Some(predicted(named)) }.worse();
        assert_eq!(of(&[2.0, 3.0, 16.0]), None);
        assert!(of(&[7.0, 5.0, 3.0]).is_some());
        // nor is a hundredth in every part
        assert_eq!(of(&[4.08, 4.08, 4.08]), None);
        assert_eq!(Unseen { base: predicted(&[4.0]), named: None }.worse(), None);
    }
}
