//! The reading turns over in a driver, between two ends where it saturates, and later on the way than the driver does: a magnet, a ferroelectric, a relay.

use crate::{
    data::context::Context,
    effects::composed::words::{InWords, Kinetics, Place},
    effects::{
        course::Course,
        delay::is_temperature,
        effect::{About, Effect, Family, FittedParameter, Mark},
        friction_of_speed::is_speed,
        memory::play,
    },
    text::{rounded, with_sd},
};
use std::f64::consts::FRAC_2_PI;
use truegap_core::{Drive, EffectId, Parameter, Readout, Stage, simulator::StageName};

/// A loop over the moving driver that closes where the reading saturates.
pub struct SaturatingLoop;

struct Loop {
    /// half the way from end to end, in the unit of the reading
    height: f64,
    /// way that the driver must come back before the reading begins to turn over, halved; in the driver's unit
    half_width: f64,
    /// distance from the middle of a flank where half of the way to an end is done
    rounding: f64,
    /// middle between the flanks, in the driver's unit
    centre: f64,
    /// where the play stands in the first row of a run: 0 at the end of a way up, 1 at that of a way down
    start: f64,
    /// odd, from -1 to 1
    curve: fn(f64) -> f64,
    course: Course,
}

/// An arc tangent: half of the way where the driver is one rounding from the middle.
fn arc(u: f64) -> f64 {
    FRAC_2_PI * u.atan()
}

/// For the sibling: the same middle of the flank and the same order of approach to the ends, by a fraction.
fn fraction(u: f64) -> f64 {
    u / (1.0 + u.abs())
}

impl Stage for Loop {
    fn readout(&self, drive: &Drive<'_>, _: &Readout, value: &mut [f64]) {
        let Some(x) = self.course.column(drive).filter(|_| self.height != 0.0) else { return };
        let behind = play(drive.inputs, self.half_width, x, |first| first + (2.0 * self.start - 1.0) * self.half_width);
        for (value, place) in value.iter_mut().zip(behind) {
            *value += self.height * (self.curve)((place - self.centre) / self.rounding);
        }
    }
}

/// Widest flank, in ranges of the driver: it lies well inside the range, so that the loop closes at both ends. A wider one is a bent line, and lags look like it (a calorimeter against a model of it).
const WIDEST: f64 = 0.06;

/// Narrowest loop that is one, half its width in ranges of the driver.
const NARROWEST: f64 = 2e-3;

fn course(context: &Context<'_>) -> Course {
    Course::or_load(context, 0)
}

fn turning(values: &[f64], context: &Context<'_>, curve: fn(f64) -> f64) -> Box<dyn Stage> {
    let [height, half_width, rounding, off_middle, start] = [0, 1, 2, 3, 4].map(|k| values[k]);
    let course = course(context);
    Box::new(Loop { height, half_width, rounding, centre: course.middle(context) + off_middle, start, curve, course })
}

impl Effect for SaturatingLoop {
    fn id(&self) -> EffectId {
        EffectId("saturating_loop")
    }
    fn stage(&self) -> StageName {
        StageName::Readout
    }
    fn family(&self) -> Family {
        Family::MechanicalMemory
    }
    fn in_words(&self, context: &Context<'_>) -> Option<InWords> {
        Some(InWords {
            place: Place::Readout,
            driver: Course::of(context, 0)?.driver(context),
            kinetics: Kinetics::RateIndependent,
        })
    }
    fn about(&self) -> About {
        About {
            physics: "what the driver moves turns over between two ends where it saturates, and keeps its state until the driver has come back by a way of its own: a magnet, a ferroelectric, a relay, a snap",
            equation: "value = true + A (2/pi) atan((p - c) / w), p the play of half width h on the driver x, at x + (2 s - 1) h when a run starts, c the middle of its range and a difference from it",
            excitation: "a driver that goes from end to end and back",
            impostors: &["friction", "nonlinearity", "readout_lag", "regime_change"],
            separates: "the two ways are apart in the middle and meet at the ends; a friction keeps them apart to the ends, a bent law has one way only",
            source: "Visintin, Differential Models of Hysteresis (1994), ch. III (generalised play); Bertotti, Hysteresis in Magnetism (1998), sec. 1.2",
        }
    }
    fn parameters(&self, context: &Context<'_>) -> Vec<Parameter> {
        let course = course(context);
        let (span, unit) = (course.span(context), course.unit(context));
        vec![
            Parameter::normal(
                "height",
                context.simulator.unit(),
                0.0,
                0.5 * context.response_span.abs(),
                "half the way between the ends",
            ),
            Parameter::log_normal("half_width", &unit, 0.1 * span, 1.2, "place of the flanks beside the centre")
                .within(NARROWEST * span, span),
            Parameter::log_normal(
                "rounding",
                &unit,
                0.03 * span,
                1.2,
                "distance from the middle of a flank at which half of the way to the end is done",
            )
            .within(1e-4 * span, WIDEST * span),
            Parameter::normal("off_middle", &unit, 0.0, 0.1 * span, "centre of the flanks over the middle of the driver's range"),
            Parameter::normal("start", "1", 0.5, 0.35, "where in the loop a run starts: 0 on a way up, 1 on a way down")
                .within(0.0, 1.0),
        ]
    }
    fn of_start(&self, _: &Context<'_>) -> &'static [&'static str] {
        &["start"]
    }
    fn mark(&self) -> Option<Mark> {
        Some(Mark::Above("half_width"))
    }
    fn may_be_nothing(&self) -> &'static [&'static str] {
        &["off_middle"]
    }
    fn at_once(&self) -> &'static [&'static str] {
        &["rounding"]
    }
    fn starts(&self, context: &Context<'_>) -> Vec<Vec<f64>> {
        let span = course(context).span(context);
        [(0.01, 0.04), (0.03, 0.02), (0.1, 0.03), (0.2, 0.01), (0.3, 0.02)]
            .map(|(half_width, rounding)| vec![half_width * span, rounding * span, 0.0, 0.5])
            .to_vec()
    }
    fn testable(&self, context: &Context<'_>) -> Result<(), String> {
        context.has(StageName::Readout)?;
        if context.has_plates() {
            return Err("the base model has places for hysteresis and saturation of its own".into());
        }
        if is_temperature(context) {
            return Err("the reading is a temperature, which does not turn over".into());
        }
        match Course::of(context, 0) {
            None => Err(Course::missing(0)),
            Some(Course::Simulated) => {
                Err("what is simulated is the reading and drives nothing; name what drives it under [drivers]".into())
            }
            Some(course) if is_speed(course, context) => {
                Err("the driver is a speed, which is no state to be kept; friction follows it".into())
            }
            Some(course) if !course.turns(context) => {
                Err(format!("{} goes one way only inside the runs; a loop shows where it turns", course.name(context)))
            }
            Some(course) if !course.goes_and_returns(context) => Err(format!(
                "{} goes over half of its range and back in no run; a loop closes at both ends",
                course.name(context)
            )),
            Some(_) => Ok(()),
        }
    }
    fn with(&self, values: &[f64], context: &Context<'_>) -> Box<dyn Stage> {
        turning(values, context, arc)
    }
    fn sibling(&self, values: &[f64], context: &Context<'_>) -> Option<Box<dyn Stage>> {
        Some(turning(values, context, fraction))
    }
    fn says(&self, fitted: &[FittedParameter]) -> String {
        told(fitted, "the driver", 0.0)
    }
    fn told(&self, fitted: &[FittedParameter], context: &Context<'_>, _: &[(EffectId, Vec<FittedParameter>)]) -> String {
        let course = course(context);
        told(fitted, course.name(context), course.middle(context))
    }
}

/// `middle` is that of the driver's range.
fn told(fitted: &[FittedParameter], name: &str, middle: f64) -> String {
    let [height, half_width, rounding, off_middle] = [0, 1, 2, 3].map(|k| &fitted[k]);
    let unit = &half_width.parameter.unit;
    let centre = middle + off_middle.value;
    let way = if height.value < 0.0 { "down" } else { "up" };
    format!(
        "the reading turns over by {} in a loop of {name}: {way} where {name} comes to {} on its way up, back where it comes to {} on its way down ({} to \
         either side of {}), half of it within {}",
        with_sd(2.0 * height.value.abs(), 2.0 * height.sd, &height.parameter.unit),
        rounded(centre + half_width.value, unit),
        rounded(centre - half_width.value, unit),
        with_sd(half_width.value, half_width.sd, unit),
        rounded(centre, unit),
        rounded(2.0 * rounding.value, unit),
    )
}
