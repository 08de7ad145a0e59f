//! Units under `[units]` of roles that no column plays: who gave them thinks that one does.
//!
//! Limits: a reading may be absent where nothing but what was done is asked for, so its unit is passed over.

use super::{default_names::dimension, manifest::Manifest, note::Note};
use crate::inputs::Role;
use crate::units::UnitError;

/// A note of such units; `found` are the roles that have a column.
///
/// # Errors
/// Role, line and reason of one that is no unit of its role.
pub(super) fn units_of_nothing(manifest: &Manifest, found: &[(Role, usize)]) -> Result<Option<Note>, (Role, usize, UnitError)> {
    let is_idle = |role: &Role| *role != Role::Response && found.iter().all(|(of, _)| of != role);
    let idle: Vec<_> = manifest.units.iter().filter(|(role, _)| is_idle(role)).collect();
    for (role, given) in &idle {
        let scale = dimension(**role).map(|dimension| dimension.scale(&given.text));
        scale.transpose().map_err(|source| (**role, given.line, source))?;
    }
    let roles: Vec<&str> = idle.iter().map(|(role, _)| role.key()).collect();
    Ok((!roles.is_empty()).then(|| Note::UnitsOfNothing { roles: roles.join(", ") }))
}
