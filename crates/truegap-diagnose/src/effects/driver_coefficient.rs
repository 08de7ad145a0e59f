//! The reading moves with a recorded driver that the base model does not know.

use crate::{
    data::context::Context,
    effects::composed::words::{InWords, Kinetics, Place},
    effects::{
        course::Course,
        effect::{About, Effect, Family, FittedParameter},
    },
    text::with_sd,
};
use truegap_core::{Drive, EffectId, Parameter, Readout, Stage, simulator::StageName};

/// Coefficient of the reading for the moving driver of this number; it may change with the driver itself.
pub struct DriverCoefficient(pub usize);

struct Parabola {
    per_unit: f64,
    /// share of the coefficient that is added per unit of the driver
    bend: f64,
    course: Course,
}

impl Parabola {
    fn apply(&self, drive: &Drive<'_>, value: &mut [f64], law: impl Fn(f64) -> f64) {
        let Some(x) = self.course.column(drive) else { return };
        value.iter_mut().zip(x).for_each(|(value, x)| *value += self.per_unit * law(*x));
    }
}

impl Stage for Parabola {
    fn readout(&self, drive: &Drive<'_>, _: &Readout, value: &mut [f64]) {
        self.apply(drive, value, |x| x * (1.0 + 0.5 * self.bend * x));
    }
}

/// Sibling: a law that bends off either way, a fifth of it at the far end of the driver's range.
struct Flattening(Parabola, f64);

impl Stage for Flattening {
    fn readout(&self, drive: &Drive<'_>, _: &Readout, value: &mut [f64]) {
        self.0.apply(drive, value, |x| self.1 * (x / self.1).asinh());
    }
}

const IDS: [&str; 2] = ["driver_coefficient", "second_driver_coefficient"];

impl DriverCoefficient {
    fn parabola(&self, values: &[f64], context: &Context<'_>) -> Parabola {
        let course = Course::or_load(context, self.0);
        Parabola { per_unit: values[0], bend: values[1], course }
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
            equation: "value = true + k x (1 + b x / 2), x the driver as recorded",
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
            Parameter::normal("bend", &format!("1/{unit}"), 0.0, bend, "relative change of that per unit")
                .within(-4.0 * bend, 4.0 * bend),
        ]
    }
    fn starts(&self, _: &Context<'_>) -> Vec<Vec<f64>> {
        vec![vec![0.0]]
    }
    fn may_be_nothing(&self) -> &'static [&'static str] {
        &["bend"]
    }
    fn testable(&self, context: &Context<'_>) -> Result<(), String> {
        context.has(StageName::Readout)?;
        Course::beside_the_base(context, self.0, "; a bend asks for a higher order under [base]")
    }
    fn with(&self, values: &[f64], context: &Context<'_>) -> Box<dyn Stage> {
        Box::new(self.parabola(values, context))
    }
    fn sibling(&self, values: &[f64], context: &Context<'_>) -> Option<Box<dyn Stage>> {
        let course = Course::of(context, self.0)?;
        Some(Box::new(Flattening(self.parabola(values, context), 0.8 * course.span(context))))
    }
    fn says(&self, fitted: &[FittedParameter]) -> String {
        told(fitted, "the driver")
    }
    fn told(&self, fitted: &[FittedParameter], context: &Context<'_>, _: &[(EffectId, Vec<FittedParameter>)]) -> String {
        told(fitted, Course::of(context, self.0).map_or("the driver", |course| course.name(context)))
    }
}

fn told(fitted: &[FittedParameter], name: &str) -> String {
    let slope = &fitted[0];
    format!("the reading moves with {name} by {}", with_sd(slope.value, slope.sd, &slope.parameter.unit))
}
