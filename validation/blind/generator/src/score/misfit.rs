//! Share of the reproducible misfit removed on a fresh history.
//!
//! Limits: compares with the noise-free truth, so no noise has to be subtracted; unseen inputs must be the quiet ones.

/// `1 - MSE(after) / MSE(before)` against `truth_pf`; `None` for unequal lengths or where nothing was to remove.
pub fn misfit_removed(truth_pf: &[f64], before_pf: &[f64], after_pf: &[f64]) -> Option<f64> {
    let square = |model: &[f64]| {
        (model.len() == truth_pf.len()).then(|| truth_pf.iter().zip(model).map(|(t, m)| (t - m).powi(2)).sum::<f64>())
    };
    let (before, after) = (square(before_pf)?, square(after_pf)?);
    (before > 0.0).then(|| 1.0 - after / before)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn half_the_error_everywhere_removes_three_quarters() {
        assert_eq!(misfit_removed(&[0.0, 0.0], &[2.0, -2.0], &[1.0, -1.0]), Some(0.75));
        assert_eq!(misfit_removed(&[0.0], &[0.0], &[1.0]), None);
    }
}
