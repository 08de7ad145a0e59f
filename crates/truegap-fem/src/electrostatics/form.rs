//! The weak form of electrostatics at one quadrature point.

use crate::space::Shape;

/// Permittivity of vacuum (F/m). **Source:** CODATA 2018.
pub const VACUUM_PERMITTIVITY: f64 = 8.854_187_812_8e-12;

/// Integrand of a(u, v) = ∫ ε ∇u · ∇v w dA for v = `test`, u = `trial`; w (2πr or 1) comes with the weight.
///
/// | symbol | argument       | unit |
/// |--------|----------------|------|
/// | ε      | `permittivity` | F/m  |
///
/// **Source:** Gauss's law div(ε grad V) = 0, tested and integrated by parts. **Accuracy:** exact;
/// `smooth_fields_converge_with_order_and_curve` in `tests/electrostatics.rs` pins it.
#[inline]
pub fn dielectric(permittivity: f64, test: Shape, trial: Shape) -> f64 {
    permittivity * (test.gradient[0] * trial.gradient[0] + test.gradient[1] * trial.gradient[1])
}

/// Energy density ε |E|² / 2 (J/m³) of the field `e_v_per_m`.
pub fn energy_density(permittivity: f64, e_v_per_m: [f64; 2]) -> f64 {
    0.5 * permittivity * (e_v_per_m[0] * e_v_per_m[0] + e_v_per_m[1] * e_v_per_m[1])
}
