//! Values on two meshes, the second twice as fine each way.
//!
//! The difference is an estimate of the coarse value's error and so, on the safe side, of the fine one's.

use super::fineness::Fineness;
use crate::error::AuditError;

/// A result on the finer mesh and how far a number of it moved.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Refined<T> {
    /// result on the finer mesh
    pub result: T,
    /// the number
    pub value: f64,
    /// its difference to the coarser mesh, magnitude
    pub error: f64,
}

/// Computes on both meshes; `number` is what the error is wanted of.
///
/// # Errors
/// What `compute` refuses.
pub(crate) fn refined<T>(
    compute: impl Fn(Fineness) -> Result<T, AuditError>,
    number: impl Fn(&T) -> f64,
) -> Result<Refined<T>, AuditError> {
    let coarse = number(&compute(Fineness::COARSE)?);
    let result = compute(Fineness::FINE)?;
    let value = number(&result);
    Ok(Refined { result, value, error: (value - coarse).abs() })
}
