//! A disc over a gap that is a dome and a wedge at once.
//!
//! Limits: the dome is shallow, a parabola; the wedge is flat.

/// Mean over a disc of the reciprocal gap, in units of the mean gap, where the gap is `1 + s (u - 1/2) + t sqrt(u) cos θ` with u the square of the distance
/// from the centre over the radius; `None` where the plates touch.
///
/// $$ \int_0^1 \frac{du}{\sqrt{q(u)}} = \frac{2}{s} \operatorname{artanh} \frac{s}{\sqrt{q(0)} + \sqrt{q(1)}}, \qquad q(u) = \left(1 + s (u - \tfrac12)\right)^2 - t^2 u $$
///
/// | symbol | argument    | unit |
/// |--------|-------------|------|
/// | t      | `tilt`: difference between rim and centre over the mean gap, along the slope | - |
/// | s      | `sag`: rim height of the dome over the mean gap, positive where the rim gap is wider | - |
///
/// **Source:** own; the integral over the angle is 2π / sqrt(q), and q is a quadratic in u. s = 0: 2 / (1 + sqrt(1 - t²)); t = 0: (19) for a shallow dome.
/// **Assumes:** `SHALLOW-WARP`. **Accuracy:** 1e-12 against quadrature in two dimensions, `dome_and_wedge_together_are_their_integral`.
pub(crate) fn shape_factor(tilt: f64, sag: f64) -> Option<f64> {
    if tilt == 0.0 && sag == 0.0 {
        return Some(1.0);
    }
    let (centre, rim) = (1.0 - 0.5 * sag, 1.0 + 0.5 * sag);
    let left = rim * rim - tilt * tilt;
    if !(centre > 0.0 && rim > tilt.abs() && least_squared(tilt, sag) > 0.0) {
        return None;
    }
    let x = sag / (centre + left.sqrt());
    let over_x = if x.abs() < 1e-4 { 1.0 + x * x / 3.0 } else { x.atanh() / x };
    Some(2.0 * over_x / (centre + left.sqrt()))
}

/// Least value of q between centre and rim.
fn least_squared(tilt: f64, sag: f64) -> f64 {
    let q = |u: f64| (1.0 + sag * (u - 0.5)).powi(2) - tilt * tilt * u;
    if sag == 0.0 {
        return q(1.0);
    }
    // q' = 0
    let lowest = 0.5 - (2.0 * sag - tilt * tilt) / (2.0 * sag * sag);
    q(lowest.clamp(0.0, 1.0))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::equations::{
        integral::BentPlates,
        warp::{Dome, RimSag},
    };
    use std::f64::consts::PI;

    /// Midpoint rule in the angle, where the integrand is smooth and periodic; Gauss-Legendre by halves in u.
    fn by_quadrature(tilt: f64, sag: f64) -> f64 {
        let angles = 400;
        let ring = |u: f64| {
            let gap =
                |i: i32| 1.0 + sag * (u - 0.5) + tilt * u.sqrt() * (2.0 * PI * (f64::from(i) + 0.5) / f64::from(angles)).cos();
            (0..angles).map(|i| 1.0 / gap(i)).sum::<f64>() / f64::from(angles)
        };
        let nodes = [(0.906_179_845_938_664, 0.236_926_885_056_189_1), (0.538_469_310_105_683_1, 0.478_628_670_499_366_5)];
        let panels = 64;
        (0..panels)
            .map(|p| {
                let (middle, half) = ((f64::from(p) + 0.5) / f64::from(panels), 0.5 / f64::from(panels));
                let pair = |(x, w): (f64, f64)| w * (ring(middle - half * x) + ring(middle + half * x));
                half * (0.568_888_888_888_888_9 * ring(middle) + nodes.map(pair).iter().sum::<f64>())
            })
            .sum()
    }

    #[test]
    fn dome_and_wedge_together_are_their_integral() {
        for (tilt, sag) in [(0.3, 0.2), (0.3, -0.2), (0.7, 0.4), (0.1, 1e-5), (0.5, 0.0), (0.0, 0.6), (-0.4, -0.5), (0.0, 0.0)] {
            approx::assert_relative_eq!(shape_factor(tilt, sag).unwrap(), by_quadrature(tilt, sag), max_relative = 1e-12);
        }
    }

    #[test]
    fn a_shallow_dome_has_the_factor_of_the_exact_integral() {
        // radius 1000 gaps: what is left out is of the order of (sag / radius)², 1e-7
        for sag in [-1.2, -0.3, 1e-5, 0.5, 1.5] {
            let (mean, radius) = (1e-4, 0.1);
            let dome = Dome::from_rim_sag(RimSag { sag: sag * mean, radius });
            let exact = BentPlates::settled(mean, dome).integral() * mean / (PI * radius * radius);
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
                let angle = PI * (f64::from(i) + 0.5) / f64::from(strips);
                2.0 * angle.sin() * angle.sin() / (1.0 + tilt * angle.cos())
            })
            .sum();
        let mean = sum / f64::from(strips);
        approx::assert_relative_eq!(shape_factor(tilt, 0.0).unwrap(), mean, max_relative = 1e-12);
        assert!(shape_factor(1.0, 0.0).is_none() && shape_factor(0.0, 2.0).is_none());
    }

    #[test]
    fn plates_that_touch_have_no_factor() {
        // at the rim, at the centre, and between the two: 1 + s (u - 1/2) < t sqrt(u) at u = 0.3 only
        assert!(shape_factor(1.0, 0.0).is_none() && shape_factor(0.0, 2.0).is_none() && shape_factor(0.95, -0.2).is_none());
        assert!(shape_factor(1.36, 1.5).is_none() && 1.0 + 0.5 * 1.5 > 1.36);
    }
}
