//! How fast the dome and the capacitance integral change with what they are computed from.
//!
//! Limits: those of [`super::integral`]; derivatives of first order.

use super::{
    integral::BentPlates,
    warp::{Dome, rim_sag},
};
use std::f64::consts::PI;

/// Below this share of the centre gap the bracket of the slopes is a series.
const SMALL: f64 = 0.05;

/// The capacitance integral and its derivatives, each with the other two quantities held.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct IntegralSlopes {
    /// [`BentPlates::integral`], m
    pub integral: f64,
    /// by the gap at the centre
    pub by_gap: f64,
    /// by the curvature, m²
    pub by_curvature: f64,
    /// by the radius
    pub by_radius: f64,
}

/// The integral of 1/gap over the disc and its derivatives.
///
/// $$ \frac{\partial I}{\partial g_0} = -2\pi\left[\frac{h}{g_0 d_r} + b\right], \quad \frac{\partial I}{\partial k} = 2\pi \left(\frac{h}{g_0}\right)^2 \frac{b}{x^2},
///    \quad \frac{\partial I}{\partial r} = \frac{2\pi r}{d_r}, \qquad b = \frac{x}{1 + x} - \ln(1 + x) $$
///
/// | symbol | argument | unit |
/// |--------|----------|------|
/// | g0, d_r | `plates`: centre gap, rim gap | m |
/// | h      | sag over curvature, from `plates.dome` | m² |
/// | x      | rim sag over g0 | - |
///
/// **Source:** own; derivatives of the closed form of \[hampson2023\] (19). **Assumes:** `SPHERICAL-WARP`, `NO-FRINGING`.
/// **Accuracy:** 1e-7 against difference quotients, `slopes_of_the_integral_are_its_difference_quotients`.
pub fn integral_slopes(plates: BentPlates) -> IntegralSlopes {
    let BentPlates { dome, centre_gap: g } = plates;
    let half_chord = dome.radius * dome.radius / (1.0 + dome.cosine());
    let sag = dome.curvature * half_chord;
    let (rim, x, over_gap) = (g + sag, sag / g, half_chord / g);
    let (bracket, over_square) = bracket(x, rim / g);
    IntegralSlopes {
        integral: plates.integral(),
        by_gap: -2.0 * PI * (over_gap / rim + bracket),
        by_curvature: 2.0 * PI * over_gap * over_gap * over_square,
        by_radius: 2.0 * PI * dome.radius / rim,
    }
}

/// `x / (1 + x) - ln(1 + x)` and the same over x².
fn bracket(x: f64, rim: f64) -> (f64, f64) {
    if x.abs() < SMALL {
        // the sum of (1/n - 1) (-x)^(n - 2) from n = 2: twelve terms leave 0.05^12 = 2e-16
        let over_square = (2..14).rev().fold(0.0, |sum, n| (f64::from(n).recip() - 1.0) - x * sum);
        return (x * x * over_square, over_square);
    }
    let bracket = x / rim - rim.ln();
    (bracket, bracket / (x * x))
}

/// A height of the dome and its derivatives.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SagSlopes {
    /// the height, m
    pub height: f64,
    /// by the curvature, m²
    pub by_curvature: f64,
    /// by the radius
    pub by_radius: f64,
}

/// [`rim_sag`] and its derivatives.
///
/// $$ \frac{\partial s}{\partial k} = \frac{r^2 + s^2}{2 c}, \qquad \frac{\partial s}{\partial r} = \frac{k r}{c} $$
///
/// | symbol | argument | unit |
/// |--------|----------|------|
/// | k, r, c | `dome`: curvature, radius, cosine of the half-angle | 1/m, m, - |
///
/// **Source:** own; from k s² - 2 s + k r² = 0. **Assumes:** `SPHERICAL-WARP`. **Accuracy:** 1e-7 against difference quotients, `slopes_of_the_sags_are_their_difference_quotients`.
pub fn rim_sag_slopes(dome: Dome) -> SagSlopes {
    let (s, c) = (rim_sag(dome), dome.cosine());
    SagSlopes {
        height: s,
        by_curvature: (dome.radius * dome.radius + s * s) / (2.0 * c),
        by_radius: dome.curvature * dome.radius / c,
    }
}

/// [`mean_sag`](super::warp::mean_sag) and its derivatives.
///
/// $$ \bar s = s f, \quad f = \frac{1 + 2 c}{3 (1 + c)}, \quad \frac{\mathrm{d} f}{\mathrm{d} c} = \frac{1}{3 (1 + c)^2}, \quad
///    \frac{\partial c}{\partial k} = -\frac{k r^2}{c}, \quad \frac{\partial c}{\partial r} = -\frac{k^2 r}{c} $$
///
/// | symbol | argument | unit |
/// |--------|----------|------|
/// | k, r, c | `dome`: curvature, radius, cosine of the half-angle | 1/m, m, - |
///
/// **Source:** own; derivative of [`mean_sag`](super::warp::mean_sag). **Assumes:** `SPHERICAL-WARP`. **Accuracy:** as [`rim_sag_slopes`].
pub fn mean_sag_slopes(dome: Dome) -> SagSlopes {
    let Dome { curvature: k, radius: r } = dome;
    let (rim, c) = (rim_sag_slopes(dome), dome.cosine());
    let share = (1.0 + 2.0 * c) / (3.0 * (1.0 + c));
    let turned = rim.height / (3.0 * (1.0 + c) * (1.0 + c)) * k * r / c;
    SagSlopes {
        height: rim.height * share,
        by_curvature: rim.by_curvature * share - turned * r,
        by_radius: rim.by_radius * share - turned * k,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::equations::warp::mean_sag;

    /// Central difference quotient of `f` at `x`.
    fn quotient(f: impl Fn(f64) -> f64, x: f64, step: f64) -> f64 {
        (f(x + step) - f(x - step)) / (2.0 * step)
    }

    fn domes() -> impl Iterator<Item = Dome> {
        [-8.0, -0.9, -1e-3, 0.0, 1e-3, 0.3, 2.0, 9.0].into_iter().map(|curvature| Dome { curvature, radius: 6e-3 })
    }

    #[test]
    fn slopes_of_the_integral_are_its_difference_quotients() {
        for dome in domes() {
            let plates = BentPlates { dome, centre_gap: 3e-4 };
            let found = integral_slopes(plates);
            let at = |curvature: f64, radius: f64, centre_gap: f64| {
                BentPlates { dome: Dome { curvature, radius }, centre_gap }.integral()
            };
            let (k, r, g) = (dome.curvature, dome.radius, plates.centre_gap);
            approx::assert_relative_eq!(found.by_gap, quotient(|g| at(k, r, g), g, 1e-8), max_relative = 1e-7);
            approx::assert_relative_eq!(found.by_radius, quotient(|r| at(k, r, g), r, 1e-7), max_relative = 1e-7);
            approx::assert_relative_eq!(found.by_curvature, quotient(|k| at(k, r, g), k, 1e-4), max_relative = 1e-7);
            assert_eq!(found.integral, plates.integral());
        }
    }

    #[test]
    fn slopes_of_the_sags_are_their_difference_quotients() {
        for dome in domes() {
            for (found, height) in [(rim_sag_slopes(dome), rim_sag as fn(Dome) -> f64), (mean_sag_slopes(dome), mean_sag)] {
                let by_curvature = quotient(|curvature| height(Dome { curvature, ..dome }), dome.curvature, 1e-4);
                let by_radius = quotient(|radius| height(Dome { radius, ..dome }), dome.radius, 1e-7);
                approx::assert_relative_eq!(found.by_curvature, by_curvature, max_relative = 1e-7);
                approx::assert_abs_diff_eq!(found.by_radius, by_radius, epsilon = 1e-9);
                approx::assert_relative_eq!(found.height, height(dome), max_relative = 1e-15);
            }
        }
    }
}
