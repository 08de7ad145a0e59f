//! Score tests of a fitted model along given directions, with its own parameters and priors taken out.
//!
//! At a MAP point with whitened residual r and Jacobian J, `(1 + J J^T)^-1` applied to the linearised data is r itself, so the score along b is
//! `b . r` and its variance `b . b - (J^T b)^T (J^T J + 1)^-1 (J^T b)`.
//!
//! Limits: linear about the fit.

use crate::fit::Fit;
use nalgebra::{DMatrix, DVector, SymmetricEigen};
use statrs::distribution::{ChiSquared, ContinuousCDF};

/// Scores of a set of columns.
pub struct Scores {
    /// score of each column
    pub scores: DVector<f64>,
    /// covariance of the scores where the model is right
    pub covariance: DMatrix<f64>,
}

/// Joint test of several scores.
#[derive(Clone, Copy, Debug, serde::Serialize)]
pub struct JointTest {
    /// quadratic form, chi-squared where the model is right
    pub statistic: f64,
    /// degrees of freedom
    pub freedom: usize,
    /// probability of more, where the model is right
    pub p_value: f64,
}

impl JointTest {
    /// The same test where the noise has `factor` times the variance.
    #[must_use]
    pub fn over(self, factor: f64) -> Self {
        let statistic = self.statistic / factor;
        Self { statistic, p_value: upper_tail(statistic, self.freedom), ..self }
    }

    /// What is left above expectation.
    pub fn excess(&self) -> f64 {
        (self.statistic - self.freedom as f64).max(0.0)
    }
}

/// Scores along whitened columns `b` (n x k).
pub fn scores(fit: &Fit, b: &DMatrix<f64>) -> Scores {
    scores_with(fit, b, &b.tr_mul(b))
}

/// As [`scores`], `gram` being `b^T b`: for the same columns beside many fits.
pub fn scores_with(fit: &Fit, b: &DMatrix<f64>, gram: &DMatrix<f64>) -> Scores {
    let residual = fit.settled_residual();
    let cross = fit.jacobian.tr_mul(b);
    let absorbed = fit.factor().map(|f| f.solve(&cross)).unwrap_or_else(|| DMatrix::zeros(cross.nrows(), cross.ncols()));
    Scores { scores: b.tr_mul(&residual), covariance: gram - cross.tr_mul(&absorbed) }
}

impl Scores {
    /// z-score of each column on its own; 0 where calibration absorbs the column.
    pub fn each(&self, reference: &[f64]) -> Vec<f64> {
        let variance = self.covariance.diagonal();
        (0..self.scores.len())
            .map(|i| if variance[i] > 1e-8 * reference[i] { self.scores[i] / variance[i].sqrt() } else { 0.0 })
            .collect()
    }

    /// Joint chi-squared over the directions that calibration leaves.
    pub fn joint(&self) -> JointTest {
        self.subset(&(0..self.scores.len()).collect::<Vec<_>>())
    }

    /// Joint chi-squared of some columns.
    pub fn subset(&self, columns: &[usize]) -> JointTest {
        let n = columns.len();
        let scale: Vec<f64> = columns.iter().map(|c| self.covariance[(*c, *c)].max(1e-300).sqrt().recip()).collect();
        let covariance = DMatrix::from_fn(n, n, |i, j| self.covariance[(columns[i], columns[j])] * scale[i] * scale[j]);
        let scores = DVector::from_fn(n, |i, _| self.scores[columns[i]] * scale[i]);
        let eigen = SymmetricEigen::new(covariance);
        let greatest = eigen.eigenvalues.iter().copied().fold(0.0, f64::max);
        let (mut statistic, mut freedom) = (0.0, 0);
        for (value, vector) in eigen.eigenvalues.iter().zip(eigen.eigenvectors.column_iter()) {
            if *value > 1e-7 * greatest {
                statistic += vector.dot(&scores).powi(2) / value;
                freedom += 1;
            }
        }
        JointTest { statistic, freedom, p_value: upper_tail(statistic, freedom) }
    }
}

/// Probability that a chi-squared variable of `freedom` exceeds `statistic`.
pub fn upper_tail(statistic: f64, freedom: usize) -> f64 {
    ChiSquared::new(freedom.max(1) as f64).map_or(1.0, |d| d.sf(statistic))
}
