//! A reading that should not move moves with temperature, by a mechanism that the base model has no place for.

use crate::{
    data::context::Context,
    effects::composed::words::{Driver, InWords, Kinetics, Place},
    effects::effect::{About, Effect, Family, FittedParameter},
    text::{percent_with_sd, rounded, with_sd},
};
use truegap_core::{Drive, EffectId, Parameter, Readout, Stage, simulator::StageName};

/// Temperature coefficient of the reading, at the sensor's own (possibly lagging) temperature; it may change with temperature itself.
pub struct TemperatureCoefficient;

#[derive(Clone, Copy)]
struct Curve {
    per_k: f64,
    /// share of the coefficient that is added per kelvin
    bend_per_k: f64,
    /// growth of the coefficient per kelvin, as a share of what it has become
    growth_per_k: f64,
    /// share of the coefficient by which its change per kelvin changes per kelvin
    third_per_k2: f64,
}

impl Curve {
    /// The influence `above` the reference by so many kelvin, over that of a kelvin.
    fn law(&self, above: f64) -> f64 {
        let grown = self.growth_per_k * above;
        let straight = if grown.abs() < 1e-8 { above * (1.0 + 0.5 * grown) } else { grown.exp_m1() / self.growth_per_k };
        straight + above.powi(2) * (0.5 * self.bend_per_k + self.third_per_k2 * above / 6.0)
    }
}

impl Stage for Curve {
    fn readout(&self, drive: &Drive<'_>, _: &Readout, value: &mut [f64]) {
        for (value, t) in value.iter_mut().zip(drive.temperature_c) {
            *value += self.per_k * self.law(t - drive.reference_c);
        }
    }
}

/// Sibling: an exponential law with the same slope at the reference and a doubling over 300 K, and a cosine in the place of the square.
struct Exponential {
    per_k: f64,
    bend_per_k: f64,
}

impl Stage for Exponential {
    fn readout(&self, drive: &Drive<'_>, _: &Readout, value: &mut [f64]) {
        const SCALE_K: f64 = 433.0;
        for (value, t) in value.iter_mut().zip(drive.temperature_c) {
            let above = (t - drive.reference_c) / SCALE_K;
            *value += self.per_k * SCALE_K * (above.exp_m1() + self.bend_per_k * SCALE_K * versine(above));
        }
    }
}

/// Half a square, nearly: `1 - cos x`, without the loss of digits at small `x`.
fn versine(x: f64) -> f64 {
    2.0 * (0.5 * x).sin().powi(2)
}

/// Usual bend, over the span of what it follows: the coefficient at one end is three times that at the other.
const USUAL_BEND: f64 = 2.0;
/// Most, over the span: a parabola whose turn lies so near the reference, a hundred thousandth of the span, is one about the reference. A crystal is cut so that it turns in the middle of its range, and other
/// drivers have parabolas about their zero.
pub const MOST_BENT: f64 = 1e5;

/// Most growth over the span: a leakage current that doubles every 6 K does so in a span of 80 K.
const MOST_GROWN: f64 = 10.0;

/// Bends from which a search starts: a straight line, and parabolas whose turn lies to either side of the reference.
fn bends(span: f64) -> Vec<Vec<f64>> {
    [0.0, 20.0, -20.0].map(|bend| vec![bend / span, 0.0, 0.0]).to_vec()
}

/// Bend below which it is not spoken of, in standard deviations.
const SPOKEN_OF: f64 = 3.0;

impl Effect for TemperatureCoefficient {
    fn id(&self) -> EffectId {
        EffectId("temperature_coefficient")
    }
    fn stage(&self) -> StageName {
        StageName::Readout
    }
    fn family(&self) -> Family {
        Family::Thermal
    }
    fn in_words(&self, _: &Context<'_>) -> Option<InWords> {
        Some(InWords { place: Place::Readout, driver: Driver::Temperature, kinetics: Kinetics::Static })
    }
    fn about(&self) -> About {
        About {
            physics: "the reading moves with temperature, by a mechanism for which the base model has no place",
            equation: "value = true + k [(exp(g x) - 1) / g + b x^2 / 2 + c x^3 / 6], x = T_s - T0, T_s the temperature behind the thermal path; g = 0 (x for the first part) and c = 0 until rows left out bear one of the two out",
            excitation: "a temperature that changes by some kelvin",
            impostors: &["offset_drift", "thermal_lag", "humidity_uptake"],
            separates: "comes back with the temperature; with a thermal lag it comes back late",
            source: "definition of a temperature coefficient, IEC 60359",
        }
    }
    fn parameters(&self, context: &Context<'_>) -> Vec<Parameter> {
        let scale = context.response_span / context.temperature_span().max(1.0);
        let unit = format!("{}/K", context.simulator.unit());
        let bend = context.temperature_span().max(1.0).recip();
        vec![
            Parameter::normal("per_kelvin", &unit, 0.0, scale, "change of the reading per kelvin at the reference temperature"),
            // over a slope that may be nothing: a parabola that turns at the reference has no slope there
            Parameter::wide("bend", "1/K", USUAL_BEND * bend, "relative change of that per kelvin")
                .within(-MOST_BENT * bend, MOST_BENT * bend),
            Parameter::normal("growth", "1/K", 0.0, USUAL_BEND * bend, "exponential growth of that per kelvin")
                .within(-MOST_GROWN * bend, MOST_GROWN * bend),
            Parameter::wide("third", "1/K^2", (USUAL_BEND * bend).powi(2), "change of the bend per kelvin")
                .within(-(MOST_BENT * bend).powi(2), (MOST_BENT * bend).powi(2)),
        ]
    }
    fn starts(&self, context: &Context<'_>) -> Vec<Vec<f64>> {
        bends(context.temperature_span().max(1.0))
    }
    fn may_be_nothing(&self) -> &'static [&'static str] {
        &["bend"]
    }
    fn other_laws(&self) -> &'static [&'static [&'static str]] {
        &[&["growth"], &["third"]]
    }
    fn testable(&self, context: &Context<'_>) -> Result<(), String> {
        context.has(StageName::Readout)?;
        if context.has_plates() {
            return Err("the base model has places for temperature of its own (permittivity, warp, modulus)".into());
        }
        context.needs_some_temperature()
    }
    fn with(&self, values: &[f64], _: &Context<'_>) -> Box<dyn Stage> {
        let [growth_per_k, third_per_k2] = [2, 3].map(|place| values.get(place).copied().unwrap_or(0.0));
        Box::new(Curve { per_k: values[0], bend_per_k: values[1], growth_per_k, third_per_k2 })
    }
    fn sibling(&self, values: &[f64], _: &Context<'_>) -> Option<Box<dyn Stage>> {
        Some(Box::new(Exponential { per_k: values[0], bend_per_k: values[1] }))
    }
    fn says(&self, fitted: &[FittedParameter]) -> String {
        said(fitted, |above| {
            let way = if above < 0.0 { "below" } else { "above" };
            format!("{} {way} the reference", rounded(above.abs(), "K"))
        })
    }
    fn told(&self, fitted: &[FittedParameter], context: &Context<'_>, _: &[(EffectId, Vec<FittedParameter>)]) -> String {
        said(fitted, |above| format!("at {}", rounded(context.reference_c + above, "degC")))
    }
}

/// What is told, with the place of a turn in words, which lies so many kelvin above the reference.
fn said(fitted: &[FittedParameter], turn: impl Fn(f64) -> String) -> String {
    let (slope, bend) = (&fitted[0], &fitted[1]);
    let seen = bend.value.abs() > SPOKEN_OF * bend.sd;
    // it turns within half a span of the reference, where a slope says little; of a slope that is nothing the bend is as unsure as it is large
    let no_slope = slope.value.abs() < SPOKEN_OF * slope.sd;
    if (seen || no_slope) && bend.value.abs() > bend.parameter.sd() {
        let square = rounded(0.5 * slope.value * bend.value, &format!("{}^2", slope.parameter.unit));
        return format!(
            "the reading follows temperature along a parabola of {square}, which turns {}",
            turn(-bend.value.recip())
        );
    }
    let bent = if seen {
        let way = if bend.value > 0.0 { "more" } else { "less" };
        format!(", {} {way} with every kelvin", percent_with_sd(bend.value.abs(), bend.sd))
    } else {
        String::new()
    };
    let growth = fitted.get(2).filter(|growth| growth.value.abs() > SPOKEN_OF * growth.sd);
    let grows = growth.map_or_else(String::new, |growth| {
        let kelvin = rounded(std::f64::consts::LN_2 / growth.value.abs(), "K");
        format!(" at the reference, and twice as much every {kelvin} {}", if growth.value > 0.0 { "up" } else { "down" })
    });
    format!("the reading moves by {} with temperature{grows}{bent}", with_sd(slope.value, slope.sd, &slope.parameter.unit))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A leakage that doubles every 10 K from 1 at the reference is 1 more after 10 K, and 3 more after 20; in slopes at the reference ten over the logarithm of 2.
    #[test]
    fn a_leakage_doubles_every_ten_kelvin() {
        let leak = Curve { per_k: 0.1 * 2f64.ln(), bend_per_k: 0.0, growth_per_k: 0.1 * 2f64.ln(), third_per_k2: 0.0 };
        for (above, exact) in [(10.0, 1.0), (20.0, 3.0), (-10.0, -0.5)] {
            approx::assert_relative_eq!(leak.per_k * leak.law(above), exact, max_relative = 1e-12);
        }
        let near = |growth_per_k: f64| Curve { growth_per_k, per_k: 1.0, ..leak }.law(1.0);
        approx::assert_relative_eq!(near(0.999_999e-8), near(1.000_001e-8), max_relative = 1e-13);
    }

    /// At the reference the slope is nothing, and the bend is as unsure as it is large.
    #[test]
    fn a_parabola_that_turns_at_the_reference_is_told_as_one() {
        let number =
            |parameter: Parameter, value: f64, sd: f64| FittedParameter { parameter, value, sd, sd_of_fit: sd, at_limit: false };
        let slope = Parameter::normal("per_kelvin", "V/K", 0.0, 1.0, "slope");
        let fitted = [number(slope, -1e-4, 1e-4), number(Parameter::wide("bend", "1/K", 0.1, "bend"), 400.0, 400.0)];
        let says = TemperatureCoefficient.says(&fitted);
        assert!(says.contains("along a parabola of") && says.contains("below the reference"), "{says}");
    }

    /// The third derivative of a cubic is its third number.
    #[test]
    fn a_cubic_has_the_bend_at_the_reference_and_its_change() {
        let cubic = Curve { per_k: 1.0, bend_per_k: 0.2, growth_per_k: 0.0, third_per_k2: 0.06 };
        approx::assert_relative_eq!(cubic.law(10.0), 10.0 + 10.0 + 10.0, max_relative = 1e-12);
        approx::assert_relative_eq!(cubic.law(-10.0), -10.0 + 10.0 - 10.0, max_relative = 1e-12);
    }
}
