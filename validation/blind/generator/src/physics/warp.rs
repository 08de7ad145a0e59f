//! The bimetal electrode: curvature by Timoshenko's form of the two-layer plate, height of the dome by the angle at its rim.
//!
//! Limits: free plate, small strain, spherical shape.

use super::constants::{EXPANSION_CU, EXPANSION_SN, REFERENCE, YOUNG_CU, YOUNG_SN};
use crate::sensor::Sensor;

/// Curvature (1/m) of the tin on copper electrode at `temperature` (degC); positive when warmer than 20 degC.
///
/// $$ k = \frac{6 \epsilon (1+m)^2}{h (3 (1+m)^2 + (1 + m n)(m^2 + 1/(m n)))} $$
///
/// with m the ratio of thicknesses, n of moduli, h the total thickness.
/// **Source:** Timoshenko, J. Opt. Soc. Am. 11 (1925) 233, eq. (4), with the same moduli as (9) of Hampson & Dobie, which equals it.
pub fn curvature(sensor: &Sensor, temperature: f64) -> f64 {
    let dt = temperature - REFERENCE;
    let tin = sensor.height_sn * (1.0 + EXPANSION_SN * dt);
    let copper = sensor.height_cu * (1.0 + EXPANSION_CU * dt);
    let (m, n) = (tin / copper, YOUNG_SN / YOUNG_CU);
    let misfit = (EXPANSION_SN - EXPANSION_CU) * dt;
    let sum = (1.0 + m) * (1.0 + m);
    6.0 * misfit * sum / ((tin + copper) * (3.0 * sum + (1.0 + m * n) * (m * m + 1.0 / (m * n))))
}

/// Height of a dome of `curvature` (1/m) at distance `rho` (m) from its top, below the top, m: `rho tan(phi / 2)`, sin phi = k rho.
pub fn sag(curvature: f64, rho: f64) -> f64 {
    rho * (0.5 * (curvature * rho).asin()).tan()
}
