//! Units of what a mechanism follows, of what it changes, and of its size.
//!
//! Limits: text only; nothing is converted.

use crate::{
    data::context::Context,
    effects::composed::{
        mechanism::{Sentence, Sum},
        signal::recorded,
        words::{Action, Driver, Form, Kinetics, Quantity},
    },
};
use truegap_core::Inputs;

/// What units depend on beside the words: what was recorded, and in what the reading is.
#[derive(Clone, Copy)]
pub struct Surroundings<'a> {
    pub inputs: &'a Inputs,
    pub reading: &'a str,
}

impl<'a> From<&'a Context<'_>> for Surroundings<'a> {
    fn from(context: &'a Context<'_>) -> Self {
        Self { inputs: context.inputs, reading: context.simulator.unit() }
    }
}

/// Unit of a driver.
pub fn driver_unit<'a>(driver: &Driver, around: impl Into<Surroundings<'a>>) -> String {
    let around = around.into();
    let named = |name: &str| {
        let all = recorded(around.inputs);
        all.into_iter().find(|(n, _, _)| n == name).map_or_else(|| "1".to_owned(), |(_, _, unit)| unit)
    };
    match driver {
        Driver::Load | Driver::LoadHistory => "full load".into(),
        Driver::LoadRate => "full load/s".into(),
        Driver::Temperature => "K".into(),
        Driver::TemperatureRate => "K/s".into(),
        Driver::Time => "s".into(),
        Driver::Reading => around.reading.into(),
        Driver::Recorded(name) => named(name),
        Driver::RateOf(name) => format!("{}/s", named(name)),
    }
}

/// Unit of a quantity.
pub fn quantity_unit<'a>(sentence: &Sentence, around: impl Into<Surroundings<'a>>) -> String {
    match (sentence.quantity, sentence.action) {
        (_, Action::Scales) => "1".into(),
        (Quantity::Load, _) => "full load".into(),
        (Quantity::Temperature | Quantity::Warp, _) => "K".into(),
        (Quantity::Gap, _) => "unloaded gap".into(),
        (Quantity::Reading, _) => around.into().reading.into(),
        (Quantity::Strain | Quantity::Modulus | Quantity::Permittivity, _) => "1".into(),
    }
}

/// Unit of the size: the quantity's over that of the column.
pub fn size_unit<'a>(sentence: &Sentence, around: impl Into<Surroundings<'a>>) -> String {
    let around = around.into();
    let driver = driver_unit(&sentence.driver, around);
    let followed = match (sentence.kinetics, sentence.sum) {
        (Kinetics::RateIndependent | Kinetics::Periodic | Kinetics::Event, _) => return quantity_unit(sentence, around),
        (Kinetics::FirstOrder, _) if sentence.driver == Driver::Time => return quantity_unit(sentence, around),
        (Kinetics::Static, _) if sentence.form == Form::Peak => return quantity_unit(sentence, around),
        (Kinetics::Accumulating, Some(Sum::Dose)) => format!("({driver} s)"),
        _ => format!("({driver})"),
    };
    let power = if sentence.form == Form::Power { "^exponent" } else { "" };
    format!("{}/{followed}{power}", quantity_unit(sentence, around))
}

/// Unit of a number inside a mechanism, by its name.
pub fn number_unit<'a>(name: &str, sentence: &Sentence, around: impl Into<Surroundings<'a>>) -> String {
    match name {
        "size" => size_unit(sentence, around),
        "tau" => "s".into(),
        "exponent" => "1".into(),
        "phase" => "rad".into(),
        _ => driver_unit(&sentence.driver, around),
    }
}
