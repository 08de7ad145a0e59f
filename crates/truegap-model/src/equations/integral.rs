//! The capacitance integral (19) over a circular plate in closed form.
//!
//! Limits: a spherical dome whose centre and rim are both clear of the other plate; elsewhere NaN, which the callers turn into an error.

use super::warp::{Dome, mean_sag, rim_sag};
use std::f64::consts::PI;

/// A plate bent to a dome above a flat one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BentPlates {
    /// shape of the bent plate
    pub dome: Dome,
    /// separation at the centre, m
    pub centre_gap: f64,
}

impl BentPlates {
    /// Plates at a mean separation, the bent one settled about its mean height: (18).
    pub fn settled(mean_gap: f64, dome: Dome) -> Self {
        Self { dome, centre_gap: mean_gap - mean_sag(dome) }
    }

    /// Separation at the rim, m.
    pub fn rim_gap(self) -> f64 {
        self.centre_gap + rim_sag(self.dome)
    }

    /// Whether the plates are apart everywhere.
    pub fn apart(self) -> bool {
        self.centre_gap > 0.0 && self.rim_gap() > 0.0
    }

    /// Integral of 1/gap over the disc, m; times a permittivity it is (19).
    ///
    /// $$ \int \frac{dA}{d} = 2\pi\left[(R + g_0) \ln\left(1 + \frac{s}{g_0}\right) - s\right]
    ///    = 2\pi\left[\frac{r^2}{g_0 (1 + c)} \frac{\ln(1 + x)}{x} + g_0 (\ln(1 + x) - x)\right], \qquad x = \frac{s}{g_0} $$
    ///
    /// | symbol | argument          | unit |
    /// |--------|-------------------|------|
    /// | R = 1/k, r | `dome`        | m    |
    /// | g0     | `centre_gap`      | m    |
    /// | s, c   | rim sag, cos of the half-angle, from `dome` | m, - |
    ///
    /// **Source:** \[hampson2023\] (19) integrated over rings; the second form is own and holds at k = 0 and for both signs without cancellation.
    /// **Assumes:** `SPHERICAL-WARP`, `NO-FRINGING`. **Accuracy:** 1e-13 relative from flat to plates that touch at 1e-6 of the mean gap, both signs,
    /// `the_closed_form_is_right_from_flat_to_nearly_touching` (50-digit arithmetic).
    #[inline]
    pub fn integral(self) -> f64 {
        let Self { dome, centre_gap: g } = self;
        let half_chord = self.half_chord();
        let s = dome.curvature * half_chord;
        let x = s / g;
        let (over_x, less_x) = if x.abs() < SMALL { small_logs(x) } else { self.logs(s, x) };
        2.0 * PI * (half_chord / g * over_x + g * less_x)
    }

    /// [`BentPlates::integral`] of many plates, to the last bit: all that is not a logarithm is computed side by side.
    #[inline(always)]
    pub fn integrals<const N: usize>(plates: impl Fn(usize) -> Self) -> [f64; N] {
        let half_chord: [f64; N] = std::array::from_fn(|k| plates(k).half_chord());
        let sag: [f64; N] = std::array::from_fn(|k| plates(k).dome.curvature * half_chord[k]);
        let x: [f64; N] = std::array::from_fn(|k| sag[k] / plates(k).centre_gap);
        let (mut over_x, mut less_x) = ([0.0; N], [0.0; N]);
        // where all are small no row has a way of its own
        if x.iter().fold(true, |all, x| all & (x.abs() < SMALL)) {
            (0..N).for_each(|k| (over_x[k], less_x[k]) = small_logs(x[k]));
        } else {
            for k in 0..N {
                (over_x[k], less_x[k]) = if x[k].abs() < SMALL { small_logs(x[k]) } else { plates(k).logs(sag[k], x[k]) };
            }
        }
        std::array::from_fn(|k| {
            let g = plates(k).centre_gap;
            2.0 * PI * (half_chord[k] / g * over_x[k] + g * less_x[k])
        })
    }

    #[inline]
    fn half_chord(self) -> f64 {
        self.dome.radius * self.dome.radius / (1.0 + self.dome.cosine())
    }

    /// `ln(1 + x) / x` and `ln(1 + x) - x` away from zero.
    #[inline]
    fn logs(self, sag: f64, x: f64) -> (f64, f64) {
        let log = if x > -0.5 { x.ln_1p() } else { ((self.centre_gap + sag + self.sag_rounding(sag)) / self.centre_gap).ln() };
        (log / x, log - x)
    }

    /// What the rounded rim sag lacks: a Newton step on k s² - 2 s + k r² = 0, its residual free of rounding. Only it is left of a rim gap near zero.
    fn sag_rounding(self, sag: f64) -> f64 {
        let Dome { curvature: k, radius: r } = self.dome;
        let kr = Product::of(k, r);
        let ks = Product::of(k, sag);
        let first = Product::of(kr.high, r);
        let second = Product::of(ks.high, sag);
        let (sum, lost) = exact_sum(first.high, second.high);
        // sum is 2 s but for its last digits, so their difference is exact
        let high = sum - 2.0 * sag;
        let low = lost + first.low + kr.low * r + second.low + ks.low * sag;
        let slope = 2.0 - 2.0 * ks.high;
        // a hemisphere: the two roots meet, and the rounded sag is right to the last digit
        if slope > 0.0 { (high + low) / slope } else { 0.0 }
    }
}

/// A product and its rounding error.
struct Product {
    high: f64,
    low: f64,
}

impl Product {
    fn of(a: f64, b: f64) -> Self {
        let high = a * b;
        Self { high, low: a.mul_add(b, -high) }
    }
}

/// A sum and its rounding error.
fn exact_sum(a: f64, b: f64) -> (f64, f64) {
    let sum = a + b;
    let second = sum - a;
    (sum, (a - (sum - second)) + (b - second))
}

/// Below this share of the centre gap the logarithm is a series.
const SMALL: f64 = 0.01;

/// `ln(1 + x) / x` and `ln(1 + x) - x` by the series of `2 atanh(x / (2 + x))`.
#[inline]
fn small_logs(x: f64) -> (f64, f64) {
    let y = x / (2.0 + x);
    let y2 = y * y;
    // atanh(y) / y - 1, y² < 2.6e-5: four terms reach 1e-20
    let tail = y2 * (1.0 / 3.0 + y2 * (1.0 / 5.0 + y2 * (1.0 / 7.0 + y2 / 9.0)));
    let half = 2.0 / (2.0 + x);
    // ln(1 + x) = half x (1 + tail), and half - 1 = -x / (2 + x)
    (half + half * tail, x * (half * tail - y))
}
