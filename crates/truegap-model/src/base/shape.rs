//! What wedge and dome do to plates of unknown size.
//!
//! Limits: the dome is shallow (sag small against the radius); wedge and dome are multiplied.

use crate::stack::wedge;
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

/// Factor on the capacitance of flat plates at the same mean gap; `None` where the plates touch.
///
/// $$ \frac{2}{1 + \sqrt{1 - t^2}} \cdot \frac{\operatorname{atanh} u}{u}, \qquad u = \frac{s}{2 d} $$
///
/// | symbol | argument    | unit |
/// |--------|-------------|------|
/// | t      | `tilt`: difference between rim and centre over the mean gap | - |
/// | s / d  | `sag`: rim height over the mean gap | - |
///
/// **Source:** own; the wedge over a disc, and (19) for a shallow dome. **Assumes:** `SHALLOW-WARP`.
pub(super) fn shape_factor(tilt: f64, sag: f64) -> Option<f64> {
    let half = 0.5 * sag;
    if !(tilt.abs() < 1.0 && half.abs() < 1.0) {
        return None;
    }
    let dome = if half.abs() < 1e-4 { 1.0 + half * half / 3.0 } else { half.atanh() / half };
    Some(wedge(tilt) * dome)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::equations::{
        integral::BentPlates,
        warp::{Dome, RimSag},
    };

    #[test]
    fn a_shallow_dome_has_the_factor_of_the_exact_integral() {
        // radius 1000 gaps: what is left out is of the order of (sag / radius)², 1e-7
        for sag in [-1.2, -0.3, 1e-5, 0.5, 1.5] {
            let (mean, radius) = (1e-4, 0.1);
            let dome = Dome::from_rim_sag(RimSag { sag: sag * mean, radius });
            let exact = BentPlates::settled(mean, dome).integral() * mean / (std::f64::consts::PI * radius * radius);
            approx::assert_relative_eq!(shape_factor(0.0, sag).unwrap(), exact, max_relative = 1e-5);
        }
    }

    #[test]
    fn a_wedge_has_the_factor_of_its_integral_over_the_disc() {
        let tilt = 0.6;
        let strips = 200_000;
        // strips across the slope: chord / gap, midpoint rule in the angle, where the integrand is smooth and periodic
        let sum: f64 = (0..strips)
            .map(|i| {
                let angle = std::f64::consts::PI * (f64::from(i) + 0.5) / f64::from(strips);
                2.0 * angle.sin() * angle.sin() / (1.0 + tilt * angle.cos())
            })
            .sum();
        let mean = sum / f64::from(strips);
        approx::assert_relative_eq!(shape_factor(tilt, 0.0).unwrap(), mean, max_relative = 1e-12);
        assert!(shape_factor(1.0, 0.0).is_none() && shape_factor(0.0, 2.0).is_none());
    }
}
