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

/// Unit of a driver.
pub fn driver_unit(driver: &Driver, context: &Context<'_>) -> String {
    let named = |name: &str| {
        let all = recorded(context.inputs);
        all.into_iter().find(|(n, _, _)| n == name).map_or_else(|| "1".to_owned(), |(_, _, unit)| unit)
    };
    match driver {
        Driver::Load | Driver::LoadHistory => "full load".into(),
        Driver::LoadRate => "full load/s".into(),
        Driver::Temperature => "K".into(),
        Driver::TemperatureRate => "K/s".into(),
        Driver::Time => "s".into(),
        Driver::Reading => context.simulator.unit().into(),
        Driver::Recorded(name) => named(name),
        Driver::RateOf(name) => format!("{}/s", named(name)),
    }
}

/// Unit of a quantity.
pub fn quantity_unit(sentence: &Sentence, context: &Context<'_>) -> String {
    match (sentence.quantity, sentence.action) {
        (_, Action::Scales) => "1".into(),
        (Quantity::Load, _) => "full load".into(),
        (Quantity::Temperature | Quantity::Warp, _) => "K".into(),
        (Quantity::Gap, _) => "unloaded gap".into(),
        (Quantity::Reading, _) => context.simulator.unit().into(),
        (Quantity::Strain | Quantity::Modulus | Quantity::Permittivity, _) => "1".into(),
    }
}

/// Unit of the size: the quantity's over that of the column.
pub fn size_unit(sentence: &Sentence, context: &Context<'_>) -> String {
    let driver = driver_unit(&sentence.driver, context);
    let followed = match (sentence.kinetics, sentence.sum) {
        (Kinetics::RateIndependent | Kinetics::Periodic | Kinetics::Event, _) => return quantity_unit(sentence, context),
        (Kinetics::FirstOrder, _) if sentence.driver == Driver::Time => return quantity_unit(sentence, context),
        (Kinetics::Static, _) if sentence.form == Form::Peak => return quantity_unit(sentence, context),
        (Kinetics::Accumulating, Some(Sum::Dose)) => format!("({driver} s)"),
        _ => format!("({driver})"),
    };
    let power = if sentence.form == Form::Power { "^exponent" } else { "" };
    format!("{}/{followed}{power}", quantity_unit(sentence, context))
}
