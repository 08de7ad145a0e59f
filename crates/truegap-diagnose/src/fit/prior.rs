//! What is known of a number beforehand, as a residual of its own beside those of the rows.
//!
//! A tolerance says how well a number of the base model is known where it is right. But a modulus may be of another batch, a thickness of another drawing: a
//! Gaussian of the tolerance's width makes ten deviations all but impossible, so that any effect which can stand in for a wrong number is named with
//! certainty. Here each number of the base model is wrong with a small probability, and then known [`WIDER_PRIOR`] times less well. Numbers of effects keep their
//! Gaussian.
//!
//! Limits: numbers are right or wrong independently of one another.
//!
//! **Source:** contaminated normal of Tukey (1960), as a prior in Box & Tiao, Bayesian Inference in Statistical Analysis (1973), section 3.2.

use crate::fit::tuning::{WIDER_PRIOR, WRONG_PRIOR};

/// Prior of all numbers of a model at a point.
#[derive(Clone, Debug, Default)]
pub(crate) struct Prior {
    /// half of its square is minus the log of a number's density, over that at the centre
    pub(crate) residual: Vec<f64>,
    /// change of `residual` with the number
    pub(crate) slope: Vec<f64>,
}

impl Prior {
    /// At `z`, in standard deviations; the first `known` numbers are those of the base model.
    pub(crate) fn at(z: &[f64], known: usize) -> Self {
        let terms = z.iter().enumerate().map(|(i, z)| if i < known { contaminated(*z) } else { (*z, 1.0) });
        let (residual, slope) = terms.unzip();
        Self { residual, slope }
    }

    /// Sum of the squares.
    pub(crate) fn penalty(&self) -> f64 {
        self.residual.iter().map(|r| r * r).sum()
    }

    /// Curvature that it adds to half of chi2, one entry a number.
    pub(crate) fn curvature(&self) -> impl Iterator<Item = f64> + '_ {
        self.slope.iter().map(|s| s * s)
    }

    /// Gradient of half of its penalty, one entry a number.
    pub(crate) fn gradient(&self) -> impl Iterator<Item = f64> + '_ {
        self.residual.iter().zip(&self.slope).map(|(r, s)| r * s)
    }
}

/// Residual and slope of a number that may be grossly wrong: `r = sign(z) sqrt(-2 ln(p(z) / p(0)))` for
/// `p(z) ~ (1 - w) exp(-z^2 / 2) + w / W exp(-z^2 / (2 W^2))`.
fn contaminated(z: f64) -> (f64, f64) {
    let (right, wrong) = (1.0 - WRONG_PRIOR, WRONG_PRIOR / WIDER_PRIOR);
    let precision = WIDER_PRIOR.powi(-2);
    let excess = 0.5 * z * z * (1.0 - precision);
    // p(z) / p(0) is exp(-z^2 / (2 W^2)) times a mean of exp(-excess) and 1
    let share = wrong / (right * (-excess).exp() + wrong);
    let penalty = z * z * precision + 2.0 * ((right + wrong) * share / wrong).ln();
    let residual = penalty.max(0.0).sqrt().copysign(z);
    let pull = z * (share * precision + 1.0 - share);
    let near = 1e-4;
    let slope = if z.abs() < near { (1.0 - (1.0 - precision) * wrong / (right + wrong)).sqrt() } else { pull / residual };
    (if z.abs() < near { slope * z } else { residual }, slope)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The residual against the mixture's own density, its slope against differences.
    #[test]
    fn half_the_square_of_the_residual_is_the_log_density() {
        let density = |z: f64| {
            (1.0 - WRONG_PRIOR) * (-0.5 * z * z).exp() + WRONG_PRIOR / WIDER_PRIOR * (-0.5 * (z / WIDER_PRIOR).powi(2)).exp()
        };
        for z in [-40.0, -9.0, -3.4, -1.0, -1e-3, 0.5, 2.9, 4.2, 6.0, 31.0] {
            let (residual, slope) = contaminated(z);
            approx::assert_abs_diff_eq!(0.5 * residual * residual, -(density(z) / density(0.0)).ln(), epsilon = 1e-9);
            let step = 1e-5 * z.abs().max(1e-2);
            let difference = (contaminated(z + step).0 - contaminated(z - step).0) / (2.0 * step);
            approx::assert_relative_eq!(slope, difference, max_relative = 1e-4);
            assert!(slope > 0.0 && residual.signum() == z.signum());
        }
    }

    /// Ten deviations cost what a gross error costs, ln(W / w) and the wide Gaussian, and not fifty.
    #[test]
    fn a_gross_error_is_no_proof_of_missing_physics() {
        let cost = 0.5 * contaminated(10.0).0.powi(2);
        approx::assert_abs_diff_eq!(
            cost,
            (WIDER_PRIOR / WRONG_PRIOR).ln() + 0.5 + (1.0 - WRONG_PRIOR + WRONG_PRIOR / WIDER_PRIOR).ln(),
            epsilon = 1e-6
        );
        let gaussian = 0.5 * contaminated(1.0).0.powi(2);
        approx::assert_relative_eq!(gaussian, 0.5, max_relative = 5e-3);
    }
}
