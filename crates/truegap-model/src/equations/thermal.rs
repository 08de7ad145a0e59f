//! What temperature does to lengths, areas and moduli: (3)-(7).
//!
//! Limits: constant coefficients, free expansion of each layer by itself.

/// Length after a change of temperature.
///
/// $$ L(T) = L_0 (1 + K \Delta T) $$
///
/// | symbol | argument    | unit |
/// |--------|-------------|------|
/// | L0     | `length`    | m    |
/// | K      | `expansion` | 1/K  |
/// | ΔT     | `kelvin`    | K    |
///
/// **Source:** \[hampson2023\] (3). **Assumes:** `FREE-EXPANSION`. **Accuracy:** two roundings.
pub fn expanded_length(length: f64, expansion: f64, kelvin: f64) -> f64 {
    length * (1.0 + expansion * kelvin)
}

/// Area after a change of temperature.
///
/// $$ A(T) = A_0 (1 + K \Delta T)^2 $$
///
/// | symbol | argument    | unit |
/// |--------|-------------|------|
/// | A0     | `area`      | m²   |
/// | K      | `expansion` | 1/K  |
/// | ΔT     | `kelvin`    | K    |
///
/// **Source:** \[hampson2023\] (4). **Assumes:** `FREE-EXPANSION`. **Accuracy:** four roundings.
pub fn expanded_area(area: f64, expansion: f64, kelvin: f64) -> f64 {
    let stretch = 1.0 + expansion * kelvin;
    area * stretch * stretch
}

/// Area of all beads together.
///
/// $$ A = N A_{bead} $$
///
/// | symbol | argument    | unit |
/// |--------|-------------|------|
/// | N      | `count`     | -    |
/// | A_bead | `bead_area` | m²   |
///
/// **Source:** \[hampson2023\] (5). **Assumes:** equal beads. **Accuracy:** one rounding.
pub fn total_bead_area(count: u32, bead_area: f64) -> f64 {
    f64::from(count) * bead_area
}

/// Areas in the plane of the electrode.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Areas {
    /// whole electrode, m²
    pub electrode: f64,
    /// covered by the solid part of the dielectric, m²
    pub solid: f64,
}

/// Area of the electrode that no bead covers.
///
/// $$ A_{air} = A_{electrode} - A_{silicone} $$
///
/// | symbol      | argument          | unit |
/// |-------------|-------------------|------|
/// | A_electrode | `areas.electrode` | m²   |
/// | A_silicone  | `areas.solid`     | m²   |
///
/// **Source:** \[hampson2023\] (6). **Accuracy:** one rounding.
pub fn air_area(areas: Areas) -> f64 {
    areas.electrode - areas.solid
}

/// Young's modulus after a change of temperature.
///
/// $$ E(T) = E_0 + K_{SE} \Delta T $$
///
/// | symbol | argument    | unit |
/// |--------|-------------|------|
/// | E0     | `young`     | Pa   |
/// | K_SE   | `softening` | Pa/K |
/// | ΔT     | `kelvin`    | K    |
///
/// **Source:** \[hampson2023\] (7). The paper calls K_SE softening and gives it a sign that stiffens; the sign stays with the argument.
/// **Assumes:** a modulus that is linear in temperature. **Accuracy:** two roundings.
pub fn young_at(young: f64, softening: f64, kelvin: f64) -> f64 {
    young + softening * kelvin
}
