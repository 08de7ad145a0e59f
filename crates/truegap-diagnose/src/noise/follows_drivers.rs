//! What of a misfit follows the recorded drivers, taken out before noise is read from it.
//!
//! Limits: least squares on smooth laws of size, way and speed of each driver; without drivers, nothing.

use crate::{
    effects::memory::{play, rates},
    noise::tuning::{BESIDE, DRIVER_WIDTHS},
    stats::spread,
};
use nalgebra::{DMatrix, DVector};
use std::ops::Range;
use truegap_core::Inputs;

/// Ridge against columns that are alike, over the mean square of a column.
const RIDGE: f64 = 1e-9;

/// The misfit without what follows the drivers. A reading that changes where a driver turns does so within a short stretch, and would pass for noise that lasts.
pub(crate) fn without_what_follows_drivers(inputs: &Inputs, mut misfit: Vec<f64>) -> Vec<f64> {
    let columns: Vec<Vec<f64>> = inputs.drivers.iter().flat_map(|driver| laws(inputs, &driver.values)).collect();
    if columns.is_empty() || misfit.len() <= 4 * columns.len() {
        return misfit;
    }
    let rows = misfit.len();
    let all = DMatrix::from_fn(rows, columns.len() + 1, |row, k| columns.get(k).map_or(1.0, |column| column[row]));
    let Some(shares) = least_squares(&all, &misfit) else { return misfit };
    let followed = &all * shares;
    misfit.iter_mut().zip(followed.iter()).for_each(|(left, followed)| *left -= followed);
    misfit
}

/// A misfit without its shares of `columns`, which are those that fit best from row to row: beside the means of the rows about each.
pub(crate) fn without(columns: &[Vec<f64>], misfit: &[f64], runs: &[Range<usize>]) -> Vec<f64> {
    let quick = |column: &[f64]| {
        let mut left = column.to_vec();
        for run in runs {
            for row in run.clone() {
                let about = &column[row.saturating_sub(BESIDE).max(run.start)..(row + 1 + BESIDE).min(run.end)];
                left[row] -= about.iter().sum::<f64>() / about.len() as f64;
            }
        }
        left
    };
    let moving: Vec<(f64, Vec<f64>)> = columns.iter().map(|column| (spread(column), quick(column))).collect();
    let all = DMatrix::from_fn(misfit.len(), columns.len(), |row, k| moving[k].1[row] / moving[k].0.max(f64::MIN_POSITIVE));
    let Some(shares) = least_squares(&all, &quick(misfit)) else { return misfit.to_vec() };
    let mut left = misfit.to_vec();
    for ((column, (size, _)), share) in columns.iter().zip(&moving).zip(shares.iter()).filter(|((_, (size, _)), _)| *size > 0.0) {
        left.iter_mut().zip(column).for_each(|(left, value)| *left -= share * value / size);
    }
    left
}

/// Shares of columns of order 1 in a target, with a ridge against columns that are alike.
fn least_squares(columns: &DMatrix<f64>, target: &[f64]) -> Option<DVector<f64>> {
    let mut normal = columns.tr_mul(columns);
    for k in 0..normal.nrows() {
        normal[(k, k)] += RIDGE * columns.nrows() as f64;
    }
    Some(normal.cholesky()?.solve(&columns.tr_mul(&DVector::from_column_slice(target))))
}

/// Size, way and speed of a driver or another column, each of order 1.
pub(crate) fn laws(inputs: &Inputs, column: &[f64]) -> Vec<Vec<f64>> {
    let range = spread(column);
    if range <= 0.0 {
        return Vec::new();
    }
    let low = column.iter().copied().fold(f64::INFINITY, f64::min);
    let x: Vec<f64> = column.iter().map(|v| 2.0 * (v - low) / range - 1.0).collect();
    let mut list: Vec<Vec<f64>> = (1..=3).map(|order| x.iter().map(|x| x.powi(order)).collect()).collect();
    for width in DRIVER_WIDTHS.map(|share| 2.0 * share) {
        let held = play(inputs, width, &x, |first| first);
        list.push(x.iter().zip(&held).map(|(x, held)| (x - held) / width).collect());
    }
    let mut speed = rates(inputs.time_s.as_deref(), &x, &inputs.runs());
    let largest = speed.iter().fold(0.0, |most: f64, v| most.max(v.abs())).max(f64::MIN_POSITIVE);
    speed.iter_mut().for_each(|v| *v /= largest);
    list.push(speed);
    list
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::stats::rms;
    use truegap_core::Driver;

    #[test]
    fn friction_is_taken_out_and_noise_is_left() {
        let x: Vec<f64> = (0..2000).map(|i| 20.0 * (f64::from(i) / 60.0).sin()).collect();
        let noise: Vec<f64> = (0..2000).map(|i| 0.1 * (1.7 * f64::from(i * i % 997)).sin()).collect();
        let drivers = vec![Driver { name: "position".into(), unit: "mm".into(), values: x.clone() }];
        let inputs =
            Inputs { time_s: Some((0..2000).map(f64::from).collect()), run: vec![1; 2000], drivers, ..Inputs::default() };
        let held = play(&inputs, 0.5, &x, |first| first);
        let misfit = (0..2000).map(|row| 7.0 * (x[row] - held[row]) / 0.5 + noise[row]).collect();
        let left = without_what_follows_drivers(&inputs, misfit);
        let size = |column: &[f64]| rms(column.iter().copied());
        // the play's width is none of those tried: a twentieth of the 7 may be left, not the 7
        assert!(size(&left) > 0.9 * size(&noise) && size(&left) < 0.45, "{} of {}", size(&left), size(&noise));
    }

    #[test]
    fn without_drivers_a_misfit_stays_as_it_is() {
        let inputs = Inputs { run: vec![1; 30], ..Inputs::default() };
        let misfit: Vec<f64> = (0..30).map(f64::from).collect();
        assert_eq!(without_what_follows_drivers(&inputs, misfit.clone()), misfit);
    }
}
