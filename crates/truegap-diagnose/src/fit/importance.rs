//! Evidence by importance sampling: the check of Laplace's approximation for the models near the top.
//!
//! Parameters that trade off against one another make a sloppy direction that bends; draws from a Gaussian at its lowest point leave it. So only the soft directions are
//! drawn, and for each draw the stiff ones are fitted again, where Laplace's approximation is good.
//!
//! Limits: one optimum; the curvature of the stiff directions is taken as the same all along; where few draws carry the weight, the estimate is refused and Laplace stands.

use crate::{
    fit::tuning::{FIRST_DRAWS, PROPOSAL_FREEDOM, STIFF, STIFF_STEPS},
    fit::{model::Model, optimum::Fit},
    stats::{log_sum_exp, normal_between, symmetric_eigen},
    whitening::whitener::Whitener,
};
use nalgebra::{DMatrix, DVector};
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;
use rand_distr::{ChiSquared, Distribution, StandardNormal};
use rayon::prelude::*;
use statrs::function::gamma::ln_gamma;
use std::f64::consts::PI;

/// An estimate of the log evidence, on the scale of [`crate::fit::laplace::laplace`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sampled {
    /// log of the mean weight
    pub log_evidence: f64,
    /// effective number of draws over their number, 0 to 1
    pub effective_share: f64,
}

/// What is known after some draws.
struct Mean {
    log_evidence: f64,
    effective_share: f64,
    /// standard error of the log evidence
    error: f64,
}

impl Mean {
    fn of(weights: &[f64]) -> Self {
        let draws = weights.len() as f64;
        let total = log_sum_exp(weights);
        let squares = log_sum_exp(&weights.iter().map(|w| 2.0 * w).collect::<Vec<_>>());
        let effective_share = (2.0 * total - squares).exp() / draws;
        Self { log_evidence: total - draws.ln(), effective_share, error: ((effective_share.recip() - 1.0) / draws).sqrt() }
    }
}

/// Draws the soft directions from a multivariate t about the optimum and averages the weights; `None` where no draw has an answer. A quarter of the `draws` has to do where the log evidence is
/// known to `enough` after it.
///
/// **Source:** importance sampling as in Robert & Casella, Monte Carlo Statistical Methods, section 3.3, on the profile over the stiff directions.
pub fn sampled(model: &Model<'_>, whitener: &Whitener, fit: &Fit, draws: usize, enough: f64, seed: u64) -> Option<Sampled> {
    let sloppy = SloppyDirections::of(model, whitener, fit);
    let soft = sloppy.soft.ncols();
    let bounds = model.bounds();
    let mass: f64 = bounds.iter().map(|(low, high)| normal_between(*low, *high).max(1e-12).ln()).sum();
    let chi = ChiSquared::new(PROPOSAL_FREEDOM).ok()?;
    let mut random = ChaCha8Rng::seed_from_u64(seed);
    let drawn: Vec<(DVector<f64>, f64)> = (0..draws)
        .map(|_| {
            let normal = DVector::from_fn(soft, |_, _| -> f64 { StandardNormal.sample(&mut random) });
            (normal, PROPOSAL_FREEDOM / chi.sample(&mut random))
        })
        .collect();
    let weigh = |(normal, stretch): &(DVector<f64>, f64)| {
        let stretch = *stretch;
        let along = DVector::from_fn(soft, |i, _| normal[i] * (stretch / sloppy.curvature[i]).sqrt());
        let proposal = log_t(soft, normal.norm_squared() * stretch) + 0.5 * sloppy.curvature.iter().map(|c| c.ln()).sum::<f64>();
        let height = sloppy.height(&along, &bounds).unwrap_or(f64::INFINITY);
        sloppy.across - height - 0.5 * soft as f64 * (2.0 * PI).ln() - mass - proposal
    };
    let (first, rest) = drawn.split_at(draws / FIRST_DRAWS);
    let mut weights: Vec<f64> = first.par_iter().map(weigh).collect();
    // NaN where no draw has an answer yet
    let known = Mean::of(&weights).error < enough;
    if !known {
        weights.par_extend(rest.par_iter().map(weigh));
    }
    let Mean { log_evidence, effective_share, .. } = Mean::of(&weights);
    log_evidence.is_finite().then_some(Sampled { log_evidence, effective_share })
}

/// Log density of the standard multivariate t in `n` dimensions at a squared distance.
fn log_t(n: usize, distance: f64) -> f64 {
    let n = n as f64;
    let constant =
        ln_gamma(0.5 * (PROPOSAL_FREEDOM + n)) - ln_gamma(0.5 * PROPOSAL_FREEDOM) - 0.5 * n * (PROPOSAL_FREEDOM * PI).ln();
    constant - 0.5 * (PROPOSAL_FREEDOM + n) * (distance / PROPOSAL_FREEDOM).ln_1p()
}

/// The posterior about a fit, split into soft and stiff directions.
struct SloppyDirections<'a, 'm> {
    model: &'a Model<'m>,
    whitener: &'a Whitener,
    fit: &'a Fit,
    /// p x soft
    soft: DMatrix<f64>,
    /// curvature along each of them
    curvature: Vec<f64>,
    /// p x p: from a gradient to the stiff part of a Newton step
    stiff_newton: DMatrix<f64>,
    /// minus half the log determinant of the stiff curvatures
    across: f64,
}

impl<'a, 'm> SloppyDirections<'a, 'm> {
    fn of(model: &'a Model<'m>, whitener: &'a Whitener, fit: &'a Fit) -> Self {
        let eigen = symmetric_eigen(fit.hessian.clone());
        let n = fit.z.len();
        let soft: Vec<usize> = (0..n).filter(|i| eigen.eigenvalues[*i] < STIFF).collect();
        let mut stiff_newton = DMatrix::zeros(n, n);
        let mut across = 0.0;
        for i in (0..n).filter(|i| !soft.contains(i)) {
            let direction = eigen.eigenvectors.column(i);
            stiff_newton += direction * direction.transpose() / eigen.eigenvalues[i];
            across -= 0.5 * eigen.eigenvalues[i].ln();
        }
        let curvature = soft.iter().map(|i| eigen.eigenvalues[*i].max(1e-3)).collect();
        Self { model, whitener, fit, soft: eigen.eigenvectors.select_columns(&soft), curvature, stiff_newton, across }
    }

    /// Half of chi2 and the prior's penalty at a place along the soft directions, the stiff ones fitted; `None` outside the bounds or where there is no answer.
    fn height(&self, along: &DVector<f64>, bounds: &[(f64, f64)]) -> Option<f64> {
        let mut z = DVector::from_column_slice(&self.fit.z) + &self.soft * along;
        let mut best = f64::INFINITY;
        for _ in 0..=STIFF_STEPS.0 {
            if !z.iter().zip(bounds).all(|(z, b)| (b.0..=b.1).contains(z)) {
                break;
            }
            let Ok(residual) = self.model.residual(z.as_slice(), self.whitener) else { break };
            let residual = DVector::from_vec(residual);
            let prior = self.model.prior(z.as_slice());
            best = best.min(0.5 * (residual.norm_squared() + prior.penalty()));
            let gradient = self.fit.jacobian.tr_mul(&residual) - DVector::from_iterator(z.len(), prior.gradient());
            let step = &self.stiff_newton * &gradient;
            if 0.5 * step.dot(&gradient) < STIFF_STEPS.1 {
                break;
            }
            z += step;
        }
        best.is_finite().then_some(best)
    }
}
