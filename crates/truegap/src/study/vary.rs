//! What a search may change, as people write it: `height=150 um:210 um`, `conductor=10 um,17 um`, `bead_count=50:97`.
//!
//! Limits: whether a design can be so is for [`Space`].

use super::{SensorText, StudyError};
use truegap_core::units::{Dimension, parse};
use truegap_core::{UnitError, given_again};
use truegap_design::optimise::{Axis, Choice, Space};
use truegap_design::{QUANTITIES, Quantity};

/// Why a text is no axis.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
#[allow(missing_docs)] // the fields are named by the messages
pub enum VaryError {
    /// No such quantity.
    #[error("there is no quantity `{name}`; take one of {known}")]
    Quantity { name: String, known: String },
    /// Neither a range nor a list.
    #[error("--vary {text}: write \"height=150 um:210 um\" for a range or \"conductor=10 um,17 um\" for what can be bought")]
    Form { text: String },
    /// A quantity that is given twice.
    #[error("--vary gives `{name}` twice; leave one of them out")]
    Twice { name: String },
    /// A value without its unit, or in another.
    #[error("--vary {quantity}: {source}")]
    Value { quantity: Quantity, source: UnitError },
    /// The starting design cannot be.
    #[error(transparent)]
    Study(#[from] StudyError),
}

/// The paper's axes without what is held, and with what varies otherwise.
///
/// # Errors
/// [`VaryError`] names the text.
pub fn axes(sensor: &SensorText, hold: &[String], vary: &[String]) -> Result<Vec<Axis>, VaryError> {
    let paper = || Ok::<_, StudyError>(Space::paper(sensor.sensor()?)?.axes().to_vec());
    let mut axes = paper()?;
    for name in hold {
        let quantity = quantity(name)?;
        axes.retain(|axis| axis.quantity != quantity);
    }
    let varied = vary.iter().map(|text| axis(text)).collect::<Result<Vec<Axis>, _>>()?;
    if let Some((axis, _)) = given_again(&varied, |one, other| one.quantity == other.quantity) {
        return Err(VaryError::Twice { name: axis.quantity.name().to_owned() });
    }
    for axis in varied {
        match axes.iter_mut().find(|a| a.quantity == axis.quantity) {
            Some(place) => *place = axis,
            None => axes.push(axis),
        }
    }
    Ok(axes)
}

/// An axis from `QUANTITY=LOW:HIGH` or `QUANTITY=A,B,C`.
///
/// # Errors
/// [`VaryError`] names the text.
pub fn axis(text: &str) -> Result<Axis, VaryError> {
    let form = || VaryError::Form { text: text.to_owned() };
    let (name, range) = text.split_once('=').ok_or_else(form)?;
    let quantity = quantity(name)?;
    let choice = match (range.split_once(':'), quantity) {
        (Some((low, high)), Quantity::BeadCount) => {
            let whole = |part: &str| part.trim().parse::<u32>().map_err(|_| form());
            Choice::Whole(whole(low)?, whole(high)?)
        }
        (Some((low, high)), _) => Choice::Continuous(value(quantity, low)?, value(quantity, high)?),
        (None, _) => Choice::Levels(range.split(',').map(|level| value(quantity, level)).collect::<Result<_, _>>()?),
    };
    Ok(Axis { quantity, choice })
}

fn quantity(name: &str) -> Result<Quantity, VaryError> {
    let unknown = || VaryError::Quantity { name: name.to_owned(), known: QUANTITIES.map(Quantity::name).join(", ") };
    Quantity::named(name.trim()).ok_or_else(unknown)
}

fn value(quantity: Quantity, text: &str) -> Result<f64, VaryError> {
    let dimension = match quantity {
        Quantity::Young => Dimension::Pressure,
        Quantity::Softening => Dimension::PressurePerKelvin,
        Quantity::BeadCount => Dimension::Ratio,
        Quantity::Stray => Dimension::Capacitance,
        _ => Dimension::Length,
    };
    parse(text.trim(), dimension).map_err(|source| VaryError::Value { quantity, source })
}
