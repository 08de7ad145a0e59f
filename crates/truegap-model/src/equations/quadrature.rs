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
const GAUSS: [f64; 4] = [0.129_484_966_168_869_7, 0.279_705_391_489_276_64, 0.381_830_050_505_118_9, 0.417_959_183_673_469_4];

/// An interval of integration.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Interval {
    /// lower limit
    pub from: f64,
    /// upper limit
    pub to: f64,
}

/// Most intervals that a range is cut into.
const LIMIT: usize = 200;

/// Integral of `f` to a relative tolerance: the interval with the largest error is halved until the sum of all errors is small enough.
///
/// **Source:** the strategy and the error estimate of QUADPACK's QAG. **Accuracy:** exact for polynomials up to degree 22,
/// `the_kronrod_rule_is_exact_for_polynomials`. Stops at 200 intervals, with what it has.
pub fn adaptive(f: &dyn Fn(f64) -> f64, range: Interval, relative: f64) -> f64 {
    let mut pieces = vec![Piece::new(f, range)];
    loop {
        let value: f64 = pieces.iter().map(|p| p.value).sum();
        let error: f64 = pieces.iter().map(|p| p.error).sum();
        let worst = (0..pieces.len()).max_by(|&a, &b| pieces[a].error.total_cmp(&pieces[b].error));
        let Some(worst) = worst.filter(|_| error > relative * value.abs() && pieces.len() < LIMIT) else { return value };
        let Interval { from, to } = pieces[worst].range;
        let middle = 0.5 * (from + to);
        pieces[worst] = Piece::new(f, Interval { from, to: middle });
        pieces.push(Piece::new(f, Interval { from: middle, to }));
    }
}

/// An interval with its value and the estimate of its error.
struct Piece {
    range: Interval,
    value: f64,
    error: f64,
}

impl Piece {
    fn new(f: &dyn Fn(f64) -> f64, range: Interval) -> Self {
        let (centre, half) = (0.5 * (range.from + range.to), 0.5 * (range.to - range.from));
        let mut samples = [(0.0, 0.0); 8];
        for (sample, node) in samples.iter_mut().zip(NODES) {
            *sample = if node == 0.0 { (f(centre), 0.0) } else { (f(centre - half * node), f(centre + half * node)) };
        }
        let fine: f64 = samples.iter().zip(KRONROD).map(|((a, b), w)| w * (a + b)).sum();
        let coarse: f64 = samples.iter().skip(1).step_by(2).zip(GAUSS).map(|((a, b), w)| w * (a + b)).sum();
        let size: f64 = samples.iter().zip(KRONROD).map(|((a, b), w)| w * (a.abs() + b.abs())).sum();
        let difference = (fine - coarse).abs();
        let error = size * (200.0 * difference / size).powf(1.5).min(1.0);
        // below some fifty roundings the estimate is noise, and halving does not help
        let error = if difference <= 50.0 * f64::EPSILON * size { 0.0 } else { error };
        Self { range, value: fine * half, error: error * half.abs() }
    }
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
/// **Source:** \[hampson2023\] (19), as printed. **Accuracy:** `the_closed_form_agrees_with_the_papers_double_integral`.
pub fn plate_integral_by_quadrature(plates: BentPlates, relative: f64) -> f64 {
    let r = plates.dome.radius;
    let strip = |x: f64| {
        let end = ((r - x) * (r + x)).sqrt();
        let gap = |y: f64| 1.0 / (plates.centre_gap + sag(plates.dome, x.hypot(y)));
        adaptive(&gap, Interval { from: -end, to: end }, relative)
    };
    adaptive(&strip, Interval { from: -r, to: r }, relative)
}
