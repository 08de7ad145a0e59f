//! What a sensor would have read without the physics that was added to its model: readings corrected row by row.
//!
//! Limits: the input of the base model is estimated from the reading alone, so a base model that turns back, or answers one row by another, is not inverted.
//!
//! ```
//! use truegap_diagnose::compensation::{Inverse, Limits, Models, compensated};
//!
//! // the sensor reads 2 x + 1, and 0.5 at rest that the heat adds
//! let models: Models<'_, ()> = Models {
//!     base: &|x| Ok(x.iter().map(|x| 2.0 * x + 1.0).collect()),
//!     augmented: &|x| Ok(x.iter().map(|x| 2.0 * x + 1.5).collect()),
//! };
//! let inverse = Inverse::straight(&models, 2, 1.0)?;
//! let found = compensated(&[3.5, 5.5], &models, &inverse, &Limits::of(0.01))?;
//! assert_eq!((found.corrected, found.input), (vec![3.0, 5.0], vec![1.0, 2.0]));
//! # Ok::<(), ()>(())
//! ```

mod inverse;
mod iteration;
#[cfg(test)]
mod tests;

pub use inverse::{Inverse, Span};
pub use iteration::{Compensated, Limits, Stopped, compensated};

/// A model of readings, one a row, from the input that is to be estimated; everything else that it follows is known and held inside.
pub type Reading<'a, E> = dyn Fn(&[f64]) -> Result<Vec<f64>, E> + 'a;

/// The two models of one sensor, at the same calibration.
pub struct Models<'a, E> {
    /// without the added physics; a row's reading follows from the input of that row
    pub base: &'a Reading<'a, E>,
    /// with it
    pub augmented: &'a Reading<'a, E>,
}

/// Root mean square of a column; 0 of none.
fn rms(column: impl Iterator<Item = f64> + Clone) -> f64 {
    let rows = column.clone().count().max(1) as f64;
    (column.map(|value| value * value).sum::<f64>() / rows).sqrt()
}
