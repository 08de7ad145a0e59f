//! What the tables cover, and the materials that they were made for.
//!
//! Limits: numbers; how far the tables reach in shape and coverage stands in their files.

use crate::cell::Filled;

/// Greatest strain that the tables cover.
pub(super) const GREATEST_STRAIN: f64 = 0.3;
/// Relative permittivities for which the tables `cell_field` and `rim_field` are computed: the paper's Table 1.
pub(super) const PERMITTIVITIES: Filled = Filled { bead: 3.4, air: 1.0, film: 3.4 };
/// Poisson's ratio for which the table `cell_field` is computed: the paper's Table 1.
pub(super) const POISSON: f64 = 0.49;
/// Thermal strain over that of the plates for which the table `heated_field` is computed: the paper's silicone, 30 K warmer.
pub(super) const HEAT: f64 = 5.5e-3;

/// Radical inverse of `index` in a base, 0 to 1.
pub(super) fn halton(mut index: usize, base: usize) -> f64 {
    let (mut value, mut digit) = (0.0, 1.0 / base as f64);
    while index > 0 {
        value += digit * (index % base) as f64;
        index /= base;
        digit /= base as f64;
    }
    value
}
