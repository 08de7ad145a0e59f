//! The paper's double integral (19) by adaptive quadrature: the slow route that the closed form is measured against.
//!
//! Limits: Cartesian limits as printed; the square roots at the ends of both ranges cost many halvings. The sensor model never comes here.

use super::{integral::BentPlates, warp::sag};

/// Nodes of the 15-point Kronrod rule, positive half; every second one belongs to the 7-point Gauss rule.
const NODES: [f64; 8] = [
    0.991_455_371_120_812_6,
    0.949_107_912_342_758_5,
    0.864_864_423_359_769_1,
    0.741_531_185_599_394_4,
    0.586_087_235_467_691_1,
    0.405_845_151_377_397_2,
    0.207_784_955_007_898_47,
    0.0,
];
/// Weights of the 15-point rule.
const KRONROD: [f64; 8] = [
    0.022_935_322_010_529_224,
    0.063_092_092_629_978_55,
    0.104_790_010_322_250_18,
    0.140_653_259_715_525_92,
    0.169_004_726_639_267_9,
    0.190_350_578_064_785_4,
    0.204_432_940_075_298_9,
    0.209_482_141_084_727_82,
];
/// Weights of the 7-point rule, for the nodes 1, 3, 5, 7.
const GAUSS: [f64; 4] = [0.129_484_966_168_869_7, 0.279_705_391_489_276_64, 0.381_830_050_505_118_93, 0.417_959_183_673_469_4];

/// An interval of integration.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Interval {
    /// lower limit
    pub from: f64,
    /// upper limit
    pub to: f64,
}

/// Integral of `f` by adaptive halving with a Gauss-Kronrod pair, to an absolute tolerance.
///
/// **Accuracy:** exact for polynomials up to degree 22, `the_kronrod_rule_is_exact_for_polynomials`; the error estimate is that of the *coarser* rule, so
/// results are usually far better than asked for. At most 48 halvings.
pub fn adaptive(f: &dyn Fn(f64) -> f64, range: Interval, tolerance: f64) -> f64 {
    refine(f, range, tolerance, 48)
}

fn refine(f: &dyn Fn(f64) -> f64, range: Interval, tolerance: f64, depth: u32) -> f64 {
    let (fine, coarse) = kronrod(f, range);
    // the fine rule's error is about (200 |fine - coarse|)^1.5, as in QUADPACK; near a square root the plain difference is the safe measure
    if depth == 0 || (fine - coarse).abs() <= tolerance.max(4.0 * f64::EPSILON * fine.abs()) {
        return fine;
    }
    let middle = 0.5 * (range.from + range.to);
    let left = refine(f, Interval { to: middle, ..range }, 0.5 * tolerance, depth - 1);
    left + refine(f, Interval { from: middle, ..range }, 0.5 * tolerance, depth - 1)
}

/// The 15-point and the 7-point value.
fn kronrod(f: &dyn Fn(f64) -> f64, range: Interval) -> (f64, f64) {
    let centre = 0.5 * (range.from + range.to);
    let half = 0.5 * (range.to - range.from);
    let (mut fine, mut coarse) = (0.0, 0.0);
    for (i, &node) in NODES.iter().enumerate() {
        let value = if node == 0.0 { f(centre) } else { f(centre - half * node) + f(centre + half * node) };
        fine += KRONROD[i] * value;
        if i % 2 == 1 {
            coarse += GAUSS[i / 2] * value;
        }
    }
    (fine * half, coarse * half)
}

/// Integral of 1/gap over the disc, m, by nested adaptive quadrature to a relative tolerance.
///
/// $$ \int_{-r}^{r} \int_{-\sqrt{r^2 - x^2}}^{\sqrt{r^2 - x^2}} \frac{dy\,dx}{d(x, y)} $$
///
/// | symbol  | argument   | unit |
/// |---------|------------|------|
/// | d, r    | `plates`   | m    |
/// |         | `relative` tolerance | - |
///
/// **Source:** [hampson2023] (19), as printed. **Accuracy:** `the_closed_form_agrees_with_the_papers_double_integral`.
pub fn plate_integral_by_quadrature(plates: BentPlates, relative: f64) -> f64 {
    let r = plates.dome.radius;
    let tightest = plates.centre_gap.min(plates.rim_gap());
    let loosest = plates.centre_gap.max(plates.rim_gap());
    let scale = relative * std::f64::consts::PI * r * r / loosest;
    let inner_tolerance = scale / (4.0 * r) * (tightest / loosest).min(1.0);
    let strip = |x: f64| {
        let end = ((r - x) * (r + x)).sqrt();
        let gap = |y: f64| 1.0 / (plates.centre_gap + sag(plates.dome, x.hypot(y)));
        adaptive(&gap, Interval { from: -end, to: end }, inner_tolerance)
    };
    adaptive(&strip, Interval { from: -r, to: r }, scale)
}
