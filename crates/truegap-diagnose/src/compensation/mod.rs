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
mod models;
#[cfg(test)]
mod tests;

pub use inverse::{Inverse, Span};
pub use iteration::{Compensated, Limits, Stopped, compensated};
pub use models::{Models, Reading};
