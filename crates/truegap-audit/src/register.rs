//! The register: every assumption by its stable name.
//!
//! Limits: ids never change their meaning.

use crate::{
    assumption::Assumption,
    assumptions::{cell, plate},
    error::AuditError,
};

/// Every assumption, in the order of the model's chain: beads and field first, then the plate.
pub fn register() -> Vec<&'static dyn Assumption> {
    cell::ASSUMPTIONS.iter().chain(plate::ASSUMPTIONS).copied().collect()
}

/// The assumptions of these names, in the order of the register; all of them where none is named.
///
/// # Errors
/// [`AuditError::Unknown`] names the register.
pub fn chosen(names: &[String]) -> Result<Vec<&'static dyn Assumption>, AuditError> {
    let all = register();
    if let Some(id) = names.iter().find(|name| all.iter().all(|a| a.id() != name.as_str())) {
        let known = all.iter().map(|a| a.id()).collect::<Vec<_>>().join(", ");
        return Err(AuditError::Unknown { id: id.clone(), known });
    }
    Ok(all.into_iter().filter(|a| names.is_empty() || names.iter().any(|name| name == a.id())).collect())
}
