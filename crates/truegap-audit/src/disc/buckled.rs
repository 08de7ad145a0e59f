//! A heated disc free to buckle, by energy: two curvatures, and the membrane stress that their product raises.
//!
//! Curvatures are the same over the whole disc (no edge layer), elastic constants those of a uniform plate: the critical temperature comes out
//! 4 % low and sags 13 % high against refined Ritz and 3D finite elements; shapes are right (a bowl, then nearly a cylinder).

use super::laminate::Laminate;

/// Curvatures of a disc along two perpendicular diameters, 1/m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TwoCurvatures {
    /// along one diameter
    pub first: f64,
    /// along the other
    pub second: f64,
}

/// Curvature of a bowl at which it turns into a cylinder, 1/m.
///
/// $$ a_c = \frac{4 h}{R^2 \sqrt{1 + \nu}} $$
///
/// | symbol | argument | unit |
/// |--------|----------|------|
/// | h, R, ν | `plate` (h from its bending stiffness) | m, m, - |
///
/// **Source:** L. B. Freund, J. Mech. Phys. Solids 48 (2000) 1159: energy of the disc with two curvatures. **Accuracy:** see [`buckled`].
pub fn critical_curvature(plate: &Laminate) -> f64 {
    4.0 * bending_thickness(plate) / (plate.radius * plate.radius * (1.0 + plate.poisson()).sqrt())
}

/// Curvatures of least energy for a disc whose free small-deflection curvature would be `free` (1/m).
///
/// $$ \frac{U}{\pi R^2} = \frac{D}{2}\left[(a-\kappa)^2 + (b-\kappa)^2 + 2\nu(a-\kappa)(b-\kappa)\right] + \frac{E h R^4 a^2 b^2}{384} $$
///
/// **Source:** as [`critical_curvature`]; the last term is the membrane energy of the stress function `-(E h a b / 64)(r² - R²)²`.
/// **Accuracy:** free bimetal disc of 17 um copper and 5 um tin, 7.5 mm: instability at 10.68 K (refined Ritz 11.13 K), at 30 K sags of 185.2 and 6.3 um
/// (164.1 and 6.0 um), `two_curvatures_buckle_near_where_refined_routes_do`.
pub fn buckled(plate: &Laminate, free: f64) -> TwoCurvatures {
    let nu = plate.poisson();
    let critical = critical_curvature(plate);
    // Bowl: a (1 + m a²) = κ with m a_c² = (1 - ν) / (1 + ν).
    let bowl = bowl(free.abs(), (1.0 - nu) / ((1.0 + nu) * critical * critical));
    if bowl <= critical {
        return TwoCurvatures { first: bowl.copysign(free), second: bowl.copysign(free) };
    }
    // Beyond it: a b = a_c², a + b = (1 + ν) κ.
    let sum = (1.0 + nu) * free.abs();
    let root = (0.25 * sum * sum - critical * critical).sqrt();
    TwoCurvatures { first: (0.5 * sum + root).copysign(free), second: (0.5 * sum - root).copysign(free) }
}

/// Positive root of a (1 + m a²) = κ by Newton's method from above.
fn bowl(kappa: f64, m: f64) -> f64 {
    let mut a = kappa;
    for _ in 0..60 {
        let step = (a * (1.0 + m * a * a) - kappa) / (1.0 + 3.0 * m * a * a);
        a -= step;
        if step.abs() <= 1e-15 * kappa {
            break;
        }
    }
    a
}

/// Thickness of the uniform plate that bends and stretches like the laminate: sqrt(12 D (1 - ν²) / Σ E h).
fn bending_thickness(plate: &Laminate) -> f64 {
    let nu = plate.poisson();
    let stretching: f64 = plate.sheets.iter().map(|s| s.young * s.thickness).sum();
    (12.0 * plate.bending_stiffness() * (1.0 - nu * nu) / stretching).sqrt()
}

/// Mean of mean gap over local gap under a disc with two curvatures; `None` where the plates touch.
///
/// The height is `(a x² + b y²) / 2`; shares of the disc are taken at even points in radius squared and angle.
pub(super) fn gain(curvatures: TwoCurvatures, radius: f64, mean_gap: f64) -> Option<f64> {
    const RADII: usize = 64;
    const ANGLES: usize = 64;
    let TwoCurvatures { first, second } = curvatures;
    let mean = 0.125 * (first + second) * radius * radius;
    let mut sum = 0.0;
    for i in 0..RADII {
        let squared = radius * radius * (i as f64 + 0.5) / RADII as f64;
        for k in 0..ANGLES {
            let angle = std::f64::consts::PI * (k as f64 + 0.5) / ANGLES as f64;
            let height = 0.5 * squared * (first * angle.cos().powi(2) + second * angle.sin().powi(2)) - mean;
            if mean_gap + height <= 0.0 {
                return None;
            }
            sum += mean_gap / (mean_gap + height);
        }
    }
    Some(sum / (RADII * ANGLES) as f64)
}
