//! Plates of unknown size, flat until something bends or tilts them.
//!
//! Limits: what bends and tilts them is for the stages to say; what it does to the reading, for [`crate::stack`].

use truegap_core::{Drive, Geometry};

/// Flat, parallel plates at a strain.
pub(super) fn flat<'a>(strain: &'a [f64], drive: &Drive<'_>) -> Geometry<'a> {
    let rows = strain.len();
    Geometry {
        strain,
        gap: vec![0.0; rows],
        warp_kelvin: drive.temperature_c.iter().map(|t| t - drive.reference_c).collect(),
        warp_factor: 0.0,
        tilt: vec![0.0; rows],
        sag: vec![0.0; rows],
    }
}
