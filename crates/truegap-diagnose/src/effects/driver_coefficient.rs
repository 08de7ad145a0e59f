//! The reading moves with a recorded driver that the base model does not know.

use crate::{
    data::context::Context,
    effects::composed::words::{InWords, Kinetics, Place},
    effects::{
        course::Course,
        effect::{About, Effect, Family, FittedParameter},
        temperature_coefficient::MOST_BENT,
    },
    text::with_sd,
};
use truegap_core::{Drive, EffectId, Parameter, Readout, Stage, simulator::StageName};

/// Coefficient of the reading for the moving driver of this number; it may change with the driver itself.
pub struct DriverCoefficient(pub usize);

struct Curve {
    per_unit: f64,
    /// share of the coefficient that is added per unit of the driver
    bend: f64,
    /// what is added to an exponent of 1
    power: f64,
    /// weights of the third and the fourth Legendre polynomial over the driver's range, relative to the change over half of it
    turns: [f64; 2],
    /// least and greatest value of the driver
    ends: [f64; 2],
    course: Course,
}

impl Curve {
    fn apply(&self, drive: &Drive<'_>, value: &mut [f64], law: impl Fn(f64) -> f64) {
        let Some(x) = self.course.column(drive) else { return };
        value.iter_mut().zip(x).for_each(|(value, x)| *value += self.per_unit * law(*x));
    }

    /// The influence at `x`, over that of a unit.
    fn law(&self, x: f64) -> f64 {
        let [low, high] = self.ends;
        let half = (0.5 * (high - low)).max(f64::MIN_POSITIVE);
        let raised = if self.power == 0.0 || x == 0.0 { x } else { x * (x / low.abs().max(high.abs())).abs().powf(self.power) };
        let turned = if self.turns == [0.0; 2] {
            0.0
        } else {
            let u = (x - low) / half - 1.0;
            let [third, fourth] = legendre(u);
            half * (self.turns[0] * third + self.turns[1] * fourth)
        };
        raised * (1.0 + 0.5 * self.bend * x) + turned
    }
}

/// The Legendre polynomials of third and fourth order: 1 at the upper end.
pub fn legendre(u: f64) -> [f64; 2] {
    [0.5 * u * (5.0 * u * u - 3.0), 0.125 * (35.0 * u.powi(4) - 30.0 * u * u + 3.0)]
}

impl Stage for Curve {
    fn readout(&self, drive: &Drive<'_>, _: &Readout, value: &mut [f64]) {
        self.apply(drive, value, |x| self.law(x));
    }
}

/// Sibling: a law that bends off either way, a fifth of it at the far end of the driver's range.
struct Flattening(Curve, f64);

impl Stage for Flattening {
    fn readout(&self, drive: &Drive<'_>, _: &Readout, value: &mut [f64]) {
        self.0.apply(drive, value, |x| self.1 * (x / self.1).asinh());
    }
}

const IDS: [&str; 2] = ["driver_coefficient", "second_driver_coefficient"];

/// Bend over the range, either way, from which a search starts as well where the driver has both signs.
const BENT: f64 = 20.0;

impl DriverCoefficient {
    fn curve(&self, values: &[f64], context: &Context<'_>) -> Curve {
        let course = Course::or_load(context, self.0);
        let [power, third, fourth] = [2, 3, 4].map(|place| values.get(place).copied().unwrap_or(0.0));
        Curve { per_unit: values[0], bend: values[1], power, turns: [third, fourth], ends: course.ends(context), course }
    }
}

impl Effect for DriverCoefficient {
    fn id(&self) -> EffectId {
        EffectId(IDS[self.0.min(1)])
    }
    fn stage(&self) -> StageName {
        StageName::Readout
    }
    fn family(&self) -> Family {
        Family::Environment
    }
    fn in_words(&self, context: &Context<'_>) -> Option<InWords> {
        let driver = Course::of(context, self.0)?.driver(context);
        Some(InWords { place: Place::Readout, driver, kinetics: Kinetics::Static })
    }
    fn about(&self) -> About {
        About {
            physics: "the reading moves with a recorded driver (a position, a supply, a pump) for which the base model has no place",
            equation: "value = true + k [x |x / x1|^p (1 + b x / 2) + h (c P3(u) + d P4(u))], x the driver as recorded, x1 its largest, u from -1 to 1 over its range of 2 h; p = 0 and c = d = 0 until rows left out bear one of the two laws out",
            excitation: "a column under [drivers] that changes",
            impostors: &["friction", "offset_drift", "temperature_coefficient"],
            separates: "comes back with the driver, at once and from either side",
            source: "definition of an influence coefficient, IEC 60359",
        }
    }
    fn parameters(&self, context: &Context<'_>) -> Vec<Parameter> {
        let course = Course::or_load(context, self.0);
        let (bend, unit) = (course.span(context).recip(), course.unit(context));
        vec![
            course.influence(context, "change of the reading per unit of the driver"),
            // over a slope that may be nothing: a parabola that turns at 0 has no slope there
            Parameter::wide("bend", &format!("1/{unit}"), bend, "relative change of that per unit")
                .within(-MOST_BENT * bend, MOST_BENT * bend),
            Parameter::normal("power", "1", 0.0, 0.7, "exponent of the law, less 1").within(-0.8, 3.0),
            Parameter::normal("third", "1", 0.0, 0.3, "part of third order, over the straight part").within(-3.0, 3.0),
            Parameter::normal("fourth", "1", 0.0, 0.3, "part of fourth order, over the straight part").within(-3.0, 3.0),
        ]
    }
    fn starts(&self, context: &Context<'_>) -> Vec<Vec<f64>> {
        let course = Course::or_load(context, self.0);
        let [low, high] = course.ends(context);
        // a parabola about 0 shows no straight part to begin with
        let bends: &[f64] = if low < 0.0 && high > 0.0 { &[0.0, BENT, -BENT] } else { &[0.0] };
        bends.iter().map(|bend| vec![bend / course.span(context), 0.0, 0.0, 0.0]).collect()
    }
    fn may_be_nothing(&self) -> &'static [&'static str] {
        &["bend"]
    }
    fn other_laws(&self) -> &'static [&'static [&'static str]] {
        &[&["power"], &["third", "fourth"]]
    }
    fn testable(&self, context: &Context<'_>) -> Result<(), String> {
        context.has(StageName::Readout)?;
        Course::beside_the_base(context, self.0, "; a bend asks for a higher order under [base]")
    }
    fn with(&self, values: &[f64], context: &Context<'_>) -> Box<dyn Stage> {
        Box::new(self.curve(values, context))
    }
    fn sibling(&self, values: &[f64], context: &Context<'_>) -> Option<Box<dyn Stage>> {
        let course = Course::of(context, self.0)?;
        Some(Box::new(Flattening(self.curve(values, context), 0.8 * course.span(context))))
    }
    fn says(&self, fitted: &[FittedParameter]) -> String {
        told(fitted, "the driver")
    }
    fn told(&self, fitted: &[FittedParameter], context: &Context<'_>, _: &[(EffectId, Vec<FittedParameter>)]) -> String {
        told(fitted, Course::of(context, self.0).map_or("the driver", |course| course.name(context)))
    }
}

/// Exponent from which on a law is told as a power, in standard deviations from 1.
const SPOKEN_OF: f64 = 3.0;

fn told(fitted: &[FittedParameter], name: &str) -> String {
    let slope = &fitted[0];
    let power = fitted.get(2).filter(|power| power.value.abs() > SPOKEN_OF * power.sd);
    let size = with_sd(slope.value, slope.sd, &slope.parameter.unit);
    match power {
        Some(power) => {
            format!(
                "the reading moves with {name} to the power of {}, by {size} at its largest",
                with_sd(1.0 + power.value, power.sd, "")
            )
        }
        None => format!("the reading moves with {name} by {size}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn curve(power: f64, turns: [f64; 2]) -> Curve {
        Curve { per_unit: 1.0, bend: 0.0, power, turns, ends: [-2.0, 4.0], course: Course::Driver(0) }
    }

    /// An exponent of 2 keeps the sign and is the same at the largest value; one of 1 is the straight line.
    #[test]
    fn drag_goes_with_the_square_and_against_the_sign() {
        let square = curve(1.0, [0.0; 2]);
        for (x, exact) in [(4.0, 4.0), (2.0, 1.0), (-2.0, -1.0)] {
            approx::assert_relative_eq!(square.law(x), exact, max_relative = 1e-12);
        }
        approx::assert_relative_eq!(curve(0.0, [0.0; 2]).law(-1.5), -1.5, max_relative = 1e-12);
    }

    /// Legendre polynomials are 1 at the upper end and 1 or -1 at the lower one.
    #[test]
    fn turns_are_measured_over_the_range() {
        let turned = curve(0.0, [0.2, 0.1]);
        approx::assert_relative_eq!(turned.law(4.0), 4.0 + 3.0 * 0.3, max_relative = 1e-12);
        approx::assert_relative_eq!(turned.law(-2.0), -2.0 + 3.0 * -0.1, max_relative = 1e-12);
        approx::assert_relative_eq!(turned.law(1.0), 1.0 + 3.0 * 0.1 * 0.375, max_relative = 1e-12);
    }
}
