//! Curvature of a two-metal electrode: (8)-(10).
//!
//! Limits: two bonded isotropic layers, free to bend; curvature (1/R) instead of R, so that a flat plate is a number.

/// One layer of a two-layer plate.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lamina {
    /// Young's modulus, Pa
    pub young: f64,
    /// thickness, m
    pub thickness: f64,
}

/// Two metals bonded to one another.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bimetal {
    /// material 1 of the paper (plating)
    pub first: Lamina,
    /// material 2 of the paper (conductor)
    pub second: Lamina,
}

/// Coefficients of linear expansion of two bonded materials, 1/K.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ExpansionPair {
    /// material 1
    pub first: f64,
    /// material 2
    pub second: f64,
}

/// Strain by which two bonded materials would differ if they were free.
///
/// $$ \epsilon_M = (K_1 - K_2) \Delta T $$
///
/// | symbol | argument     | unit |
/// |--------|--------------|------|
/// | K1, K2 | `expansions` | 1/K  |
/// | ΔT     | `kelvin`     | K    |
///
/// **Source:** \[hampson2023\] (8). **Accuracy:** two roundings.
pub fn mismatch_strain(expansions: ExpansionPair, kelvin: f64) -> f64 {
    (expansions.first - expansions.second) * kelvin
}

/// Curvature 1/R of the mid-plane of a two-metal plate.
///
/// $$ \frac{1}{R} = \frac{6 E_1 E_2 h_1 h_2 (h_1 + h_2) \epsilon_M}{E_1^2 h_1^4 + 4 E_1 E_2 h_1^3 h_2 + 6 E_1 E_2 h_1^2 h_2^2 + 4 E_1 E_2 h_1 h_2^3 + E_2^2 h_2^4} $$
///
/// | symbol | argument        | unit |
/// |--------|-----------------|------|
/// | E1, h1 | `layers.first`  | Pa, m |
/// | E2, h2 | `layers.second` | Pa, m |
/// | ε_M    | `mismatch`      | -    |
///
/// **Source:** \[hampson2023\] (9), inverted and divided by (E2 h2²)², so that R = infinity needs no exception; see `docs/errata.md`.
/// **Assumes:** `BIMETAL-BEAM`, `FREE-PLATE`. **Accuracy:** about ten roundings; against the printed form in `curvature_is_the_inverse_of_the_printed_radius`.
pub fn bimetal_curvature(layers: Bimetal, mismatch: f64) -> f64 {
    let Bimetal { first, second } = layers;
    let m = first.thickness / second.thickness;
    let n = first.young / second.young;
    let nm = n * m;
    let stiffness = 1.0 + nm * (4.0 + m * (6.0 + m * (4.0 + nm)));
    6.0 * nm * (1.0 + m) * mismatch / (second.thickness * stiffness)
}

/// Radius of curvature of a two-metal plate, as printed.
///
/// $$ R = \frac{E_1^2 h_1^4 + 4 E_1 E_2 h_1^3 h_2 + 6 E_1 E_2 h_1^2 h_2^2 + 4 E_1 E_2 h_1 h_2^3 + E_2^2 h_2^4}{6 E_1 E_2 h_1 h_2 (h_1 + h_2) \epsilon_M} $$
///
/// | symbol | argument        | unit |
/// |--------|-----------------|------|
/// | E1, h1 | `layers.first`  | Pa, m |
/// | E2, h2 | `layers.second` | Pa, m |
/// | ε_M    | `mismatch`      | -    |
///
/// **Source:** \[hampson2023\] (9). Infinite where the mismatch is zero; the model uses [`bimetal_curvature`].
pub fn bimetal_radius_as_printed(layers: Bimetal, mismatch: f64) -> f64 {
    let Lamina { young: e1, thickness: h1 } = layers.first;
    let Lamina { young: e2, thickness: h2 } = layers.second;
    let stiffness = e1.powi(2) * h1.powi(4)
        + 4.0 * e1 * e2 * h1.powi(3) * h2
        + 6.0 * e1 * e2 * h1.powi(2) * h2.powi(2)
        + 4.0 * e1 * e2 * h1 * h2.powi(3)
        + e2.powi(2) * h2.powi(4);
    stiffness / (6.0 * e1 * e2 * h1 * h2 * (h1 + h2) * mismatch)
}

/// Curvatures of the two faces of a bent plate, outer face first.
///
/// $$ R_{surface} = R \pm \frac{h}{2} \quad\Rightarrow\quad \frac{1}{R_{surface}} = \frac{1/R}{1 \pm h / (2R)} $$
///
/// | symbol | argument    | unit |
/// |--------|-------------|------|
/// | 1/R    | `curvature` | 1/m  |
/// | h      | `thickness` (both layers) | m |
///
/// **Source:** \[hampson2023\] (10), for curvatures. The base model bends the mid-plane and does not use it: the faces differ by 1e-5 of the curvature.
/// **Accuracy:** four roundings.
pub fn surface_curvatures(curvature: f64, thickness: f64) -> [f64; 2] {
    let half = 0.5 * curvature * thickness;
    [curvature / (1.0 + half), curvature / (1.0 - half)]
}
