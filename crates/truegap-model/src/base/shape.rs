//! Plates of unknown size, flat until something bends or tilts them.
//!
//! Limits: the dome is shallow (sag small against the radius).

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

#[cfg(test)]
mod tests {
    use crate::equations::{
        integral::BentPlates,
        warp::{Dome, RimSag},
    };
    use crate::stack::shape_factor;

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
