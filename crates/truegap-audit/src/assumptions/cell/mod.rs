//! Assumptions about the beads, the dielectric and the field.
//!
//! Limits: one bead stands for all; interaction with the plate's shape is in [`super::plate`].

mod free_bead_spread;
mod free_expansion;
mod linear_softening;
mod mixing_parallel;
mod no_fringing;
mod permittivity_constant;
mod polyimide_uniform_stress;
mod series_of_integrals;
pub mod tail_parallel_plate;
mod uniform_temperature;

pub(crate) use mixing_parallel::{filled, mixed_capacitance};

use crate::{Assumption, AuditError, Study, Swap};
use truegap_core::{Sensor, sensor::Filling};

/// The list, in the order of the model's chain.
pub const ASSUMPTIONS: &[&dyn Assumption] = &[
    &uniform_temperature::UniformTemperature,
    &free_expansion::FreeExpansion,
    &linear_softening::LinearSoftening,
    &free_bead_spread::FreeBeadSpread,
    &polyimide_uniform_stress::PolyimideUniformStress,
    &permittivity_constant::PermittivityConstant,
    &mixing_parallel::MixingParallel,
    &series_of_integrals::SeriesOfIntegrals,
    &no_fringing::NoFringing,
    &tail_parallel_plate::TailParallelPlate,
];

/// Whether a sensor has beads.
fn needs_beads(sensor: &Sensor) -> Result<(), String> {
    match sensor.dielectric.filling {
        Filling::Beads { .. } => Ok(()),
        Filling::Solid { .. } => Err("the dielectric is solid, without beads".into()),
    }
}

/// The greatest strain that the analytic model knows in the range of a study.
fn greatest_strain(study: &Study<'_>) -> Result<f64, AuditError> {
    let chain = study.chain(Swap::none());
    let strain = |temperature| Ok::<f64, AuditError>(chain.row(study.full_n(), temperature)?.squeeze.strain);
    Ok(strain(study.options.cold_c)?.max(strain(study.options.hot_c)?))
}
