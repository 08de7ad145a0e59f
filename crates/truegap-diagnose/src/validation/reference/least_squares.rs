//! Least squares in given columns, with rows left out, from sums of products that are made once.
//!
//! Limits: directions that the rows do not tell get the coefficient 0.

use crate::stats::symmetric_eigen;
use nalgebra::{DMatrix, DVector};
use std::ops::Range;

/// Share of the largest eigenvalue, columns scaled to one size, below which a direction counts as not told.
const TOLD: f64 = 1e-10;

/// Columns, constants and a response, with their sums of products over all rows.
pub(super) struct Design<'a> {
    intercept: (Vec<usize>, usize),
    columns: Vec<Vec<f64>>,
    response: &'a [f64],
    /// taken off the response before it is squared, so that no digits are lost
    level: f64,
    sums: Sums,
}

/// Sums of products of columns with one another and with the response.
#[derive(Clone)]
struct Sums {
    gram: DMatrix<f64>,
    right: DVector<f64>,
}

impl<'a> Design<'a> {
    /// `intercept` has the number of each row's constant, and how many there are.
    pub fn new(intercept: (Vec<usize>, usize), columns: Vec<Vec<f64>>, response: &'a [f64]) -> Self {
        let level = response.iter().sum::<f64>() / response.len().max(1) as f64;
        let size = intercept.1 + columns.len();
        let empty = Sums { gram: DMatrix::zeros(size, size), right: DVector::zeros(size) };
        let mut design = Self { intercept, columns, response, level, sums: empty };
        design.sums = design.summed(std::iter::once(0..response.len()));
        design
    }

    fn row(&self, row: usize) -> DVector<f64> {
        let (constants, count) = (&self.intercept.0, self.intercept.1);
        let value = |index: usize| match index.checked_sub(count) {
            Some(column) => self.columns[column][row],
            None => f64::from(u8::from(constants[row] == index)),
        };
        DVector::from_fn(count + self.columns.len(), |index, _| value(index))
    }

    fn summed(&self, ranges: impl Iterator<Item = Range<usize>>) -> Sums {
        let size = self.intercept.1 + self.columns.len();
        let mut sums = Sums { gram: DMatrix::zeros(size, size), right: DVector::zeros(size) };
        for row in ranges.flatten() {
            let x = self.row(row);
            sums.gram.ger(1.0, &x, &x, 1.0);
            sums.right.axpy(self.response[row] - self.level, &x, 1.0);
        }
        sums
    }

    /// Coefficients of the fit without these rows.
    pub fn without(&self, rows: &[Range<usize>]) -> DVector<f64> {
        let left_out = self.summed(rows.iter().cloned());
        solved(&self.sums.gram - left_out.gram, &(&self.sums.right - left_out.right))
    }

    /// What a fit says of a row.
    pub fn predict(&self, coefficients: &DVector<f64>, row: usize) -> f64 {
        self.level + self.row(row).dot(coefficients)
    }
}

/// Least norm among the solutions, columns scaled to one size.
fn solved(gram: DMatrix<f64>, right: &DVector<f64>) -> DVector<f64> {
    let scale = gram.diagonal().map(|v| if v > 0.0 { 1.0 / v.sqrt() } else { 0.0 });
    let scaled = DMatrix::from_fn(gram.nrows(), gram.ncols(), |i, j| gram[(i, j)] * scale[i] * scale[j]);
    let eigen = symmetric_eigen(scaled);
    let largest = eigen.eigenvalues.iter().fold(0.0f64, |m, v| m.max(*v));
    let mut parts = eigen.eigenvectors.tr_mul(&right.component_mul(&scale));
    parts.iter_mut().zip(&eigen.eigenvalues).for_each(|(part, value)| {
        *part = if *value > TOLD * largest { *part / value } else { 0.0 };
    });
    (eigen.eigenvectors * parts).component_mul(&scale)
}
