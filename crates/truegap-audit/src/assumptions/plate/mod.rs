//! Assumptions about the warping and bending electrode.
//!
//! Limits: beads act as an elastic layer; their own mechanics is in [`super::cell`].

mod beads_do_not_hold;
mod bimetal_strip;
mod insulator_expands_freely;
mod layers_outside_ignored;
mod rigid_plates;
mod small_deflection;
mod spherical_stable;
mod warp;
mod warp_under_load;

use crate::assumption::Assumption;

/// The list, in the order of the model's chain.
pub(crate) const ASSUMPTIONS: &[&dyn Assumption] = &[
    &bimetal_strip::BimetalStrip,
    &small_deflection::SmallDeflection,
    &spherical_stable::SphericalStable,
    &layers_outside_ignored::LayersOutsideIgnored,
    &insulator_expands_freely::InsulatorExpandsFreely,
    &beads_do_not_hold::BeadsDoNotHold,
    &warp_under_load::WarpUnderLoad,
    &rigid_plates::RigidPlates,
];
