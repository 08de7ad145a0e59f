//! Assumptions about the beads, the dielectric and the field.
//!
//! Limits: one bead stands for all; interaction with the plate's shape is in [`super::plate`].

mod beads;
mod free_bead_spread;
mod free_expansion;
mod linear_softening;
mod mixing_parallel;
mod no_fringing;
mod permittivity_constant;
mod polyimide_uniform_stress;
mod series_of_integrals;
mod tail_parallel_plate;
mod uniform_temperature;

pub(crate) use mixing_parallel::mixed_capacitance;
pub(crate) use tail_parallel_plate::{Section, edge_factor};

use crate::assumption::Assumption;

/// The list, in the order of the model's chain.
pub(crate) const ASSUMPTIONS: &[&dyn Assumption] = &[
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
