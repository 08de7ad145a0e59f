//! The sensitivity changes with a recorded driver that the base model does not know.
//!
//! Limits: a law of two numbers, smooth and without a change of sign.

use crate::{
    data::context::Context,
    effects::composed::words::{InWords, Kinetics, Place},
    effects::{
        course::Course,
        driver_coefficient::legendre,
        effect::{About, Effect, Family, FittedParameter},
        gain_error::gain_is_fixed,
    },
};
use truegap_core::{Drive, EffectId, Parameter, Readout, Stage, simulator::StageName};

/// Gain of the reading by the moving driver of this number.
pub struct DriverGain(pub usize);

#[derive(Clone, Copy)]
struct Gain {
    /// log of the gain from the middle of the driver's range to its end
    log_gain: f64,
    /// the same for the square
    bend: f64,
    /// weights of the third and the fourth Legendre polynomial in the log of the gain
    turns: [f64; 2],
    /// reading at which the gain changes nothing, spans above the zero
    pivot: f64,
    /// where in the range of the driver, from -1 to 1, the gain is as calibrated
    neutral: f64,
    /// middle and half of the driver's range
    range: [f64; 2],
    course: Course,
}

impl Gain {
    fn apply(&self, drive: &Drive<'_>, readout: &Readout, value: &mut [f64], gain: impl Fn(f64) -> f64) {
        let Some(x) = self.course.column(drive) else { return };
        let pivot = readout.zero + self.pivot * readout.span;
        let [middle, half] = self.range;
        value.iter_mut().zip(x).for_each(|(value, x)| *value += (*value - pivot) * gain((x - middle) / half));
    }

    /// Log of the gain at `u`, from -1 to 1 over the range of the driver; at most [`FARTHEST`] either way.
    fn log_at(&self, u: f64) -> f64 {
        let from = u - self.neutral;
        let straight = from * (self.log_gain + self.bend * from);
        if self.turns == [0.0; 2] {
            return straight;
        }
        // beyond the range of the recording a polynomial says nothing
        let turned = |u: f64| {
            let [third, fourth] = legendre(u.clamp(-1.0, 1.0));
            self.turns[0] * third + self.turns[1] * fourth
        };
        (straight + turned(u) - turned(self.neutral)).clamp(-FARTHEST, FARTHEST)
    }
}

/// Greatest logarithm of a gain that turns, either way.
const FARTHEST: f64 = 5.0;

impl Stage for Gain {
    fn readout(&self, drive: &Drive<'_>, readout: &Readout, value: &mut [f64]) {
        self.apply(drive, readout, value, |u| self.log_at(u).exp_m1());
    }
}

/// Sibling: a gain in proportion to the driver, without a logarithm; at least a tenth.
struct Straight(Gain);

impl Stage for Straight {
    fn readout(&self, drive: &Drive<'_>, readout: &Readout, value: &mut [f64]) {
        self.0.apply(drive, readout, value, |u| self.0.log_at(u).max(-0.9));
    }
}

/// Farthest reading that the gain leaves alone, spans beside what is read: from farther away a gain is a zero that moves with the driver (generated: a sensor that its current heats was told as a gain about a reading 1.8 spans above).
const BESIDE: f64 = 1.0;

const IDS: [&str; 2] = ["driver_gain", "second_driver_gain"];

impl DriverGain {
    fn gain(&self, values: &[f64], context: &Context<'_>) -> Gain {
        let course = Course::or_load(context, self.0);
        let [low, high] = course.ends(context);
        let range = [0.5 * (low + high), (0.5 * (high - low)).max(f64::MIN_POSITIVE)];
        let [third, fourth] = [values[3], values[4]];
        let neutral = values.get(5).copied().unwrap_or(0.0);
        Gain { log_gain: values[0], bend: values[1], turns: [third, fourth], pivot: values[2], neutral, range, course }
    }
}

impl Effect for DriverGain {
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
            physics: "the sensitivity changes with a recorded driver (a supply, a weight, a density, a direction of wear): a product of two quantities where the base model has one",
            equation: "value = p + (true - p) exp(a u + b u^2 + c P3(u) + d P4(u)), c = d = 0 until rows left out bear them out, u from -1 to 1 over the range of the driver, less n where the gain of the base model is not calibrated, p the reading that it leaves alone",
            excitation: "a column under [drivers] that changes, at several values of what the base model follows",
            impostors: &["driver_coefficient", "nonlinearity", "gain_change", "gain_drift"],
            separates: "in proportion to the reading: nothing where the reading is at its pivot, most where it is far from it",
            source: "modifying inputs, Doebelin & Manik, Measurement Systems, sec. 2.4; influence quantities, IEC 60359",
        }
    }
    fn parameters(&self, context: &Context<'_>) -> Vec<Parameter> {
        let mut list = vec![
            Parameter::normal("log_gain", "1", 0.0, 0.3, "log of the gain from the middle of the driver's range to its end")
                .within(-4.0, 4.0),
            Parameter::normal("bend", "1", 0.0, 0.2, "the same for the square").within(-3.0, 3.0),
            Parameter::normal("pivot", "spans", 0.0, 0.5, "reading that it leaves alone, above that without load")
                .within(-BESIDE, 1.0 + BESIDE),
            Parameter::normal("third", "1", 0.0, 0.2, "part of third order in the log of the gain").within(-2.0, 2.0),
            Parameter::normal("fourth", "1", 0.0, 0.2, "part of fourth order in the log of the gain").within(-2.0, 2.0),
        ];
        if gain_is_fixed(context) {
            let meaning = "value of the driver at which the gain is that of the simulation, from -1 to 1 over its range";
            list.push(Parameter::normal("neutral", "1", 0.0, 0.7, meaning).within(-3.0, 3.0));
        }
        list
    }
    fn starts(&self, context: &Context<'_>) -> Vec<Vec<f64>> {
        let neutral: &[f64] = if gain_is_fixed(context) { &[0.0] } else { &[] };
        [0.0, -0.3, 0.5].map(|pivot| [&[0.0, pivot, 0.0, 0.0], neutral].concat()).to_vec()
    }
    fn came_later(&self) -> Vec<&'static str> {
        [self.held_at_first(), vec!["neutral"]].concat()
    }
    fn other_laws(&self) -> &'static [&'static [&'static str]] {
        &[&["third", "fourth"]]
    }
    fn may_be_nothing(&self) -> &'static [&'static str] {
        &["bend", "neutral"]
    }
    fn testable(&self, context: &Context<'_>) -> Result<(), String> {
        context.has(StageName::Readout)?;
        match Course::of(context, self.0) {
            Some(course) if course.is_followed(context) => {
                return Err("the base model follows this driver by itself; a bent law of it is a nonlinearity".into());
            }
            Some(Course::Driver(_) | Course::Humidity) => {}
            _ => return Err(Course::missing(self.0)),
        }
        if !context.simulator.moves() {
            return Err("a value that does not move shows no gain".into());
        }
        context.needs_movement()
    }
    fn with(&self, values: &[f64], context: &Context<'_>) -> Box<dyn Stage> {
        Box::new(self.gain(values, context))
    }
    fn sibling(&self, values: &[f64], context: &Context<'_>) -> Option<Box<dyn Stage>> {
        Some(Box::new(Straight(self.gain(values, context))))
    }
    fn says(&self, fitted: &[FittedParameter]) -> String {
        told(fitted, "the driver")
    }
    fn told(&self, fitted: &[FittedParameter], context: &Context<'_>, _: &[(EffectId, Vec<FittedParameter>)]) -> String {
        told(fitted, Course::of(context, self.0).map_or("the driver", |course| course.name(context)))
    }
}

fn told(fitted: &[FittedParameter], name: &str) -> String {
    // from one end of the range to the other: with the bend where the gain is right elsewhere, and with what is odd of the turns
    let number = |place: usize| fitted.get(place).map_or(0.0, |number| number.value);
    let (factor, relative) = ((2.0 * (number(0) - 2.0 * number(1) * number(5) + number(3))).exp(), 2.0 * fitted[0].sd);
    format!(
        "the gain is {} times as large at the most of {name} as at its least",
        crate::text::with_sd(factor, factor * relative, "")
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use truegap_core::{Driver, Inputs};

    /// A viscometer: the time is in proportion to the viscosity over the weight; over a range of two the inverse is exp(a u + b u^2) to within 1 %.
    #[test]
    fn a_product_of_two_quantities_is_a_gain_about_a_pivot() {
        let weights: Vec<f64> = (0..100).map(|k| 1.0 + f64::from(k % 10) / 9.0).collect();
        let viscosity: Vec<f64> = (0..100).map(|k| 5.0 + f64::from(k / 10)).collect();
        let drivers = vec![Driver { name: "weight".into(), unit: "kg".into(), values: weights.clone() }];
        let inputs = Inputs { run: vec![1; 100], drivers, ..Inputs::default() };
        let drive = Drive { inputs: &inputs, load: &[0.0; 100], temperature_c: &[20.0; 100], reference_c: 20.0, full_load: 1.0 };
        // the base model reads 20 at the least viscosity: the pivot, a reading of 0, is 20 / 9 spans of 9 below that
        let readout = Readout { zero: 5.0 / 1.5, span: 6.0 };
        let log_gain = -0.5 * 2f64.ln();
        let bend = (1.5 / 2f64.sqrt()).ln();
        let gain = Gain {
            log_gain,
            bend,
            turns: [0.0; 2],
            pivot: -(5.0 / 1.5) / 6.0,
            neutral: 0.0,
            range: [1.5, 0.5],
            course: Course::Driver(0),
        };
        let mut value: Vec<f64> = viscosity.iter().map(|v| v / 1.5).collect();
        gain.readout(&drive, &readout, &mut value);
        for row in 0..100 {
            approx::assert_relative_eq!(value[row], viscosity[row] / weights[row], max_relative = 0.01);
        }
        // a law that turns is the polynomials at the ends, and stays as it is beyond them
        let turns = |neutral: f64| Gain { log_gain: 0.0, bend: 0.0, turns: [0.2, 0.1], neutral, ..gain };
        for (u, exact) in [(1.0, 0.2625), (-1.0, -0.1375), (0.0, 0.0), (2.0, 0.2625)] {
            approx::assert_relative_eq!(turns(0.0).log_at(u), exact, epsilon = 1e-12);
            approx::assert_relative_eq!(turns(0.0).log_at(u) - turns(0.0).log_at(0.4), turns(0.4).log_at(u), epsilon = 1e-12);
        }
        // a reading at the pivot stays, whatever the driver does
        let mut value = vec![readout.zero + 0.5 * readout.span; 100];
        Gain { pivot: 0.5, ..gain }.readout(&drive, &readout, &mut value);
        value.iter().for_each(|v| approx::assert_relative_eq!(*v, readout.zero + 0.5 * readout.span, max_relative = 1e-12));
    }
}
