//! Evidence, posterior and predictions from the covariance of all rows.

use nalgebra::{Cholesky, DMatrix, DVector, Dyn};

/// A response under `y = B z + noise`, z of unit Gaussians.
pub(super) struct Exact {
    pub(super) columns: DMatrix<f64>,
    pub(super) y: DVector<f64>,
    noise: Cholesky<f64, Dyn>,
    whole: Cholesky<f64, Dyn>,
}

fn log_determinant(factor: &Cholesky<f64, Dyn>) -> f64 {
    factor.l_dirty().diagonal().iter().map(|d| 2.0 * d.ln()).sum()
}

impl Exact {
    pub(super) fn new(noise: DMatrix<f64>, columns: DMatrix<f64>, y: DVector<f64>) -> Self {
        let whole = (&noise + &columns * columns.transpose()).cholesky().unwrap();
        Self { columns, y, noise: noise.cholesky().unwrap(), whole }
    }

    /// `ln N(y; 0, C)` over the constant of the likelihood: `ln N(0; 0, K)`.
    pub(super) fn log_evidence(&self) -> f64 {
        -self.objective() - 0.5 * (log_determinant(&self.whole) - log_determinant(&self.noise))
    }

    /// Half of the misfit and of what the numbers cost, at the most probable numbers.
    pub(super) fn objective(&self) -> f64 {
        0.5 * self.y.dot(&self.whole.solve(&self.y))
    }

    /// Most probable numbers.
    pub(super) fn mean(&self) -> DVector<f64> {
        self.columns.tr_mul(&self.whole.solve(&self.y))
    }

    /// Their covariance.
    pub(super) fn covariance(&self) -> DMatrix<f64> {
        let p = self.columns.ncols();
        DMatrix::identity(p, p) - self.columns.tr_mul(&self.whole.solve(&self.columns))
    }

    /// Score along a column, and its variance.
    pub(super) fn score(&self, column: &DVector<f64>) -> (f64, f64) {
        let along = self.whole.solve(column);
        (along.dot(&self.y), along.dot(column))
    }

    /// The same for several columns: scores and their covariance.
    pub(super) fn scores(&self, columns: &DMatrix<f64>) -> (DVector<f64>, DMatrix<f64>) {
        let along = self.whole.solve(columns);
        (along.tr_mul(&self.y), along.tr_mul(columns))
    }
}

/// Log of the mean of exponentials.
pub(super) fn log_mean(values: &[f64]) -> f64 {
    let most = values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    most + (values.iter().map(|v| (v - most).exp()).sum::<f64>() / values.len() as f64).ln()
}

/// Share of a unit normal below a point, by quadrature.
pub(super) fn below(x: f64) -> f64 {
    let steps = 200_000;
    let (low, width) = (-12.0, (x + 12.0) / f64::from(steps));
    let density = |t: f64| (-0.5 * t * t).exp() / (2.0 * std::f64::consts::PI).sqrt();
    (0..steps).map(|i| density(low + (f64::from(i) + 0.5) * width) * width).sum()
}
