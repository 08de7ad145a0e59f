//! The sensitivity changes with a recorded driver that the base model does not know.
//!
//! Limits: a smooth law without a change of sign; beside a straight and a square part, turns over the range or a rise towards a pole beyond one end.

use crate::{
    data::context::Context,
    effects::composed::words::{InWords, Kinetics, Place},
    effects::{
        course::Course,
        driver_coefficient::legendre,
        effect::{About, Effect, Family, FittedParameter},
        gain_error::{BESIDE, gain_is_fixed},
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
    /// what the driver is of the value at which its influence has a pole, from -1 to 1; 0 where there is none
    steepness: f64,
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
        let risen = if self.steepness == 0.0 { from } else { self.rising(u) - self.rising(self.neutral) };
        let straight = self.log_gain * risen + self.bend * from * from;
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

/// Greatest steepness: the pole lies a twentieth of half the range beyond its end.
const STEEPEST: f64 = 0.95;

impl Gain {
    /// What rises, or falls, steeply towards a pole of second order beyond one end of the range; as much from one end to the other as `u`.
    ///
    /// The transmission of a cover over the angle of incidence and the growth of a droplet over the humidity are followed by it, with the square beside it, to 0.4 % up to 86 deg and to 1 % up to 93 %.
    fn rising(&self, u: f64) -> f64 {
        let (e, u) = (self.steepness, u.clamp(-1.0, 1.0));
        let all = (1.0 - e * e).powi(2);
        all * ((1.0 - e * u).powi(-2) - 1.0) / (2.0 * e)
    }
}

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

const IDS: [&str; 2] = ["driver_gain", "second_driver_gain"];

impl DriverGain {
    fn gain(&self, values: &[f64], context: &Context<'_>) -> Gain {
        let course = Course::or_load(context, self.0);
        let [low, high] = course.ends(context);
        let range = [0.5 * (low + high), (0.5 * (high - low)).max(f64::MIN_POSITIVE)];
        let turns = [values[3], values[4]];
        let [steepness, neutral] = [5, 6].map(|place| values.get(place).copied().unwrap_or(0.0));
        Gain { log_gain: values[0], bend: values[1], turns, steepness, pivot: values[2], neutral, range, course }
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
            equation: "value = p + (true - p) exp(a u + b u^2 + c P3(u) + d P4(u)), and for a u also a (1 - e^2)^2 [(1 - e u)^-2 - 1] / (2 e), steep towards a pole at u = 1 / e; c = d = 0 and e = 0 until rows left out bear one of the two laws out, u from -1 to 1 over the range of the driver, less n where the gain of the base model is not calibrated, p the reading that it leaves alone",
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
            Parameter::normal("steepness", "1", 0.0, 0.5, "end of the range over the value at which the influence has a pole")
                .within(-STEEPEST, STEEPEST),
        ];
        if gain_is_fixed(context) {
            let meaning = "value of the driver at which the gain is that of the simulation, from -1 to 1 over its range";
            list.push(Parameter::normal("neutral", "1", 0.0, 0.7, meaning).within(-3.0, 3.0));
        }
        list
    }
    fn starts(&self, context: &Context<'_>) -> Vec<Vec<f64>> {
        let neutral: &[f64] = if gain_is_fixed(context) { &[0.0] } else { &[] };
        [0.0, -0.3, 0.5].map(|pivot| [&[0.0, pivot, 0.0, 0.0, 0.0], neutral].concat()).to_vec()
    }
    fn came_later(&self) -> Vec<&'static str> {
        [self.held_at_first(), vec!["neutral"]].concat()
    }
    fn other_laws(&self) -> &'static [&'static [&'static str]] {
        &[&["third", "fourth"], &["steepness"]]
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
    let (factor, relative) = ((2.0 * (number(0) - 2.0 * number(1) * number(6) + number(3))).exp(), 2.0 * fitted[0].sd);
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
            steepness: 0.0,
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
        // a steep law goes as far from end to end as a straight one, most of it at the end; it stays as it is beyond
        let steep = Gain { log_gain: 0.3, bend: 0.0, steepness: 0.8, ..gain };
        approx::assert_relative_eq!(steep.log_at(1.0) - steep.log_at(-1.0), 0.6, max_relative = 1e-12);
        assert!(steep.log_at(1.0) - steep.log_at(0.8) > 0.3);
        assert_eq!(steep.log_at(1.0), steep.log_at(2.0));
        // a reading at the pivot stays, whatever the driver does
        let mut value = vec![readout.zero + 0.5 * readout.span; 100];
        Gain { pivot: 0.5, ..gain }.readout(&drive, &readout, &mut value);
        value.iter().for_each(|v| approx::assert_relative_eq!(*v, readout.zero + 0.5 * readout.span, max_relative = 1e-12));
    }
}
