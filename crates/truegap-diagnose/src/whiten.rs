//! Noise of a row: white plus first-order autoregressive, taken out exactly by a scalar Kalman filter.
//!
//! A row may stand for the mean of several rows of the recording (see [`crate::thin`]); its noise is that of the mean.
//!
//! Limits: correlation runs from row to row, whatever the time between them, and starts afresh with each run.

use std::ops::Range;

/// Standard deviations and correlation of the noise on one response, in its unit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Noise {
    /// white part
    pub white_sd: f64,
    /// stationary standard deviation of the autoregressive part
    pub ar_sd: f64,
    /// correlation of the autoregressive part from row to row
    pub ar_correlation: f64,
}

impl Noise {
    /// Variance of the autoregressive part in the mean of `rows` rows.
    fn ar_variance_of_mean(&self, rows: f64) -> f64 {
        let phi = self.ar_correlation;
        let variance = self.ar_sd * self.ar_sd;
        if rows <= 1.0 || variance == 0.0 {
            return variance;
        }
        let decay = 1.0 - phi;
        variance / rows * ((1.0 + phi) / decay - 2.0 * phi * (1.0 - phi.powf(rows)) / (rows * decay * decay))
    }
}

impl Noise {
    /// Correlation of the autoregressive parts of two neighbouring means.
    fn ar_correlation_of_means(&self, rows: f64, next: f64) -> f64 {
        let phi = self.ar_correlation;
        let decay = 1.0 - phi;
        let covariance =
            self.ar_sd * self.ar_sd * phi * (1.0 - phi.powf(rows)) * (1.0 - phi.powf(next)) / (decay * decay * rows * next);
        let variances = self.ar_variance_of_mean(rows) * self.ar_variance_of_mean(next);
        if variances > 0.0 { covariance / variances.sqrt() } else { 0.0 }
    }
}

/// A linear filter that turns noise of a known kind into unit white noise; rows that are left out come out as 0.
#[derive(Clone, Debug)]
pub struct Whitener {
    gain: Vec<f64>,
    inverse_sd: Vec<f64>,
    /// correlation with the row after
    correlation: Vec<f64>,
    runs: Vec<Range<usize>>,
    /// sum of the logarithms of the innovation variances
    pub log_determinant: f64,
    /// rows that count
    pub rows: usize,
}

impl Whitener {
    /// Filter for `noise`, with `extra_variance` (of recorded inputs, carried through the model) added row by row.
    ///
    /// `weights[row]` is the number of rows whose mean a row is (all 1 where absent); `keep[row] = false` leaves a row out.
    pub fn new(
        noise: &Noise,
        extra_variance: &[f64],
        weights: Option<&[f64]>,
        runs: &[Range<usize>],
        keep: Option<&[bool]>,
    ) -> Self {
        Self::by_run(&|_| *noise, extra_variance, weights, runs, keep)
    }

    /// As [`Whitener::new`], with the noise that `of_run` gives each run.
    pub fn by_run(
        of_run: &dyn Fn(&Range<usize>) -> Noise,
        extra_variance: &[f64],
        weights: Option<&[f64]>,
        runs: &[Range<usize>],
        keep: Option<&[bool]>,
    ) -> Self {
        let n = extra_variance.len();
        let weight = |row: usize| weights.map_or(1.0, |w| w[row]);
        let mut filter = Self {
            gain: vec![0.0; n],
            inverse_sd: vec![0.0; n],
            correlation: vec![0.0; n],
            runs: runs.to_vec(),
            log_determinant: 0.0,
            rows: 0,
        };
        for run in runs {
            let noise = &of_run(run);
            let mut predicted = noise.ar_variance_of_mean(weight(run.start));
            for row in run.clone() {
                if keep.is_none_or(|k| k[row]) {
                    let variance = predicted + (noise.white_sd * noise.white_sd + extra_variance[row]) / weight(row);
                    filter.gain[row] = predicted / variance;
                    filter.inverse_sd[row] = variance.sqrt().recip();
                    filter.log_determinant += variance.ln();
                    filter.rows += 1;
                }
                if row + 1 < run.end {
                    predicted = filter.step(noise, row, predicted, weight(row), weight(row + 1));
                }
            }
        }
        filter
    }

    /// Variance predicted for the row after, and its correlation with this row.
    fn step(&mut self, noise: &Noise, row: usize, predicted: f64, weight: f64, next: f64) -> f64 {
        let (here, there) = (noise.ar_variance_of_mean(weight), noise.ar_variance_of_mean(next));
        let phi = noise.ar_correlation_of_means(weight, next);
        self.correlation[row] = if here > 0.0 { phi * (there / here).sqrt() } else { 0.0 };
        let updated = predicted * (1.0 - self.gain[row]);
        self.correlation[row].powi(2) * updated + (1.0 - phi * phi) * there
    }

    /// Whitens a column in place.
    pub fn apply(&self, column: &mut [f64]) {
        if self.gain.iter().all(|g| *g == 0.0) {
            column.iter_mut().zip(&self.inverse_sd).for_each(|(x, w)| *x *= w);
            return;
        }
        for run in &self.runs {
            let mut state = 0.0;
            for row in run.clone() {
                let innovation = column[row] - state;
                column[row] = innovation * self.inverse_sd[row];
                state = self.correlation[row] * (state + self.gain[row] * innovation);
            }
        }
    }

    /// Sum of the logarithms of the innovation variances plus squares of a whitened column: minus twice the log likelihood, up to a constant.
    pub fn deviance(&self, whitened: &[f64]) -> f64 {
        self.log_determinant + whitened.iter().map(|v| v * v).sum::<f64>()
    }
}

#[cfg(test)]
#[allow(clippy::single_range_in_vec_init)]
mod tests {
    use super::*;
    use nalgebra::{DMatrix, DVector};

    #[test]
    fn the_filter_equals_the_dense_covariance() {
        let noise = Noise { white_sd: 0.7, ar_sd: 1.3, ar_correlation: 0.8 };
        let extra: Vec<f64> = (0..12).map(|i| 0.05 * f64::from(i)).collect();
        let x: Vec<f64> = (0..12).map(|i| f64::from(i).sin()).collect();
        let covariance = DMatrix::from_fn(12, 12, |i, j| {
            let same_run = (i < 5) == (j < 5);
            let lag = (i as f64 - j as f64).abs();
            let ar = if same_run { 1.69 * 0.8f64.powf(lag) } else { 0.0 };
            ar + if i == j { 0.49 + extra[i] } else { 0.0 }
        });
        let dense = covariance.clone().cholesky().unwrap();
        let v = DVector::from_column_slice(&x);
        let quadratic = v.dot(&dense.solve(&v));
        let filter = Whitener::new(&noise, &extra, None, &[0..5, 5..12], None);
        let mut w = x;
        filter.apply(&mut w);
        approx::assert_relative_eq!(w.iter().map(|a| a * a).sum::<f64>(), quadratic, max_relative = 1e-12);
        approx::assert_relative_eq!(filter.log_determinant, covariance.determinant().ln(), max_relative = 1e-10);
    }

    #[test]
    fn a_row_left_out_carries_no_weight() {
        let noise = Noise { white_sd: 0.7, ar_sd: 1.3, ar_correlation: 0.8 };
        let keep = [true, true, false, true];
        let filter = Whitener::new(&noise, &[0.0; 4], None, &[0..4], Some(&keep));
        let (mut a, mut b) = (vec![1.0, 2.0, 3.0, 4.0], vec![1.0, 2.0, -50.0, 4.0]);
        filter.apply(&mut a);
        filter.apply(&mut b);
        assert_eq!(a, b);
        assert_eq!(a[2], 0.0);
    }
}
