//! The dome that a bent electrode makes of the gap: (16)-(18), rewritten so that no digits are lost.
//!
//! Limits: a spherical cap over a disc, |curvature| x radius < 1; beyond a hemisphere the results are NaN, which the callers turn into an error.

/// A disc bent to a spherical cap, its rim at a fixed radius from the axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Dome {
    /// 1/R, positive where the rim is further from the other plate than the centre is, 1/m
    pub curvature: f64,
    /// radius of the rim (chord), m
    pub radius: f64,
}

impl Dome {
    /// Cosine of the half-angle of the cap.
    pub fn cosine(self) -> f64 {
        let kr = self.curvature * self.radius;
        (1.0 - kr * kr).sqrt()
    }

    /// The cap with a given rim sag.
    ///
    /// $$ k = \frac{2 s}{r^2 + s^2} $$
    pub fn from_rim_sag(sag: RimSag) -> Self {
        let RimSag { sag, radius } = sag;
        Self { curvature: 2.0 * sag / (radius * radius + sag * sag), radius }
    }
}

/// Height of a rim above its centre, and its radius.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RimSag {
    /// height of the rim above the centre, m
    pub sag: f64,
    /// radius of the rim, m
    pub radius: f64,
}

/// Height of a dome above its centre at a distance from the axis.
///
/// $$ s(\rho) = \frac{k \rho^2}{1 + \sqrt{1 - k^2 \rho^2}} $$
///
/// | symbol | argument         | unit |
/// |--------|------------------|------|
/// | k      | `dome.curvature` | 1/m  |
/// | ρ      | `distance`       | m    |
///
/// **Source:** \[hampson2023\] (18), rewritten so that a flat plate (k = 0) loses no digits; see `docs/errata.md`.
/// **Assumes:** `SPHERICAL-WARP`. **Accuracy:** 1e-15 relative against 50-digit arithmetic, `the_sag_keeps_its_digits_where_the_printed_form_loses_them`.
pub fn sag(dome: Dome, distance: f64) -> f64 {
    rim_sag(Dome { radius: distance, ..dome })
}

/// Rim height of a dome above its centre.
///
/// $$ s = \frac{k r^2}{1 + \sqrt{1 - k^2 r^2}} $$
///
/// | symbol | argument         | unit |
/// |--------|------------------|------|
/// | k      | `dome.curvature` | 1/m  |
/// | r      | `dome.radius`    | m    |
///
/// **Source:** \[hampson2023\] (18), at the rim. **Assumes:** `SPHERICAL-WARP`. **Accuracy:** as [`sag`].
pub fn rim_sag(dome: Dome) -> f64 {
    dome.curvature * dome.radius * dome.radius / (1.0 + dome.cosine())
}

/// Mean height of a dome above its centre, over the disc.
///
/// $$ \bar s = s\,\frac{1 + 2 c}{3 (1 + c)}, \qquad c = \sqrt{1 - k^2 r^2} $$
///
/// | symbol | argument         | unit |
/// |--------|------------------|------|
/// | k      | `dome.curvature` | 1/m  |
/// | r      | `dome.radius`    | m    |
///
/// **Source:** \[hampson2023\] (16) with the two volumes equated, relative to the centre instead of to the centre of the sphere.
/// **Assumes:** `SPHERICAL-WARP`, `LINEAR-FOUNDATION`. **Accuracy:** `the_mean_sag_is_the_mean_of_the_sag` (quadrature, 1e-12).
pub fn mean_sag(dome: Dome) -> f64 {
    let c = dome.cosine();
    rim_sag(dome) * (1.0 + 2.0 * c) / (3.0 * (1.0 + c))
}

/// A sphere and the half-angle of the cap that is the electrode, as the paper draws it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cap {
    /// radius of curvature, m
    pub sphere_radius: f64,
    /// half-angle of the cap, rad
    pub half_angle: f64,
}

/// Distance from the centre of the sphere to the plane about which a cap settles: volume above equals volume missing below.
///
/// $$ \alpha = \frac23 R\,\frac{1 - \cos^3\theta}{1 - \cos^2\theta} = \frac23 R\,\frac{1 + c + c^2}{1 + c} $$
///
/// | symbol | argument            | unit |
/// |--------|---------------------|------|
/// | R      | `cap.sphere_radius` | m    |
/// | θ      | `cap.half_angle`    | rad  |
///
/// **Source:** \[hampson2023\] (16), solved: the volumes are equated, which makes the condition linear; see `docs/errata.md`.
/// **Assumes:** `LINEAR-FOUNDATION`. **Accuracy:** `the_corrected_plane_halves_the_volume` (quadrature, 1e-12).
pub fn settling_plane(cap: Cap) -> f64 {
    let c = cap.half_angle.cos();
    2.0 / 3.0 * cap.sphere_radius * (1.0 + c + c * c) / (1.0 + c)
}

/// Left-hand side of the printed cubic for the settling plane, over R³.
///
/// $$ \tfrac23 a^3 - (1 + \cos^2\theta) a + \tfrac23 (1 + \cos^3\theta), \qquad a = \alpha / R $$
///
/// | symbol | argument                             | unit |
/// |--------|--------------------------------------|------|
/// | θ      | `half_angle`                         | rad  |
/// | a      | `height` over the radius of the sphere | -  |
///
/// **Source:** \[hampson2023\] (17), as printed. It adds the two sides of (16), which equates the volumes, and is positive all over cos θ <= a <= 1 for every θ > 0: no root.
/// **Accuracy:** `the_printed_cubic_has_no_root_where_the_plane_must_be`.
pub fn settling_cubic_as_printed(half_angle: f64, height: f64) -> f64 {
    let c = half_angle.cos();
    let a = height;
    2.0 / 3.0 * a * a * a - (1.0 + c * c) * a + 2.0 / 3.0 * (1.0 + c * c * c)
}

/// Smallest value that the printed cubic takes between the rim (cos θ) and the top (1) of the cap, over R³; a root would need it to be <= 0.
///
/// $$ \min_{\cos\theta \le a \le 1} p(a) \text{ at } a^* = \sqrt{(1 + \cos^2\theta)/2} $$
///
/// | symbol | argument     | unit |
/// |--------|--------------|------|
/// | θ      | `half_angle` | rad  |
///
/// **Source:** own; the stationary point of \[hampson2023\] (17). **Accuracy:** absolute rounding of 1e-16, so meaningful for θ above about 0.01.
pub fn settling_cubic_minimum(half_angle: f64) -> f64 {
    let c = half_angle.cos();
    settling_cubic_as_printed(half_angle, ((1.0 + c * c) / 2.0).sqrt())
}

/// Gap below a bent electrode at a distance from the axis.
///
/// $$ d(\rho) = d + s(\rho) - \bar s $$
///
/// | symbol | argument   | unit |
/// |--------|------------|------|
/// | d      | `mean_gap` | m    |
/// | s      | `dome`     | 1/m, m |
/// | ρ      | `distance` | m    |
///
/// **Source:** \[hampson2023\] (18), rewritten: alpha minus the sphere is sag minus mean sag. **Assumes:** `SPHERICAL-WARP`, `LINEAR-FOUNDATION`.
/// **Accuracy:** `the_local_gap_is_the_printed_one_where_that_has_digits_left`.
pub fn local_gap(mean_gap: f64, dome: Dome, distance: f64) -> f64 {
    mean_gap + (sag(dome, distance) - mean_sag(dome))
}
