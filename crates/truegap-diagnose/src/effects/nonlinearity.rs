//! The law from what moves the reading to the reading is bent, where the base model has a straight one.

use crate::{
    data::context::Context,
    effects::composed::words::{Driver, InWords, Kinetics, Place},
    effects::effect::{About, Effect, Family, FittedParameter},
    text::{percent_of, percent_with_sd},
};
use truegap_core::{Drive, EffectId, Parameter, Readout, Stage, simulator::StageName};

/// A smooth bend of the characteristic between the ends of the span, where it is none.
pub struct Nonlinearity;

/// Weights that a curve with one bend or two does without.
const FURTHER: [&str; 2] = ["sway", "ripple"];

/// Places at which the mean square of a departure is taken.
const PLACES: usize = 48;

/// Root mean square that is added to that of a shape, so that none is blown up to be one.
const LEAST: f64 = 0.02;

/// Where the characteristic is steep, and by how much it departs from the straight line between its ends.
struct Bend {
    /// factor on the shape
    scale: f64,
    /// the scale along which the shape is told
    scale_of: Warped,
    /// weights of Legendre's first polynomials along the warped scale
    weights: [f64; 5],
}

/// A scale that is warped at one place, 0 at 0 and 1 at 1.
struct Warped {
    /// place, in spans, where it is widest
    middle: f64,
    /// width of that place, in spans; a wide one warps nothing
    width: f64,
    warp: Warp,
    /// what the warp makes of 0, and from there to 1
    first: f64,
    all: f64,
}

/// An odd function that grows like a logarithm, and its slope.
#[derive(Clone, Copy)]
struct Warp {
    at: fn(f64) -> f64,
    slope: fn(f64) -> f64,
}

const ASINH: Warp = Warp { at: asinh, slope: |u| (1.0 + u * u).sqrt().recip() };

/// For the sibling: the same straight beginning and nearly the same end.
const LOGARITHM: Warp = Warp { at: |u| u.signum() * u.abs().ln_1p(), slope: |u| (1.0 + u.abs()).recip() };

/// The inverse hyperbolic sine. Squared, `u` is far from overflowing; the function of the standard library guards against that in each row of each fit.
fn asinh(u: f64) -> f64 {
    let (size, root) = (u.abs(), (1.0 + u * u).sqrt());
    // below, the logarithm of 1 + size would lose the digits of size
    let value = if size > 0.5 { (size + root).ln() } else { (size + size * size / (1.0 + root)).ln_1p() };
    value.copysign(u)
}

impl Warped {
    fn of(middle: f64, width: f64, warp: Warp) -> Self {
        let [first, last] = [0.0, 1.0].map(|x| (warp.at)((x - middle) / width));
        Self { middle, width, warp, first, all: last - first }
    }

    fn at(&self, x: f64) -> f64 {
        ((self.warp.at)((x - self.middle) / self.width) - self.first) / self.all
    }

    fn slope(&self, x: f64) -> f64 {
        (self.warp.slope)((x - self.middle) / self.width) / (self.width * self.all)
    }
}

impl Bend {
    fn of(values: &[f64], warp: Warp) -> Self {
        let shape = Self {
            scale: 1.0,
            scale_of: Warped::of(values[1], values[2], warp),
            weights: std::array::from_fn(|k| values[3 + k]),
        };
        let places = (0..PLACES).map(|k| (k as f64 + 0.5) / PLACES as f64);
        let square = places.map(|x| shape.at(x).powi(2)).sum::<f64>() / PLACES as f64;
        Self { scale: values[0] / square.sqrt().hypot(LEAST), ..shape }
    }

    /// Departure from the straight line between the ends, over the span, `x` of the span above the zero; straight on beyond the ends.
    fn at(&self, x: f64) -> f64 {
        let inside = x.clamp(0.0, 1.0);
        let w = self.scale_of.at(inside);
        let departure = w - inside + 4.0 * w * (1.0 - w) * self.weighted(2.0 * w - 1.0);
        if x == inside {
            return self.scale * departure;
        }
        // of 4 w (1 - w), the slope at the ends is 4 and -4
        let of_arch = if x > 1.0 { -4.0 * self.weighted(1.0) } else { 4.0 * self.weighted(-1.0) };
        self.scale * (departure + (self.scale_of.slope(inside) * (1.0 + of_arch) - 1.0) * (x - inside))
    }

    fn weighted(&self, u: f64) -> f64 {
        let [even, lean, crowd, sway, ripple] = self.weights;
        let square = u * u;
        let third = 0.5 * u * (5.0 * square - 3.0);
        let fourth = 0.125 * (square * (35.0 * square - 30.0) + 3.0);
        even + lean * u + crowd * 0.5 * (3.0 * square - 1.0) + sway * third + ripple * fourth
    }

    /// Greatest departure between the ends, and where it is: shares of the span.
    fn most(&self) -> (f64, f64) {
        const LOOKED_AT: usize = 200;
        let all = (0..=LOOKED_AT).map(|k| k as f64 / LOOKED_AT as f64).map(|x| (self.at(x), x));
        all.max_by(|a, b| a.0.abs().total_cmp(&b.0.abs())).unwrap_or_default()
    }
}

impl Stage for Bend {
    fn readout(&self, _: &Drive<'_>, readout: &Readout, value: &mut [f64]) {
        bent(readout, value, self.scale, |x| self.at(x));
    }
}

fn bent(readout: &Readout, value: &mut [f64], size: f64, law: impl Fn(f64) -> f64) {
    if readout.span == 0.0 || size == 0.0 {
        return;
    }
    for value in value {
        *value += readout.span * law((*value - readout.zero) / readout.span);
    }
}

impl Effect for Nonlinearity {
    fn id(&self) -> EffectId {
        EffectId("nonlinearity")
    }
    fn stage(&self) -> StageName {
        StageName::Readout
    }
    fn family(&self) -> Family {
        Family::Readout
    }
    fn in_words(&self, _: &Context<'_>) -> Option<InWords> {
        Some(InWords { place: Place::Readout, driver: Driver::Reading, kinetics: Kinetics::Static })
    }
    fn about(&self) -> About {
        About {
            physics: "the characteristic is bent where the base model has a straight one: linearity error of a sensor, an amplifier, a law of nature",
            equation: "value = true + b S g / rms(g), g = w - x + 4 w (1 - w) [c0 P0(u) + ... + c4 P4(u)], P Legendre's polynomials, x the reading above its zero over the span S, w(x) from asinh((x - m) / h) with w(0) = 0 and w(1) = 1, u = 2 w - 1; straight on beyond the ends",
            excitation: "readings all over the span",
            impostors: &["saturation", "temperature_coefficient", "driver_coefficient", "offset_drift"],
            separates: "one curve, up and down, slow and fast, today and tomorrow",
            source: "terminal-based nonlinearity, IEC 61298-2; Pallas-Areny & Webster, Sensors and Signal Conditioning, sec. 1.3",
        }
    }
    fn describes(&self) -> bool {
        true
    }
    fn may_be_nothing(&self) -> &'static [&'static str] {
        &FURTHER
    }
    fn may_be_more(&self) -> &'static [&'static str] {
        &FURTHER
    }
    fn parameters(&self, _: &Context<'_>) -> Vec<Parameter> {
        let weight =
            |name: &str, sd: f64, meaning: &str| Parameter::normal(name, "1", 0.0, sd, meaning).within(-8.0 * sd, 8.0 * sd);
        vec![
            Parameter::normal(
                "bend",
                "spans",
                0.0,
                0.1,
                "departure from the straight line between the ends, root mean square over the span",
            ),
            Parameter::normal("middle", "spans", 0.5, 0.5, "place where the curve is steepest or flattest").within(-0.5, 1.5),
            Parameter::log_normal("width", "spans", 1.0, 1.5, "width of that place").within(3e-3, 30.0),
            weight("even", 1.0, "part that is the same to both sides of the middle"),
            weight("lean", 0.7, "part that leans to the upper end"),
            weight("crowd", 0.5, "part that crowds to both ends"),
            weight("sway", 0.35, "part that turns twice"),
            weight("ripple", 0.25, "part that turns three times"),
        ]
    }
    fn starts(&self, _: &Context<'_>) -> Vec<Vec<f64>> {
        let plain = |even: f64, lean: f64| vec![0.5, 5.0, even, lean, 0.0, 0.0, 0.0];
        let steep = |middle: f64| vec![middle, 0.08, 0.0, 0.0, 0.0, 0.0, 0.0];
        vec![plain(1.0, 0.0), steep(0.0), steep(1.0), steep(0.5), plain(0.0, 1.0)]
    }
    fn comes_down_to(&self) -> Option<EffectId> {
        Some(EffectId("gain_error"))
    }
    fn testable(&self, context: &Context<'_>) -> Result<(), String> {
        context.has(StageName::Readout)?;
        if context.has_plates() {
            return Err("the base model has places for a bent law of its own (stiffening, gap, saturation)".into());
        }
        if !context.simulator.moves() {
            return Err("a value that does not move is not bent".into());
        }
        if !context.moved.anything() {
            return Err("the base model follows time alone; a bend in time is a drift, a decay or a lag".into());
        }
        context.needs_movement()
    }
    fn with(&self, values: &[f64], _: &Context<'_>) -> Box<dyn Stage> {
        Box::new(Bend::of(values, ASINH))
    }
    fn sibling(&self, values: &[f64], _: &Context<'_>) -> Option<Box<dyn Stage>> {
        Some(Box::new(Bend::of(values, LOGARITHM)))
    }
    fn says(&self, fitted: &[FittedParameter]) -> String {
        let values: Vec<f64> = fitted.iter().map(|p| p.value).collect();
        let (most, at) = Bend::of(&values, ASINH).most();
        // the greatest departure is in proportion to the size
        let sd = if fitted[0].value == 0.0 { fitted[0].sd } else { fitted[0].sd * (most / fitted[0].value).abs() };
        let side = if most < 0.0 { "below" } else { "above" };
        format!(
            "the characteristic is bent: at {} of its span it lies {} of the span {side} the straight line between its ends",
            percent_of(at),
            percent_with_sd(most.abs(), sd)
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn without_a_steep_place_it_is_a_parabola_through_the_ends() {
        // so wide that the scale departs from a straight one by less than 1 / (6 h^2); the parabola 4 x (1 - x) has the root mean square sqrt(8 / 15)
        let bend = Bend::of(&[0.1, 0.5, 1e4, 1.0, 0.0, 0.0, 0.0, 0.0], ASINH);
        assert_eq!((bend.at(0.0), bend.at(1.0)), (0.0, 0.0));
        let scale = 0.1 / (8.0f64 / 15.0).sqrt().hypot(LEAST);
        // midpoint rule with 48 places: 1e-4
        approx::assert_relative_eq!(bend.at(0.2), scale * 4.0 * 0.2 * 0.8, max_relative = 1e-3);
        approx::assert_relative_eq!(bend.most().0, scale, max_relative = 1e-3);
    }

    #[test]
    fn the_inverse_hyperbolic_sine_is_that_of_the_standard_library() {
        for size in [0.0, 1e-300, 1e-12, 1e-3, 0.4999, 0.5, 0.5001, 1.0, 7.0, 1e6] {
            for u in [size, -size] {
                // some roundings of the last digit
                approx::assert_relative_eq!(asinh(u), u.asinh(), max_relative = 1e-15);
            }
        }
    }

    #[test]
    fn the_parts_of_its_arch_are_legendres_polynomials() {
        // without a steep place u is 2 x - 1; by Bonnet's recursion from 1 and u
        let legendre = |degree: usize, u: f64| {
            let next = |(before, now): (f64, f64), n: usize| {
                let n = n as f64;
                (now, ((2.0 * n + 1.0) * u * now - n * before) / (n + 1.0))
            };
            if degree == 0 { 1.0 } else { (1..degree).fold((1.0, u), next).1 }
        };
        for degree in 0..5 {
            let weights = std::array::from_fn(|k| if k == degree { 1.0 } else { 0.0 });
            let bend = Bend { scale: 1.0, scale_of: Warped::of(0.5, 1e4, ASINH), weights };
            for x in [0.1, 0.35, 0.8] {
                approx::assert_abs_diff_eq!(bend.at(x), 4.0 * x * (1.0 - x) * legendre(degree, 2.0 * x - 1.0), epsilon = 1e-7);
            }
        }
    }

    #[test]
    fn a_narrow_place_at_the_lower_end_is_a_logarithm() {
        let bend = Bend { scale: 1.0, scale_of: Warped::of(0.0, 1e-3, ASINH), weights: [0.0; 5] };
        // asinh(x / h) is ln(2 x / h) far above h: straight line and departure together are 1 + ln(x) / ln(2 / h)
        for x in [0.05, 0.3, 0.8] {
            approx::assert_relative_eq!(x + bend.at(x), 1.0 + x.ln() / 2e3_f64.ln(), epsilon = 1e-4);
        }
    }

    #[test]
    fn it_goes_straight_on_beyond_the_ends_without_a_kink() {
        let bend = Bend::of(&[0.1, 0.3, 0.2, 1.5, -0.4, 0.3, -0.5, 0.2], ASINH);
        for end in [0.0, 1.0] {
            let step = 1e-6;
            let (inside, outside) = if end == 0.0 { (step, -step) } else { (1.0 - step, 1.0 + step) };
            // second order in the step on one side, exact on the other
            approx::assert_abs_diff_eq!(bend.at(inside) + bend.at(outside), 2.0 * bend.at(end), epsilon = 1e-10);
        }
        approx::assert_relative_eq!(bend.at(1.4), 4.0 * bend.at(1.1), max_relative = 1e-12);
    }
}
