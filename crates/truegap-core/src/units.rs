//! Text with a unit in, SI out: the only place where units are converted.
//!
//! Limits: a closed list of units, those that a data sheet or a test rig of this field writes; temperatures are degrees Celsius inside.

mod spelling;

use serde::{Deserialize, Serialize};
use spelling::canonical;

/// What a quantity measures; the SI unit of each is what [`parse`] returns.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
#[non_exhaustive]
pub enum Dimension {
    /// m
    Length,
    /// N
    Force,
    /// Pa
    Pressure,
    /// Pa/K
    PressurePerKelvin,
    /// degrees Celsius, a point on the scale
    Temperature,
    /// K, a difference
    TemperatureDifference,
    /// K/m
    TemperatureGradient,
    /// 1/K
    PerKelvin,
    /// F
    Capacitance,
    /// V
    Voltage,
    /// s
    Time,
    /// per cent of relative humidity
    Humidity,
    /// a pure number
    Ratio,
}

/// Unit, factor to SI, offset added after scaling.
type Unit = (&'static str, f64, f64);

impl Dimension {
    /// The units that text may use, the first one is the SI unit of this dimension.
    fn units(self) -> &'static [Unit] {
        match self {
            Self::Length => &[
                ("m", 1.0, 0.0),
                ("cm", 1e-2, 0.0),
                ("mm", 1e-3, 0.0),
                ("um", 1e-6, 0.0),
                ("nm", 1e-9, 0.0),
                ("mil", 2.54e-5, 0.0),
                ("in", 2.54e-2, 0.0),
            ],
            Self::Force => &[
                ("N", 1.0, 0.0),
                ("mN", 1e-3, 0.0),
                ("kN", 1e3, 0.0),
                ("gf", 9.80665e-3, 0.0),
                ("kgf", 9.80665, 0.0),
                ("lbf", 4.448_221_615_260_5, 0.0),
            ],
            Self::Pressure => &[
                ("Pa", 1.0, 0.0),
                ("hPa", 1e2, 0.0),
                ("kPa", 1e3, 0.0),
                ("MPa", 1e6, 0.0),
                ("GPa", 1e9, 0.0),
                ("mbar", 1e2, 0.0),
                ("bar", 1e5, 0.0),
                ("psi", 6_894.757_293_168, 0.0),
                ("mmHg", 133.322_387_415, 0.0),
            ],
            Self::PressurePerKelvin => &[("Pa/K", 1.0, 0.0), ("kPa/K", 1e3, 0.0), ("MPa/K", 1e6, 0.0)],
            Self::Temperature => &[
                ("degC", 1.0, 0.0),
                ("C", 1.0, 0.0),
                ("K", 1.0, -273.15),
                ("degF", 5.0 / 9.0, -160.0 / 9.0),
                ("F", 5.0 / 9.0, -160.0 / 9.0),
            ],
            Self::TemperatureDifference => &[("K", 1.0, 0.0), ("degC", 1.0, 0.0), ("mK", 1e-3, 0.0)],
            Self::TemperatureGradient => &[("K/m", 1.0, 0.0), ("K/mm", 1e3, 0.0), ("K/um", 1e6, 0.0)],
            Self::PerKelvin => &[("1/K", 1.0, 0.0), ("ppm/K", 1e-6, 0.0), ("%/K", 1e-2, 0.0), ("ppm", 1e-6, 0.0)],
            Self::Capacitance => &[
                ("F", 1.0, 0.0),
                ("uF", 1e-6, 0.0),
                ("nF", 1e-9, 0.0),
                ("pF", 1e-12, 0.0),
                ("fF", 1e-15, 0.0),
                ("aF", 1e-18, 0.0),
            ],
            Self::Voltage => &[("V", 1.0, 0.0), ("mV", 1e-3, 0.0), ("kV", 1e3, 0.0)],
            Self::Time => &[
                ("s", 1.0, 0.0),
                ("ms", 1e-3, 0.0),
                ("us", 1e-6, 0.0),
                ("min", 60.0, 0.0),
                ("h", 3600.0, 0.0),
                ("d", 86400.0, 0.0),
            ],
            Self::Humidity => &[("%", 1.0, 0.0), ("%RH", 1.0, 0.0), ("pct", 1.0, 0.0)],
            Self::Ratio => &[("", 1.0, 0.0), ("%", 1e-2, 0.0), ("ppm", 1e-6, 0.0)],
        }
    }

    /// Name of the SI unit, as text.
    pub fn si_unit(self) -> &'static str {
        self.units()[0].0
    }

    /// Factor and offset of a unit: SI value = value x factor + offset.
    ///
    /// # Errors
    /// [`UnitError::Unknown`] where this dimension has no such unit.
    pub fn scale(self, unit: &str) -> Result<(f64, f64), UnitError> {
        let wanted = canonical(unit);
        let found = self.units().iter().find(|(name, _, _)| *name == wanted);
        let (_, factor, offset) = found.ok_or_else(|| self.unknown(unit))?;
        Ok((*factor, *offset))
    }

    /// SI value of `value` given in `unit`.
    ///
    /// # Errors
    /// [`UnitError::Unknown`] where this dimension has no such unit.
    pub fn to_si(self, value: f64, unit: &str) -> Result<f64, UnitError> {
        let (factor, offset) = self.scale(unit)?;
        Ok(value * factor + offset)
    }

    /// The unit that `text` names, in one of its spellings and without regard to case, as the end of a column's name does: `pf` is `pF`, `kpa` is `kPa`,
    /// `sec` is `s`. `mPa` is none: what is written in both cases means them, and a thousandth is no million; nor is `MN`; `Nm` is a torque.
    pub(crate) fn unit_like(self, text: &str) -> Option<&'static str> {
        let wanted = canonical(text);
        if wanted == "Nm" {
            return None;
        }
        let both = wanted.contains(|c: char| c.is_ascii_lowercase()) && wanted.contains(|c: char| c.is_ascii_uppercase());
        // `MN` is a million newtons or, in capitals alone, a thousandth of one: nobody can tell
        let million = |name: &str| {
            wanted.starts_with('M') && name.strip_prefix('m').is_some_and(|rest| rest.starts_with(char::is_uppercase))
        };
        let first_alike = |name: &str| wanted.as_bytes().first() == name.as_bytes().first();
        let meant = |name: &str| !million(name) && (!both || !wanted.starts_with(['m', 'M']) || first_alike(name));
        let names = || self.units().iter().map(|unit| unit.0).filter(|name| !name.is_empty());
        names().find(|name| *name == wanted).or_else(|| names().find(|name| name.eq_ignore_ascii_case(&wanted) && meant(name)))
    }

    /// Names of the units of this dimension, the SI unit first.
    pub(crate) fn unit_names(self) -> Vec<&'static str> {
        self.units().iter().map(|unit| unit.0).filter(|name| !name.is_empty()).collect()
    }

    fn unknown(self, unit: &str) -> UnitError {
        let known = self.unit_names().join(", ");
        UnitError::Unknown { unit: unit.trim().to_owned(), dimension: self, known }
    }
}

/// Whether two texts may stand for one unit of a reading: `pF` and `picofarad`, and `F` for `degF` as well as for the farad.
pub(crate) fn is_same_unit(one: &str, other: &str) -> bool {
    let both = |dimension: Dimension| Some((dimension.scale(one).ok()?, dimension.scale(other).ok()?));
    let alike = |dimension| both(dimension).is_some_and(|(one, other)| one == other);
    one == other || alike(Dimension::Capacitance) || alike(Dimension::Temperature)
}

/// What is measured here.
pub(crate) const MEASURED: [Dimension; 8] = [
    Dimension::Time,
    Dimension::Force,
    Dimension::Pressure,
    Dimension::Length,
    Dimension::Temperature,
    Dimension::Humidity,
    Dimension::Capacitance,
    Dimension::Voltage,
];

/// Whether `text` is a unit of anything that is measured here, in one of its spellings.
pub(crate) fn is_unit(text: &str) -> bool {
    MEASURED.into_iter().any(|dimension| dimension.unit_like(text).is_some())
}

/// Lowest temperature there is, degrees Celsius.
pub const ABSOLUTE_ZERO_C: f64 = -273.15;

/// Why a text is not a quantity.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum UnitError {
    /// The text does not begin with a finite number.
    #[error("`{text}` does not begin with a number; write a number and a unit, as in `{example}`")]
    NotANumber {
        /// the text
        text: String,
        /// what would be right
        example: String,
    },
    /// A number without its unit.
    #[error("`{text}` has no unit; write one of {known}")]
    Missing {
        /// the text
        text: String,
        /// units that would do
        known: String,
    },
    /// A unit of another dimension, or none that is known.
    #[error("`{unit}` is not a unit of {dimension:?}; use one of {known}")]
    Unknown {
        /// the unit found
        unit: String,
        /// what is measured
        dimension: Dimension,
        /// units that would do
        known: String,
    },
    /// A temperature that there is not.
    #[error("`{text}` lies below absolute zero, {ABSOLUTE_ZERO_C} degC; check number and unit")]
    BelowAbsoluteZero {
        /// the text
        text: String,
    },
    /// A spread that no quantity has.
    #[error("`{text}` is no spread: a standard deviation is 0 or greater; write \"162 um +- 5 um\"")]
    NegativeSpread {
        /// the text
        text: String,
    },
    /// A number that SI cannot hold.
    #[error("`{text}` is too large for a number; check number and unit")]
    TooLarge {
        /// the text
        text: String,
    },
}

/// SI value of a text such as `180 um`.
///
/// # Errors
/// [`UnitError`] where the number or the unit is missing or wrong.
pub fn parse(text: &str, dimension: Dimension) -> Result<f64, UnitError> {
    let (number, unit) = split(text);
    let value = number.parse::<f64>().ok().filter(|v| v.is_finite());
    let example = format!("1 {}", dimension.si_unit());
    let value = value.ok_or(UnitError::NotANumber { text: text.to_owned(), example })?;
    if unit.is_empty() && dimension != Dimension::Ratio {
        let UnitError::Unknown { known, .. } = dimension.unknown("") else { unreachable!("unknown() makes Unknown") };
        return Err(UnitError::Missing { text: text.to_owned(), known });
    }
    let si = dimension.to_si(value, unit)?;
    match dimension {
        _ if !si.is_finite() => Err(UnitError::TooLarge { text: text.to_owned() }),
        // a hair below is the rounding of another unit
        Dimension::Temperature if si < ABSOLUTE_ZERO_C - 1e-9 => Err(UnitError::BelowAbsoluteZero { text: text.to_owned() }),
        _ => Ok(si),
    }
}

/// Number and unit of a text; the number ends where neither digits nor an exponent go on.
fn split(text: &str) -> (&str, &str) {
    let text = text.trim();
    let bytes = text.as_bytes();
    let mut end = 0;
    while end < bytes.len() {
        let exponent = end > 0
            && matches!(bytes[end], b'e' | b'E')
            && bytes[end - 1].is_ascii_digit()
            && bytes.get(end + 1).is_some_and(|b| b.is_ascii_digit() || matches!(b, b'+' | b'-'));
        let sign = matches!(bytes[end], b'+' | b'-') && (end == 0 || matches!(bytes[end - 1], b'e' | b'E'));
        if !(bytes[end].is_ascii_digit() || bytes[end] == b'.' || exponent || sign) {
            break;
        }
        end += 1;
    }
    (&text[..end], text[end..].trim())
}

/// A value with its standard deviation, both SI; read from `"34 um +- 5 %"` or `"162 um +- 5 um"`.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Measure {
    /// nominal value, SI
    pub value: f64,
    /// one standard deviation, SI; 0 where the text gives none
    pub sd: f64,
}

impl Measure {
    /// A value that is known exactly.
    pub const fn exact(value: f64) -> Self {
        Self { value, sd: 0.0 }
    }

    /// Reads `VALUE`, or `VALUE +- SD` with SD in a unit of its own or in per cent of the value.
    ///
    /// # Errors
    /// [`UnitError`] where one of the two is not a quantity.
    pub fn parse(text: &str, dimension: Dimension) -> Result<Self, UnitError> {
        let text = text.replace('±', "+-");
        let Some((value, sd)) = text.split_once("+-") else {
            return Ok(Self::exact(parse(&text, dimension)?));
        };
        let (value, spread_text) = (parse(value, dimension)?, sd.trim().to_owned());
        let sd = match sd.trim().strip_suffix('%') {
            Some(percent) if dimension != Dimension::Humidity => parse(percent, Dimension::Ratio)? * 0.01 * value.abs(),
            _ => spread(sd, dimension)?,
        };
        if sd >= 0.0 { Ok(Self { value, sd }) } else { Err(UnitError::NegativeSpread { text: spread_text }) }
    }
}

/// A spread: as [`parse`], but without the offset of a temperature scale.
fn spread(text: &str, dimension: Dimension) -> Result<f64, UnitError> {
    match dimension {
        Dimension::Temperature => parse(text, Dimension::TemperatureDifference),
        other => parse(text, other),
    }
}

/// `value` for messages, at twelve significant digits, as a power of ten where it is very large or very small.
pub fn readable(value: f64) -> String {
    let plain = value == 0.0 || !value.is_finite() || (1e-6..1e12).contains(&value.abs());
    let rounded = twelve_digits(value);
    if plain { rounded.to_string() } else { format!("{rounded:e}") }
}

/// `value` at twelve significant digits, for messages: what scaling to another unit adds behind them was never written by anybody.
pub fn twelve_digits(value: f64) -> f64 {
    // a number printed by this program is one that it reads
    format!("{value:.11e}").parse().unwrap_or(value)
}

#[cfg(test)]
mod tests;
