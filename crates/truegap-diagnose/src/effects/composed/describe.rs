//! A mechanism in a sentence: what is changed, what it follows, how, and how much.
//!
//! Limits: English.

use crate::{
    data::context::Context,
    effects::composed::{
        mechanism::{Numbers, Sentence, Sum},
        signal::{Courses, column},
        units::quantity_unit,
        words::{Action, Driver, Form, Kinetics, Quantity},
    },
    effects::effect::FittedParameter,
    text::with_sd,
};
use truegap_core::ends;

/// Share of a quantity from which on a change of it that is hardly known is none that a reader can use.
const RUNS_AWAY: f64 = 10.0;

/// The sentence with its fitted numbers; with a recording, how much it makes there.
pub fn describe(sentence: &Sentence, start: &Numbers, fitted: &[FittedParameter], context: Option<&Context<'_>>) -> String {
    let words = words(sentence);
    let inner: Vec<String> = fitted.iter().skip(1).map(|p| number(sentence, p)).collect();
    let numbers = if inner.is_empty() { String::new() } else { format!(" ({})", inner.join(", ")) };
    let most =
        context.and_then(|context| most(sentence, start, fitted, context)).map_or(String::new(), |most| format!(": {most}"));
    format!("{words}{numbers}{most}")
}

/// A number with what it means; a threshold with what it is counted from.
fn number(sentence: &Sentence, p: &FittedParameter) -> String {
    let from = match (p.parameter.name.as_str(), &sentence.driver) {
        ("threshold", _) if sentence.form == Form::Peak => "",
        ("threshold", Driver::Reading) => " above its least",
        ("threshold", Driver::Temperature) => " above the reference temperature",
        _ => "",
    };
    format!("{} {}{from}", p.parameter.meaning, with_sd(p.value, p.sd, &p.parameter.unit))
}

/// The words as a clause.
pub fn words(s: &Sentence) -> String {
    format!("{} {} {}{}", subject(s), verb(s), followed(s), form(s))
}

fn subject(s: &Sentence) -> &'static str {
    match s.quantity {
        Quantity::Load => "the load that arrives",
        Quantity::Temperature => "the temperature of the sensor",
        Quantity::Modulus => "the stiffness",
        Quantity::Strain => "the compression",
        Quantity::Gap => "the gap",
        Quantity::Warp => "the bend of the electrode",
        Quantity::Permittivity => "the permittivity",
        Quantity::Reading if s.action == Action::Scales => "the gain",
        Quantity::Reading => "the reading",
    }
}

fn verb(s: &Sentence) -> &'static str {
    match s.kinetics {
        Kinetics::Static => "changes with",
        Kinetics::FirstOrder => "changes, late, with",
        Kinetics::RateIndependent => "depends on the way of",
        Kinetics::Accumulating => "changes for good with",
        Kinetics::Event => "jumps",
        Kinetics::Periodic => "goes up and down with",
    }
}

fn followed(s: &Sentence) -> String {
    let driver = match &s.driver {
        Driver::Load | Driver::LoadHistory => "the load".to_owned(),
        Driver::LoadRate => "how fast the load changes".into(),
        Driver::Temperature => "the temperature".into(),
        Driver::TemperatureRate => "how fast the temperature changes".into(),
        Driver::Time => "the time".into(),
        Driver::Reading => "the reading itself".into(),
        Driver::Recorded(name) => format!("`{name}`"),
        Driver::RateOf(name) => format!("how fast `{name}` changes"),
    };
    let alike = if s.even { ", up and down alike" } else { "" };
    match (s.kinetics, s.sum) {
        (Kinetics::Accumulating, Some(Sum::Greatest)) => format!("the greatest value so far of {driver}"),
        (Kinetics::Accumulating, Some(Sum::Path)) => format!("the way that {driver} has come, up and down added"),
        (Kinetics::Accumulating, _) => format!("{driver} added up over time"),
        (Kinetics::Event, _) if s.driver == Driver::Time => "at one moment".into(),
        (Kinetics::Event, _) => format!("each time that {driver} passes a level upwards"),
        _ => format!("{driver}{alike}"),
    }
}

fn form(s: &Sentence) -> &'static str {
    match s.form {
        _ if matches!(s.kinetics, Kinetics::Event | Kinetics::Periodic | Kinetics::RateIndependent) => "",
        Form::Linear => "",
        Form::Power => ", by a power",
        Form::Threshold if s.below => ", below a threshold",
        Form::Threshold => ", above a threshold",
        Form::Saturating => ", levelling off",
        Form::Peak => ", about one place",
    }
}

/// How much it changes the quantity over the recording, at most.
fn most(sentence: &Sentence, start: &Numbers, fitted: &[FittedParameter], context: &Context<'_>) -> Option<String> {
    let (numbers, _) = start.with(fitted.iter().map(|p| (p.parameter.name.as_str(), p.value)));
    let load = context.simulator.load(context.inputs);
    let above = |t: &Vec<f64>| t.iter().map(|t| t - context.reference_c).collect::<Vec<f64>>();
    let temperature = context.inputs.temperature_c.as_ref().map(above);
    // the reading is followed above its zero, which is the least of a simulation
    let from_least = |x: &Vec<f64>| {
        let least = x.iter().copied().fold(f64::INFINITY, f64::min);
        x.iter().map(|x| x - least).collect::<Vec<f64>>()
    };
    let reading = context.inputs.simulated.as_ref().map(from_least);
    let at = Courses {
        inputs: context.inputs,
        load: load.as_deref(),
        temperature: temperature.as_deref(),
        reading: reading.as_deref(),
    };
    let u = column(sentence, &numbers, &at)?;
    let (low, high) = ends(u.iter().copied());
    let span = high - low;
    let (unit, factor) = match quantity_unit(sentence, context).as_str() {
        "1" => ("%".to_owned(), 100.0),
        "unloaded gap" => ("% of the unloaded gap".to_owned(), 100.0),
        "full load" => ("% of the full load".to_owned(), 100.0),
        unit => (unit.to_owned(), 1.0),
    };
    if !span.is_finite() {
        return None;
    }
    let (size, sd) = (fitted[0].value * span, fitted[0].sd * span);
    // a gain of more than ten times that might as well be nothing is a law that runs away, and no size
    if factor > 1.0 && size.abs() > RUNS_AWAY && sd > 0.5 * size.abs() {
        return Some("by how much, this recording does not settle".into());
    }
    Some(format!("{} from its least to its most in this recording", with_sd(size * factor, sd * factor, &unit)))
}
