//! What assumptions about beads ask of a sensor and of its study.
//!
//! Limits: the strain is that of the analytic chain.

use crate::{error::AuditError, study::Study, swap::Swap};
use truegap_core::{Sensor, sensor::Filling};

/// Whether a sensor has beads.
pub(super) fn needs_beads(sensor: &Sensor) -> Result<(), String> {
    match sensor.dielectric.filling {
        Filling::Beads { .. } => Ok(()),
        Filling::Solid { .. } => Err("the dielectric is solid, without beads".into()),
    }
}

/// The greatest strain that the analytic model knows in the range of a study.
pub(super) fn greatest_strain(study: &Study<'_>) -> Result<f64, AuditError> {
    let chain = study.chain(Swap::none());
    let strain = |temperature| Ok::<f64, AuditError>(chain.row(study.full_n(), temperature)?.squeeze.strain);
    Ok(strain(study.options.cold_c)?.max(strain(study.options.hot_c)?))
}
