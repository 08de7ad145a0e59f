//! Score tests of a fitted model along given directions, with its own parameters and priors taken out.
//!
//! At a MAP point with whitened residual r and Jacobian J, `(1 + J J^T)^-1` applied to the linearised data is r itself, so the score along b is
//! `b . r` and its variance `b . b - (J^T b)^T (J^T J + 1)^-1 (J^T b)`.
//!
//! **Source:** Rao, Math. Proc. Camb. Phil. Soc. 44 (1948) 50 (the score test); priors as further rows of the Jacobian are derived here.
//!
//! Limits: linear about the fit.

use crate::{
    fit::optimum::Linearised,
    stats::{symmetric_eigen, upper_tail},
};
use nalgebra::{DMatrix, DVector};

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
pub fn scores(linearised: &Linearised, b: &DMatrix<f64>) -> Scores {
    scores_with(linearised, b, &b.tr_mul(b))
}

/// As [`scores`], `gram` being `b^T b`: for the same columns beside many fits.
pub fn scores_with(linearised: &Linearised, b: &DMatrix<f64>, gram: &DMatrix<f64>) -> Scores {
    let taken = linearised.taken.tr_mul(b);
    Scores { scores: b.tr_mul(&linearised.residual), covariance: gram - taken.tr_mul(&taken) }
}

impl Scores {
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
        let eigen = symmetric_eigen(covariance);
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fit::model::Kinds;
    use crate::fit::optimum::finish;

    /// Two parameters that do nearly the same, each known from the data to a millionth of what is known beforehand: along their common column
    /// `B^2 (1 + d^2) / (1 + 2 S^2 + d^2 + S^2 d^2)` is left, the entry of `(1 + J J^T)^-1` for J = [[S, S], [0, d]].
    #[test]
    fn what_calibration_leaves_of_a_column_along_a_sloppy_direction_is_not_lost_in_rounding() {
        let (s, d, b) = (1e6, 1e-2, 1e6);
        let jacobian = DMatrix::from_row_slice(2, 2, &[s, s, 0.0, d]);
        let free = [(f64::NEG_INFINITY, f64::INFINITY); 2];
        // at the optimum J^T r = z
        let residual = vec![30.0 / s, -10.0 / d];
        let linearised = finish(vec![30.0, 20.0], residual, jacobian, &free, Kinds::default(), (1, true)).linearised();
        assert!(linearised.is_reached());
        let found = scores(&linearised, &DMatrix::from_column_slice(2, 1, &[b, 0.0]));
        let left = b * b * (1.0 + d * d) / (1.0 + 2.0 * s * s + d * d + s * s * d * d);
        // rounding of B^2 = 1e12 in double precision, 1e-4
        assert!((found.covariance[(0, 0)] - left).abs() < 1e-3, "{} {left}", found.covariance[(0, 0)]);
        assert!((found.scores[0] - 30.0).abs() < 1e-3, "{}", found.scores[0]);
    }
}
