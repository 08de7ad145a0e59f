//! Constants of Table 1 of Hampson & Dobie, and the reference temperature of `model_conventions.md`. SI units, temperatures in degC.

/// Vacuum permittivity as the paper rounds it, F/m.
pub const EPS0: f64 = 8.854e-12;
/// Reference temperature, degC.
pub const REFERENCE: f64 = 20.0;
/// Relative permittivity of the silicone.
pub const EPS_RTV: f64 = 3.4;
/// Relative permittivity of the polyimide.
pub const EPS_PA: f64 = 3.4;
/// Relative permittivity of air.
pub const EPS_AIR: f64 = 1.0;
/// Young's modulus of copper, Pa.
pub const YOUNG_CU: f64 = 117e9;
/// Young's modulus of tin, Pa.
pub const YOUNG_SN: f64 = 41.6e9;
/// Young's modulus of polyimide, Pa.
pub const YOUNG_PA: f64 = 2.7e9;
/// Expansion of copper, 1/K.
pub const EXPANSION_CU: f64 = 16.7e-6;
/// Expansion of tin, 1/K.
pub const EXPANSION_SN: f64 = 22.4e-6;
/// Expansion of the silicone, 1/K.
pub const EXPANSION_RTV: f64 = 200e-6;
/// Expansion of polyimide, 1/K.
pub const EXPANSION_PA: f64 = 20e-6;
/// Poisson's ratio of the silicone.
pub const POISSON: f64 = 0.49;
/// Length of the tail, m.
pub const TAIL_LENGTH: f64 = 40e-3;
/// Width of the tail's trace, m.
pub const TAIL_WIDTH: f64 = 0.1e-3;
/// Rated force, N.
pub const RATED_FORCE: f64 = 4.5;
/// Pressure of the surrounding air, Pa.
pub const ATMOSPHERE: f64 = 101_325.0;
/// 0 degC in kelvin.
pub const ZERO_CELSIUS: f64 = 273.15;
