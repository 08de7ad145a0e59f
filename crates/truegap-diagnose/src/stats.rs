//! Numbers that every stage needs: spread, median, resolution, errors, tails of distributions.
//!
//! Limits: plain columns of numbers; knows no recording.

use nalgebra::{DMatrix, DVector, Dyn, SymmetricEigen};
use statrs::distribution::{ChiSquared, ContinuousCDF};
use statrs::function::erf::erfc;
use std::ops::Range;
use truegap_core::ends;

pub use truegap_core::{MEDIAN_NORMAL, median, sd_of_differences};

/// Greatest less least.
pub fn spread(x: &[f64]) -> f64 {
    let (low, high) = ends(x.iter().copied());
    high - low
}

/// Smallest difference between two neighbouring values of a column; 0 where all are equal.
pub fn resolution(column: &[f64]) -> f64 {
    let greatest = column.iter().fold(0.0f64, |m, v| m.max(v.abs()));
    let differences = column.windows(2).map(|w| (w[1] - w[0]).abs()).filter(|d| *d > 1e-12 * greatest);
    let least = differences.fold(f64::INFINITY, f64::min);
    if least.is_finite() { least } else { 0.0 }
}

/// Smallest difference between any two values of a column, or between any two of its changes from row to row; 0 where all are equal. What is read in steps changes by whole steps as well: a column that climbs
/// goes by many of them from row to row, and comes to no value twice.
pub fn finest_step(column: &[f64]) -> f64 {
    let greatest = column.iter().fold(0.0f64, |m, v| m.max(v.abs()));
    let least_gap = |mut values: Vec<f64>| {
        values.sort_by(f64::total_cmp);
        let gaps = values.windows(2).map(|w| w[1] - w[0]).filter(|gap| *gap > 1e-12 * greatest);
        gaps.fold(f64::INFINITY, f64::min)
    };
    let least = least_gap(column.to_vec()).min(least_gap(column.windows(2).map(|w| w[1] - w[0]).collect()));
    if least.is_finite() { least } else { 0.0 }
}

/// Root mean square of a column; 0 of none.
pub fn rms(column: impl Iterator<Item = f64> + Clone) -> f64 {
    let rows = column.clone().count().max(1) as f64;
    let squares = |unit: f64| column.clone().map(|value| (value / unit).powi(2)).sum::<f64>() / rows;
    let plain = squares(1.0).sqrt();
    if plain.is_finite() {
        return plain;
    }
    // squares of what is itself a number
    let greatest = column.clone().fold(0.0f64, |most, value| most.max(value.abs()));
    if greatest.is_finite() { greatest * squares(greatest).sqrt() } else { plain }
}

/// Root-mean-square distance of a column from its mean; 0 of none.
pub fn deviation(column: &[f64]) -> f64 {
    let mean = column.iter().sum::<f64>() / column.len().max(1) as f64;
    rms(column.iter().map(|value| value - mean))
}

/// Root-mean-square error of each of two predictions over the rows of `rows` that both predict; a row without a prediction is NaN. `None` where there is no such
/// row: an error over no rows is no error of 0.
pub fn rmse_of_both(predictions: [&[f64]; 2], response: &[f64], rows: Range<usize>) -> Option<[f64; 2]> {
    let error = |prediction: &[f64], row: usize| (prediction[row] - response[row]).powi(2);
    let both = |row: usize| predictions.map(|p| error(p, row));
    let squares: Vec<[f64; 2]> = rows.map(both).filter(|s| s.iter().all(|square| square.is_finite())).collect();
    let mean = |k: usize| (squares.iter().map(|s| s[k]).sum::<f64>() / squares.len() as f64).sqrt();
    (!squares.is_empty()).then(|| [mean(0), mean(1)])
}

/// Root-mean-square error of a prediction of every row; `None` where there are no rows.
pub fn rmse(prediction: &[f64], response: &[f64], rows: Range<usize>) -> Option<f64> {
    rmse_of_both([prediction, prediction], response, rows).map(|[error, _]| error)
}

/// Share of a root-mean-square error above the noise `floor` that is removed, `1 - (after^2 - floor^2) / (before^2 - floor^2)`.
pub fn share_removed(before: f64, after: f64, floor: f64) -> f64 {
    1.0 - (after * after - floor * floor) / (before * before - floor * floor).max(f64::MIN_POSITIVE)
}

/// Probability that a chi-squared variable of `freedom` exceeds `statistic`.
pub fn upper_tail(statistic: f64, freedom: usize) -> f64 {
    ChiSquared::new(freedom.max(1) as f64).map_or(1.0, |d| d.sf(statistic))
}

/// Logarithm of [`upper_tail`] for an even number of degrees of freedom, `half` of them, also where the probability itself is too small for a number.
///
/// **Source:** the sum of a Poisson distribution, NIST Digital Library of Mathematical Functions, 8.4.10. **Accuracy:** 1e-9, `logarithms_of_tails_are_those_of_the_tails`.
pub fn log_upper_tail(statistic: f64, half: usize) -> f64 {
    let mean = 0.5 * statistic;
    let mut term = 0.0;
    let terms = (0..half.max(1)).map(|k| {
        term += if k > 0 { (mean / k as f64).ln() } else { 0.0 };
        term
    });
    (log_sum_exp(&terms.collect::<Vec<_>>()) - mean).min(0.0)
}

/// Squared amplitude, in units of the noise variance, of a periodic part that has this p-value: `-2 ln p`.
///
/// **Source:** the power of noise at one frequency is exponential, Scargle, Astrophys. J. 263 (1982) 835.
pub fn excess_of(p_value: f64) -> f64 {
    -2.0 * p_value.max(f64::MIN_POSITIVE).ln()
}

/// Eigenvalues and eigenvectors of a symmetric matrix; none of a matrix without rows, as a model without parameters or a test without directions has it.
pub fn symmetric_eigen(matrix: DMatrix<f64>) -> SymmetricEigen<f64, Dyn> {
    if matrix.is_empty() {
        return SymmetricEigen { eigenvectors: matrix, eigenvalues: DVector::zeros(0) };
    }
    SymmetricEigen::new(matrix)
}

/// Log of the sum of exponentials.
pub fn log_sum_exp(values: &[f64]) -> f64 {
    let greatest = values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    if greatest == f64::NEG_INFINITY {
        return greatest;
    }
    greatest + values.iter().map(|v| (v - greatest).exp()).sum::<f64>().ln()
}

/// Log of the mean of exponentials.
pub fn log_mean_exp(values: &[f64]) -> f64 {
    log_sum_exp(values) - (values.len() as f64).ln()
}

/// Probability of a unit normal between two points.
pub fn normal_between(low: f64, high: f64) -> f64 {
    let upper_tail = |x: f64| 0.5 * erfc(x / std::f64::consts::SQRT_2);
    if low > 0.0 { upper_tail(low) - upper_tail(high) } else { upper_tail(-high) - upper_tail(-low) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_finest_step_of_a_column_that_climbs_is_that_of_what_is_read() {
        // a sawtooth of 17 steps a row, and a ramp of 300 and a few
        let saw: Vec<f64> = (0..300).map(|row| 0.5 * f64::from(17 * row % 240)).collect();
        assert_eq!((resolution(&saw), finest_step(&saw)), (8.5, 0.5));
        let ramp: Vec<f64> = (0..300).map(|row| 0.5 * f64::from(300 * row + row * row % 7)).collect();
        assert_eq!((resolution(&ramp), finest_step(&ramp)), (148.5, 0.5));
        assert_eq!(finest_step(&[3.0; 4]), 0.0);
    }

    #[test]
    fn logarithms_of_tails_are_those_of_the_tails() {
        for half in [1, 4, 12] {
            for statistic in [0.5, 8.0, 30.0, 400.0] {
                let (log, tail) = (log_upper_tail(statistic, half), upper_tail(statistic, 2 * half));
                approx::assert_relative_eq!(log, tail.ln(), max_relative = 1e-9, epsilon = 1e-12);
            }
        }
        // of two degrees of freedom it is exponential
        assert_eq!(log_upper_tail(1e6, 1), -5e5);
        assert!(log_upper_tail(0.0, 4).abs() < 1e-12);
    }
}
