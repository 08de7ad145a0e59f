//! The reading moves with a recorded driver, late: what the driver does takes time to arrive.

use crate::{
    data::context::Context,
    effects::composed::words::{InWords, Kinetics, Place},
    effects::{
        course::Course,
        driver_coefficient::DriverCoefficient,
        effect::{About, Effect, Family, FittedParameter, Mark},
        memory::first_order_lag,
    },
    text::with_sd,
};
use truegap_core::{Drive, EffectId, Parameter, Readout, Stage, simulator::StageName};

/// Influence of the moving driver of this number, behind it by a time constant.
pub struct LateDriver(pub usize);

/// `lags` first-order lags one after the other, which share the time constant.
struct Behind {
    per_unit: f64,
    tau_s: f64,
    lags: usize,
    course: Course,
}

impl Stage for Behind {
    fn readout(&self, drive: &Drive<'_>, _: &Readout, value: &mut [f64]) {
        let Some(x) = self.course.column(drive) else { return };
        let mut late = x.to_vec();
        for _ in 0..self.lags {
            first_order_lag(drive.inputs, self.tau_s / self.lags as f64, &mut late, |first| first);
        }
        value.iter_mut().zip(&late).for_each(|(value, late)| *value += self.per_unit * late);
    }
}

const IDS: [&str; 2] = ["late_driver", "late_second_driver"];

impl LateDriver {
    fn behind(&self, values: &[f64], context: &Context<'_>, lags: usize) -> Behind {
        let course = Course::or_load(context, self.0);
        Behind { per_unit: values[0], tau_s: values[1], lags, course }
    }
}

/// Somewhere between a step and a run, s, in the logarithm.
fn middle_s(context: &Context<'_>) -> f64 {
    let step = context.step_s();
    (step * context.run_s()).sqrt()
}

impl Effect for LateDriver {
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
        Some(InWords { place: Place::Readout, driver, kinetics: Kinetics::FirstOrder })
    }
    fn about(&self) -> About {
        About {
            physics: "the reading moves with a recorded driver (a wind, a pump, a heater) and comes to rest some time after it",
            equation: "value = true + k lag(x; tau), x the driver as recorded; each run starts at rest",
            excitation: "a column under [drivers] that changes faster than what it does arrives, with a clock",
            impostors: &["driver_coefficient", "friction", "slow_response", "offset_drift"],
            separates: "goes on after the driver has come to rest, and comes back with it in the end",
            source: "Ljung, System Identification, sec. 4.2, a first-order transfer function from an input",
        }
    }
    fn parameters(&self, context: &Context<'_>) -> Vec<Parameter> {
        let course = Course::or_load(context, self.0);
        vec![
            course.influence(context, "change of the reading per unit of the driver, in the end"),
            Parameter::log_normal("tau", "s", middle_s(context), 1.5, "time constant with which it arrives")
                // what arrives sooner than half a row is there at once: beside the plain influence it would stand for a rate
                .within(0.5 * context.step_s().min(context.run_s()), context.run_s()),
        ]
    }
    fn comes_down_to(&self) -> Option<EffectId> {
        Some(DriverCoefficient(self.0).id())
    }
    fn apart_by(&self) -> Option<&'static str> {
        Some("tau")
    }
    fn at_once(&self) -> &'static [&'static str] {
        &["tau"]
    }
    fn mark(&self) -> Option<Mark> {
        Some(Mark::Below("tau"))
    }
    fn starts(&self, context: &Context<'_>) -> Vec<Vec<f64>> {
        let middle = middle_s(context);
        [0.2, 1.0, 5.0].map(|times| vec![times * middle]).to_vec()
    }
    fn testable(&self, context: &Context<'_>) -> Result<(), String> {
        context.has(StageName::Readout)?;
        context.needs_clock()?;
        Course::beside_the_base(context, self.0, ": what is late is the reading")
    }
    fn with(&self, values: &[f64], context: &Context<'_>) -> Box<dyn Stage> {
        Box::new(self.behind(values, context, 1))
    }
    fn sibling(&self, values: &[f64], context: &Context<'_>) -> Option<Box<dyn Stage>> {
        Some(Box::new(self.behind(values, context, 2)))
    }
    fn says(&self, fitted: &[FittedParameter]) -> String {
        told(fitted, "the driver")
    }
    fn told(&self, fitted: &[FittedParameter], context: &Context<'_>, _: &[(EffectId, Vec<FittedParameter>)]) -> String {
        told(fitted, Course::of(context, self.0).map_or("the driver", |course| course.name(context)))
    }
}

fn told(fitted: &[FittedParameter], name: &str) -> String {
    let [slope, tau] = [&fitted[0], &fitted[1]];
    let slope = with_sd(slope.value, slope.sd, &slope.parameter.unit);
    format!("the reading moves with {name} by {slope}, late by a time constant of {}", with_sd(tau.value, tau.sd, "s"))
}
