//! Permittivity of a mixed layer and the capacitances of a sensor: (20)-(23).
//!
//! Limits: layers side by side (20) and in series (21), no edge field; (19) is in [`super::integral`].

use super::{integral::BentPlates, plates::plate_capacitance, thermal::Areas};

/// Permittivities of what fills one layer, both relative or both in F/m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fillings {
    /// of the solid part
    pub solid: f64,
    /// of what is between
    pub surrounding: f64,
}

/// Mean permittivity of beads and air side by side.
///
/// $$ \epsilon = \frac{\epsilon_{silicone} A_{silicone} + \epsilon_{air} A_{air}}{A_{electrode}} $$
///
/// | symbol | argument        | unit |
/// |--------|-----------------|------|
/// | ε      | `permittivities` | any, that of the result |
/// | A      | `areas`         | m²   |
///
/// **Source:** \[hampson2023\] (20), with the bead area as spread by the load (11). **Assumes:** `PARALLEL-MIXING`. **Accuracy:** four roundings.
pub fn mean_permittivity(permittivities: Fillings, areas: Areas) -> f64 {
    permittivities.surrounding + (permittivities.solid - permittivities.surrounding) * areas.solid / areas.electrode
}

/// Two capacitances in series.
///
/// $$ C = \frac{C_1 C_2}{C_1 + C_2} $$
///
/// | symbol | argument | unit |
/// |--------|----------|------|
/// | C1, C2 | `pair`   | F    |
///
/// **Source:** \[hampson2023\] (21): integrate each layer, then add in series, exact only where the gap is the same everywhere.
/// **Assumes:** `INTEGRATE-THEN-SERIES`. **Accuracy:** three roundings.
pub fn series(pair: [f64; 2]) -> f64 {
    let [first, second] = pair;
    first * second / (first + second)
}

/// A layer in series with the bent gap: thickness and permittivity.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SeriesLayer {
    /// thickness, m
    pub thickness: f64,
    /// permittivity, F/m
    pub permittivity: f64,
}

/// Capacitance of a bent gap with a flat layer in series, the layers added point by point before the integral.
///
/// $$ C = \int \frac{dA}{d(\rho) / \epsilon + h / \epsilon_h} $$
///
/// | symbol  | argument       | unit |
/// |---------|----------------|------|
/// | d(ρ)    | `plates`       | m    |
/// | ε       | `permittivity` | F/m  |
/// | h, ε_h  | `layer`        | m, F/m |
///
/// **Source:** own; the exact form of \[hampson2023\] (21), see `docs/errata.md`. The layer is h ε / ε_h of extra gap in (19).
/// **Assumes:** `SPHERICAL-WARP`, `NO-FRINGING`. **Accuracy:** `series_before_the_integral_is_the_quadrature_of_both_layers`.
pub fn series_then_integrated(permittivity: f64, plates: BentPlates, layer: SeriesLayer) -> f64 {
    let extra = layer.thickness * permittivity / layer.permittivity;
    permittivity * BentPlates { centre_gap: plates.centre_gap + extra, ..plates }.integral()
}

/// Trace of the tail, m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Trace {
    /// length, m
    pub length: f64,
    /// width, m
    pub width: f64,
}

/// Capacitance of the tail's trace to the shields on both sides.
///
/// $$ C_{tail} = \frac{2 \epsilon L W}{d} $$
///
/// | symbol | argument       | unit |
/// |--------|----------------|------|
/// | ε      | `permittivity` | F/m  |
/// | L, W   | `trace`        | m    |
/// | d      | `thickness`    | m    |
///
/// **Source:** \[hampson2023\] (22). **Assumes:** `NO-FRINGING`, poor for a trace only four thicknesses wide. **Accuracy:** a few roundings.
pub fn tail_capacitance(permittivity: f64, trace: Trace, thickness: f64) -> f64 {
    2.0 * plate_capacitance(permittivity, trace.length * trace.width, thickness)
}

/// The capacitances that a shielded sensor adds up, F.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Shares {
    /// pressure-sensitive gap with the insulator in series
    pub main: f64,
    /// insulator behind the electrode
    pub backing: f64,
    /// tail
    pub tail: f64,
}

/// Capacitance of a shielded sensor.
///
/// $$ C = C_{main} + C_{backing} + C_{tail} $$
///
/// | symbol | argument | unit |
/// |--------|----------|------|
/// | C      | `shares` | F    |
///
/// **Source:** \[hampson2023\] (23). **Accuracy:** two roundings.
pub fn total_capacitance(shares: Shares) -> f64 {
    shares.main + shares.backing + shares.tail
}
