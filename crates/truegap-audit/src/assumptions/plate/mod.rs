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

pub use beads_do_not_hold::BeadsDoNotHold;
pub use bimetal_strip::BimetalStrip;
pub use insulator_expands_freely::InsulatorExpandsFreely;
pub use layers_outside_ignored::LayersOutsideIgnored;
pub use rigid_plates::RigidPlates;
pub use small_deflection::SmallDeflection;
pub use spherical_stable::SphericalStable;
pub use warp_under_load::WarpUnderLoad;

use crate::Assumption;

/// The list, in the order of the model's chain.
pub const ASSUMPTIONS: &[&dyn Assumption] = &[
    &BimetalStrip,
    &SmallDeflection,
    &SphericalStable,
    &LayersOutsideIgnored,
    &InsulatorExpandsFreely,
    &BeadsDoNotHold,
    &WarpUnderLoad,
    &RigidPlates,
];
