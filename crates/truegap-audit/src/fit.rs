//! Smooth curves through computed points: least squares in Chebyshev polynomials.
//!
//! Limits: one variable, a closed range; asked outside of it, a curve refuses.

use crate::error::AuditError;
use serde::{Deserialize, Serialize};

/// A polynomial over a closed range, in Chebyshev form.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(crate) struct Chebyshev {
    /// lower end of the range
    pub low: f64,
    /// upper end of the range
    pub high: f64,
    /// coefficients of T0, T1, ...
    pub coefficients: Vec<f64>,
}

impl Chebyshev {
    /// The polynomial of a degree nearest to the points `(x, y)` in the sense of least squares.
    ///
    /// # Errors
    /// [`AuditError::OutOfRange`] where there are too few points for the degree, or they do not lie in the range.
    pub(crate) fn fit(points: &[(f64, f64)], degree: usize, low: f64, high: f64) -> Result<Self, AuditError> {
        let size = degree + 1;
        if points.len() < size {
            let (value, most) = (points.len() as f64, f64::INFINITY);
            let remedy = "compute more points or fit a lower degree";
            return Err(AuditError::OutOfRange {
                what: "number of points of a fit",
                value,
                low: size as f64,
                high: most,
                remedy,
            });
        }
        let mut curve = Self { low, high, coefficients: Vec::new() };
        let mut normal = vec![vec![0.0; size + 1]; size];
        for &(x, y) in points {
            let t = polynomials(curve.reduced(x)?, size);
            for i in 0..size {
                (0..size).for_each(|j| normal[i][j] += t[i] * t[j]);
                normal[i][size] += t[i] * y;
            }
        }
        curve.coefficients = solve(normal);
        Ok(curve)
    }

    /// Position in the range, -1 to 1.
    fn reduced(&self, x: f64) -> Result<f64, AuditError> {
        let slack = 1e-9 * (self.high - self.low);
        if !(x >= self.low - slack && x <= self.high + slack) {
            let remedy = "audit a smaller range of loads or temperatures";
            return Err(AuditError::OutOfRange {
                what: "argument of a fitted curve",
                value: x,
                low: self.low,
                high: self.high,
                remedy,
            });
        }
        Ok((2.0 * x - self.low - self.high) / (self.high - self.low))
    }

    /// Value at `x`.
    ///
    /// # Errors
    /// [`AuditError::OutOfRange`] outside of the range.
    pub(crate) fn at(&self, x: f64) -> Result<f64, AuditError> {
        let t = self.reduced(x)?;
        // Clenshaw's recurrence
        let (mut next, mut after) = (0.0, 0.0);
        for c in self.coefficients.iter().skip(1).rev() {
            (next, after) = (c + 2.0 * t * next - after, next);
        }
        Ok(self.coefficients.first().copied().unwrap_or(0.0) + t * next - after)
    }

    /// Largest distance from the points.
    ///
    /// # Errors
    /// [`AuditError::OutOfRange`] where a point lies outside of the range.
    pub(crate) fn misfit(&self, points: &[(f64, f64)]) -> Result<f64, AuditError> {
        points.iter().try_fold(0.0, |worst: f64, &(x, y)| Ok(worst.max((self.at(x)? - y).abs())))
    }
}

/// T0 to T(count - 1) at a reduced position.
pub(crate) fn polynomials(x: f64, count: usize) -> Vec<f64> {
    let mut t = vec![1.0, x];
    while t.len() < count {
        let n = t.len();
        t.push(2.0 * x * t[n - 1] - t[n - 2]);
    }
    t.truncate(count);
    t
}

/// Solves a small system given as rows `[matrix | right side]`, by elimination with row exchange.
pub(crate) fn solve(mut rows: Vec<Vec<f64>>) -> Vec<f64> {
    let n = rows.len();
    for k in 0..n {
        let pivot = (k..n).max_by(|&a, &b| rows[a][k].abs().total_cmp(&rows[b][k].abs())).unwrap_or(k);
        rows.swap(k, pivot);
        let row = rows[k].clone();
        for lower in rows.iter_mut().skip(k + 1) {
            let factor = lower[k] / row[k];
            lower.iter_mut().zip(&row).skip(k).for_each(|(a, b)| *a -= factor * b);
        }
    }
    let mut x = vec![0.0; n];
    for k in (0..n).rev() {
        let known: f64 = (k + 1..n).map(|j| rows[k][j] * x[j]).sum();
        x[k] = (rows[k][n] - known) / rows[k][k];
    }
    x
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_polynomial_is_found_again_and_nothing_is_said_outside_of_the_range() {
        let cubic = |x: f64| 1.0 - 2.0 * x + 0.3 * x * x * x;
        let points: Vec<(f64, f64)> = (0..9).map(|i| 0.5 + 0.25 * f64::from(i)).map(|x| (x, cubic(x))).collect();
        let curve = Chebyshev::fit(&points, 3, 0.5, 2.5).unwrap();
        for x in [0.5, 0.77, 1.9, 2.5] {
            assert!((curve.at(x).unwrap() - cubic(x)).abs() < 1e-12);
        }
        assert!(curve.misfit(&points).unwrap() < 1e-12);
        assert!(Chebyshev::fit(&points, 2, 0.5, 2.5).unwrap().misfit(&points).unwrap() > 1e-3);
        assert!(matches!(curve.at(2.6), Err(AuditError::OutOfRange { .. })));
        assert!(Chebyshev::fit(&points[..3], 3, 0.5, 2.5).is_err());
    }
}
