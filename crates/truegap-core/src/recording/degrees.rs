//! Temperatures that look like those of another unit: kelvins called degrees Celsius, and the other way round.
//!
//! Limits: a doubt, never a correction: an oven has 300 degrees Celsius, and helium 4 kelvins.

use super::{columns::Column, data::Recording, note::Note};
use crate::column::ends;
use crate::inputs::Role;
use crate::units::{Dimension, twelve_digits};

/// Numbers that a thermometer near room temperature shows in kelvins, and hardly ever in degrees Celsius.
const LIKE_KELVINS: (f64, f64) = (250.0, 400.0);
/// Numbers that it shows in degrees Celsius, and hardly ever in kelvins.
const LIKE_CELSIUS: (f64, f64) = (-50.0, 150.0);

/// A doubt about the unit of the temperature, where every row lies where another unit would put it.
pub(super) fn doubt(recording: &Recording, columns: &[Column]) -> Option<Note> {
    let column = columns.iter().find(|column| column.role == Role::Temperature)?;
    let (factor, offset) = column.scale;
    let written = |celsius: f64| twelve_digits((celsius - offset) / factor);
    let values = recording.inputs.temperature_c.as_ref()?.iter().map(|celsius| written(*celsius));
    let (low, high) = ends(values);
    let inside = |(from, to): (f64, f64)| low >= from && high <= to;
    let read_in = |unit: &str| Dimension::Temperature.scale(unit) == Ok(column.scale);
    let (unit, other) = match () {
        () if read_in("degC") && inside(LIKE_KELVINS) => ("degC", "K"),
        () if read_in("K") && inside(LIKE_CELSIUS) => ("K", "degC"),
        () => return None,
    };
    Some(Note::OtherDegrees { column: column.name.clone(), unit: unit.to_owned(), low, high, other: other.to_owned() })
}
