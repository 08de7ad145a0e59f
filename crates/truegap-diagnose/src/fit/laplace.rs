//! Log evidence of a fit: Laplace's approximation, with one-sided parameters integrated over their half line.
//!
//! Limits: Gaussian away from bounds; checked by sampling near the top ([`crate::fit::importance`]).
//!
//! **Source:** Tierney & Kadane, J. Am. Stat. Assoc. 81 (1986) 82; Kass & Raftery, J. Am. Stat. Assoc. 90 (1995) 773, section 4.1. What is done at bounds is derived here.

use crate::{
    fit::tuning::{FAR_FROM_BOUND, SIZE_SCALES},
    stats::{log_mean_exp, normal_between},
};
use nalgebra::{Cholesky, DMatrix, Dyn};
use statrs::function::erf::erfc;

/// Log evidence up to the constant of the likelihood: `-chi2/2 - penalty/2 - log det(H)/2`, with corrections at bounds.
///
/// `penalty` is the prior's, |z|^2 for Gaussians; `gradient` is that of the objective at `z`; `bounds` in z.
pub fn laplace(chi2: f64, z: &[f64], penalty: f64, hessian: &DMatrix<f64>, gradient: &[f64], bounds: &[(f64, f64)]) -> f64 {
    let Some(factor) = Cholesky::new(hessian.clone()) else {
        return f64::NEG_INFINITY;
    };
    let log_det = log_determinant(&factor);
    let covariance = factor.inverse();
    let bounded: f64 = (0..z.len()).map(|i| one_sided(z[i], covariance[(i, i)], gradient[i], bounds[i])).sum();
    -0.5 * (chi2 + penalty + log_det) + bounded
}

/// Log determinant of a positive definite matrix, from its factor.
pub(crate) fn log_determinant(factor: &Cholesky<f64, Dyn>) -> f64 {
    2.0 * factor.l_dirty().diagonal().iter().map(|d| d.ln()).sum::<f64>()
}

/// Log of the share of the posterior inside the bounds over the share of the prior inside them, for one parameter.
fn one_sided(z: f64, variance: f64, gradient: f64, bounds: (f64, f64)) -> f64 {
    let (low, high) = bounds;
    if low == f64::NEG_INFINITY && high == f64::INFINITY {
        return 0.0;
    }
    let prior = normal_between(low, high).max(1e-12).ln();
    let sd = variance.sqrt();
    let posterior = if on_bound(z, low) || on_bound(z, high) {
        half_line(gradient.abs(), variance)
    } else {
        normal_between((low - z) / sd, (high - z) / sd).max(1e-12).ln()
    };
    posterior - prior
}

/// Whether a parameter lies on a bound.
pub(crate) fn on_bound(z: f64, bound: f64) -> bool {
    (z - bound).abs() < 1e-9
}

/// Log evidence that one size gains when its prior is not one Gaussian about 0 but the mean of several, from four times as wide to a 64th.
///
/// What is known of an effect is its order of magnitude, if that. One narrow Gaussian makes a size of five deviations all but impossible, one wide makes every
/// small size dear; either way the wrong neighbour wins. `z` and `variance` are the size's under the single prior, `gradient` that of the objective at `z`, which
/// counts on a bound only; the likelihood is taken as Gaussian in the size once all else is fitted.
pub fn any_scale(z: f64, variance: f64, gradient: f64, bounds: (f64, f64)) -> f64 {
    let outwards = if on_bound(z, bounds.0) {
        gradient.max(0.0)
    } else if on_bound(z, bounds.1) {
        gradient.min(0.0)
    } else {
        0.0
    };
    // free of its bounds and of the prior, the likelihood has mean and variance
    let spread = variance / (1.0 - variance).max(1e-9);
    let mean = (z - outwards * variance) / (1.0 - variance).max(1e-9);
    let at = |scale: f64| {
        let prior = scale * scale;
        let whole = spread + prior;
        let (centre, sd) = (mean * prior / whole, (spread * prior / whole).sqrt());
        let inside = log_normal_between((bounds.0 - centre) / sd, (bounds.1 - centre) / sd);
        let before = log_normal_between(bounds.0 / scale, bounds.1 / scale);
        inside - before - 0.5 * (mean * mean / whole + whole.ln())
    };
    let each = SIZE_SCALES.map(at);
    // where the recording hardly tells the size, a straight line carries it far beyond what was fitted: no width of the prior saves more than all that the size pays,
    // nor more of its freedom than the narrowest
    let most = 0.5 * z * z + (1.0 / SIZE_SCALES[SIZE_SCALES.len() - 1]).ln();
    (log_mean_exp(&each) - at(1.0)).min(most)
}

/// Log of the integral of `exp(-g t - t^2 / (2 v))` over t > 0, over that of the full Gaussian of variance v.
fn half_line(gradient: f64, variance: f64) -> f64 {
    let x = gradient * (0.5 * variance).sqrt();
    if x > 5.0 {
        // erfc(x) exp(x^2) -> 1 / (x sqrt(pi)) (1 - 1 / (2 x^2))
        return (0.5 * (1.0 - 0.5 / (x * x)) / (x * std::f64::consts::PI.sqrt())).ln();
    }
    (0.5 * erfc(x)).ln() + x * x
}

/// Log of the same, however far out in a tail.
fn log_normal_between(low: f64, high: f64) -> f64 {
    let nearest = low.max(-high);
    if nearest < FAR_FROM_BOUND {
        return normal_between(low, high).ln();
    }
    // the tail of a Gaussian, by its first two asymptotic terms; the far end of the range weighs nothing
    -0.5 * nearest * nearest - (nearest * (2.0 * std::f64::consts::PI).sqrt()).ln() + (-1.0 / (nearest * nearest)).ln_1p()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// One parameter, one datum: y = a z + noise, prior N(0, 1): evidence is N(y; 0, 1 + a^2) in closed form.
    #[test]
    fn a_linear_gaussian_model_has_its_exact_evidence() {
        let (a, y) = (3.0, 2.0);
        let z = a * y / (1.0 + a * a);
        let chi2 = (y - a * z) * (y - a * z);
        let found =
            laplace(chi2, &[z], z * z, &DMatrix::from_element(1, 1, 1.0 + a * a), &[0.0], &[(f64::NEG_INFINITY, f64::INFINITY)]);
        let exact = -0.5 * y * y / (1.0 + a * a) - 0.5 * f64::ln(1.0 + a * a);
        approx::assert_relative_eq!(found, exact, max_relative = 1e-12);
    }

    /// The same with z >= 0, against quadrature; data that pull inwards, and outwards against the bound.
    #[test]
    fn a_half_line_prior_is_integrated() {
        let a = 3.0;
        for y in [2.0, 0.2, -0.5, -4.0] {
            let free = a * y / (1.0 + a * a);
            let z: f64 = f64::max(free, 0.0);
            let gradient = z - a * (y - a * z);
            let found = laplace(
                (y - a * z).powi(2),
                &[z],
                z * z,
                &DMatrix::from_element(1, 1, 1.0 + a * a),
                &[gradient],
                &[(0.0, f64::INFINITY)],
            );
            let step = 1e-4;
            let density = |t: f64| (2.0 / (2.0 * std::f64::consts::PI).sqrt()) * (-0.5 * t * t - 0.5 * (y - a * t).powi(2)).exp();
            let exact: f64 = (0..100_000).map(|i| density((f64::from(i) + 0.5) * step) * step).sum();
            approx::assert_relative_eq!(found, exact.ln(), max_relative = 3e-3);
        }
    }

    /// A size that is driven far and that the likelihood hardly curves about: what a wider prior saves stays below the penalty, 25 000 here.
    #[test]
    fn a_size_that_is_hardly_known_gains_no_more_than_it_pays() {
        let (z, variance) = (225.0, 0.999_99);
        let gain = any_scale(z, variance, 0.0, (f64::NEG_INFINITY, f64::INFINITY));
        assert!(gain > 0.0 && gain < 0.5 * z * z + 5.0, "{gain}");
    }

    /// A straight line in one size, its prior the mean of half Gaussians of all scales: against quadrature over the size.
    #[test]
    fn a_size_of_unknown_magnitude_is_integrated_over_its_scales() {
        for (a, y) in [(3.0, 2.0), (400.0, 6.0), (60.0, 2.0), (9.0, 45.0), (40.0, -3.0), (0.1, 0.5), (5.0, -30.0)] {
            let z = f64::max(a * y / (1.0 + a * a), 0.0);
            let gradient = z - a * (y - a * z);
            let bounds = (0.0, f64::INFINITY);
            let found = any_scale(z, 1.0 / (1.0 + a * a), gradient, bounds);
            let likelihood = |t: f64| (-0.5 * (y - a * t).powi(2)).exp();
            let half = |t: f64, scale: f64| (-0.5 * (t / scale).powi(2)).exp() / scale;
            let step = 2e-6;
            let integral = |prior: &dyn Fn(f64) -> f64| -> f64 {
                (0..10_000_000).map(|i| (f64::from(i) + 0.5) * step).map(|t| prior(t) * likelihood(t)).sum()
            };
            let every = integral(&|t| SIZE_SCALES.iter().map(|s| half(t, *s)).sum::<f64>() / SIZE_SCALES.len() as f64);
            let exact = (every / integral(&|t| half(t, 1.0))).ln();
            // midpoints 2 millionths apart, up to 20 of the single prior's deviations
            approx::assert_abs_diff_eq!(found, exact, epsilon = 1e-3);
        }
    }
}
