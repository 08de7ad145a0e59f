//! Log evidence of a fit: Laplace's approximation, with one-sided parameters integrated over their half line.
//!
//! Limits: Gaussian away from bounds; checked by sampling near the top ([`crate::importance`]).

use nalgebra::{Cholesky, DMatrix};
use statrs::function::erf::erfc;

/// Log evidence up to the constant of the likelihood: `-chi2/2 - |z|^2/2 - log det(H)/2`, with corrections at bounds.
///
/// `gradient` is that of the objective at `z`; `bounds` in z.
pub fn laplace(chi2: f64, z: &[f64], hessian: &DMatrix<f64>, gradient: &[f64], bounds: &[(f64, f64)]) -> f64 {
    let Some(factor) = Cholesky::new(hessian.clone()) else {
        return f64::NEG_INFINITY;
    };
    let log_det = 2.0 * factor.l_dirty().diagonal().iter().map(|d| d.ln()).sum::<f64>();
    let covariance = factor.inverse();
    let penalty: f64 = z.iter().map(|z| z * z).sum();
    let bounded: f64 = (0..z.len()).map(|i| one_sided(z[i], covariance[(i, i)], gradient[i], bounds[i])).sum();
    -0.5 * (chi2 + penalty + log_det) + bounded
}

/// Log of the share of the posterior inside the bounds over the share of the prior inside them, for one parameter.
fn one_sided(z: f64, variance: f64, gradient: f64, bounds: (f64, f64)) -> f64 {
    let (low, high) = bounds;
    if low == f64::NEG_INFINITY && high == f64::INFINITY {
        return 0.0;
    }
    let prior = normal_between(low, high).max(1e-12).ln();
    let sd = variance.sqrt();
    let on_bound = (z - low).abs() < 1e-9 || (high - z).abs() < 1e-9;
    let posterior = if on_bound {
        half_line(gradient.abs(), variance)
    } else {
        normal_between((low - z) / sd, (high - z) / sd).max(1e-12).ln()
    };
    posterior - prior
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

/// Probability of a unit normal between two points.
pub(crate) fn normal_between(low: f64, high: f64) -> f64 {
    let upper_tail = |x: f64| 0.5 * erfc(x / std::f64::consts::SQRT_2);
    if low > 0.0 { upper_tail(low) - upper_tail(high) } else { upper_tail(-high) - upper_tail(-low) }
}

/// Log of the sum of exponentials.
pub fn log_sum_exp(values: &[f64]) -> f64 {
    let greatest = values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    if greatest == f64::NEG_INFINITY {
        return greatest;
    }
    greatest + values.iter().map(|v| (v - greatest).exp()).sum::<f64>().ln()
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
        let found = laplace(chi2, &[z], &DMatrix::from_element(1, 1, 1.0 + a * a), &[0.0], &[(f64::NEG_INFINITY, f64::INFINITY)]);
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
}
