//! What carries the disc: nothing, a layer, or rings of beads.
//!
//! Limits: beads are rings, each in the middle of its zone and covering the same share of it.

/// What lies between the electrode and what carries it.
#[derive(Clone, Debug, PartialEq)]
pub enum Gap {
    /// nothing: a free plate
    None,
    /// one layer of this height (m)
    Layer(f64),
    /// rings of beads, air between them
    Rings {
        /// height, m
        height: f64,
        /// share of each zone that the ring covers
        coverage: f64,
        /// number of zones
        zones: usize,
    },
}

/// A ring of beads.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ring {
    /// inner radius, m
    pub inner: f64,
    /// outer radius, m
    pub outer: f64,
}

/// Rings in the middle of their zones, which have the same width: each covers the same share of its zone.
pub(crate) fn rings(gap: &Gap, radius: f64) -> Vec<Ring> {
    let Gap::Rings { coverage, zones, .. } = gap else { return Vec::new() };
    let zone = radius / *zones as f64;
    let ring = |j: usize| {
        let middle = (j as f64 + 0.5) * zone;
        Ring { inner: middle - 0.5 * coverage * zone, outer: middle + 0.5 * coverage * zone }
    };
    (0..*zones).map(ring).collect()
}
