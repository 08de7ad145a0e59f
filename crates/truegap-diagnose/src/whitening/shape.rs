//! A course that the noise follows with a weight not known beforehand.
//!
//! Limits: one Gaussian weight a course.

/// A whitened column s that unit white noise has been given with a weight of unit variance: its covariance is 1 + s s^T.
#[derive(Clone, Debug)]
pub(super) struct Shape {
    pub(super) column: Vec<f64>,
    /// its squared length
    pub(super) length: f64,
}

impl Shape {
    /// Applies the symmetric root of (1 + s s^T)^-1.
    pub(super) fn take_out(&self, column: &mut [f64]) {
        self.stretch(column, (1.0 + self.length).sqrt().recip());
    }

    /// Applies the symmetric root of 1 + s s^T.
    pub(super) fn put_in(&self, column: &mut [f64]) {
        self.stretch(column, (1.0 + self.length).sqrt());
    }

    /// Multiplies the part of a column along the shape by `factor`.
    fn stretch(&self, column: &mut [f64], factor: f64) {
        if self.length > 0.0 {
            let along = column.iter().zip(&self.column).map(|(c, s)| c * s).sum::<f64>() / self.length;
            column.iter_mut().zip(&self.column).for_each(|(c, s)| *c += (factor - 1.0) * along * s);
        }
    }
}
