//! The beads: how far they are pressed together by a load.
//!
//! Limits: corrected (12), a frictionless disc that spreads; any stiffening is a power of the shape factor.

use super::constants::{EXPANSION_RTV, POISSON, REFERENCE};
use crate::sensor::Sensor;
use std::f64::consts::PI;

/// Total bead area before load at `temperature` (degC), m^2.
pub fn area(sensor: &Sensor, temperature: f64) -> f64 {
    let diameter = sensor.bead_diameter * (1.0 + EXPANSION_RTV * (temperature - REFERENCE));
    sensor.beads * PI / 4.0 * diameter * diameter
}

/// Young's modulus of the silicone at `temperature` (degC), Pa.
pub fn young(sensor: &Sensor, temperature: f64) -> f64 {
    sensor.young_rtv + sensor.softening * (temperature - REFERENCE)
}

/// Load over area and modulus that a compression `e` answers: `e (1 + nu e)^2 (S(e) / S(0))^p`.
///
/// The last factor is how a bonded disc stiffens as it gets flatter: its shape factor is diameter / (4 height), so
/// S(e)/S(0) = (1 + nu e) / (1 - e). `stiffening` p = 0 is the base model.
pub fn resistance(e: f64, stiffening: f64) -> f64 {
    let spread = 1.0 + POISSON * e;
    let base = e * spread * spread;
    if stiffening == 0.0 { base } else { base * (spread / (1.0 - e)).powf(stiffening) }
}

/// The compression (positive) that answers `load` = F / (A E): bisection, polished by secants inside the bracket.
pub fn compression(load: f64, stiffening: f64) -> f64 {
    root(|e| resistance(e, stiffening) - load, load)
}

/// Root of an increasing function near `guess`, between -0.9 and 0.9: the Illinois variant of false position.
pub fn root(f: impl Fn(f64) -> f64, guess: f64) -> f64 {
    let (mut low, mut high) = (-0.9, 0.9);
    let near = guess.clamp(-0.8, 0.8);
    let width = 0.02 + 0.6 * near.abs();
    for probe in [near - width, near + width] {
        if probe > low && probe < high {
            if f(probe) < 0.0 { low = probe } else { high = probe }
        }
    }
    let (mut f_low, mut f_high) = (f(low), f(high));
    let mut last = 0_i8;
    for _ in 0..100 {
        let middle = (low * f_high - high * f_low) / (f_high - f_low);
        let value = f(middle);
        if value == 0.0 || high - low < 1e-16 {
            return middle;
        }
        if value < 0.0 {
            if (middle - low).abs() < 1e-16 * middle.abs().max(1e-3) {
                return middle;
            }
            (low, f_low) = (middle, value);
            if last == -1 {
                f_high *= 0.5
            }
            last = -1;
        } else {
            if (high - middle).abs() < 1e-16 * middle.abs().max(1e-3) {
                return middle;
            }
            (high, f_high) = (middle, value);
            if last == 1 {
                f_low *= 0.5
            }
            last = 1;
        }
    }
    0.5 * (low + high)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The bracket shrinks to rounding; resistance has slope near 1, hence the same tolerance for the load.
    #[test]
    fn compression_undoes_resistance() {
        for stiffening in [0.0, 0.5, 2.0] {
            for e in [-0.01, 0.0, 1e-6, 0.02, 0.14, 0.4] {
                let found = compression(resistance(e, stiffening), stiffening);
                assert!((found - e).abs() < 1e-13, "{e} {stiffening}: {found}");
            }
        }
    }
}
