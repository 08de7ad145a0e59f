//! A column of the header: its name, and its unit where the name or a line of units shows it.
//!
//! Limits: text; which units there are is known to [`crate::units`].

use super::notation::{is_ratio, split, split_of};
use super::small_letters::{NEWTON_METRES, has_prefix, is_newton_metres, proper};
use super::words::{is_torque, told};
use crate::inputs::Role;
use crate::units::{Dimension, is_unit};

/// A column of the header.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Heading {
    /// as it stands in the header
    pub name: String,
    /// from the line of units under the header
    pub below: Option<String>,
    /// whether a date stands under it, in the first row, or times of day that are the only clock
    pub dated: bool,
    /// whether that has no time of day
    pub days: bool,
    /// whether that may have day or month, or day or year, in front
    pub unordered: bool,
    /// whether a time of day without a date stands there
    pub of_day: bool,
}

impl Heading {
    /// A name that stands alone.
    pub fn of(name: &str) -> Self {
        Self { name: name.to_owned(), ..Self::default() }
    }

    /// What is measured, and the unit, where the name shows it.
    pub fn unit_in_name(&self) -> Option<(&str, &str)> {
        split(&self.name)
    }

    /// The unit as it is written, in any notation that shows it.
    pub fn unit(&self) -> Option<&str> {
        self.below.as_deref().or_else(|| self.unit_in_name().map(|(_, unit)| unit))
    }

    /// The unit as it should be written: a name in small letters, as `response_v`, has no capitals for it.
    pub fn proper_unit(&self) -> Option<&str> {
        let unit = self.unit()?;
        let is_fahrenheit = unit.eq_ignore_ascii_case(FARAD) && self.unit_of(Dimension::Temperature).is_some();
        if unit == "nm" && is_torque(&self.name) {
            return Some(NEWTON_METRES);
        }
        Some(if is_fahrenheit { FAHRENHEIT } else { self.below.as_deref().unwrap_or_else(|| proper(&self.name, unit)) })
    }

    /// The same where it is sure to be a unit: behind an underscore anything may stand, in brackets and below the name a unit.
    pub fn sure_unit(&self) -> Option<&str> {
        let shows = self.below.is_some() || self.name.ends_with([')', ']', '}', '>']);
        self.proper_unit().filter(|unit| shows || is_unit(unit) || is_ratio(unit) || is_newton_metres(unit) || has_prefix(unit))
    }

    /// The unit among those of `dimension`.
    pub fn unit_of(&self, dimension: Dimension) -> Option<&'static str> {
        let found = match &self.below {
            Some(unit) => Some((self.name.as_str(), dimension.unit_like(unit)?)),
            None => split_of(&self.name, dimension),
        };
        found.and_then(|(measured, unit)| meant(measured, unit, dimension))
    }

    /// The unit of `dimension` in the name, where a line of units stands below it.
    pub fn unit_above(&self, dimension: Dimension) -> Option<&'static str> {
        let (measured, unit) = split_of(&self.name, dimension).filter(|_| self.below.is_some())?;
        meant(measured, unit, dimension)
    }

    /// The same where the name alone, or the line of units, shows that it is a unit.
    pub fn shown_unit_of(&self, dimension: Dimension) -> Option<&'static str> {
        let measured = self.unit_in_name().filter(|_| self.below.is_none()).map_or(self.name.as_str(), |(measured, _)| measured);
        meant(measured, dimension.unit_like(self.unit()?)?, dimension)
    }

    /// What is measured: the name without a unit of `dimension`.
    pub fn measured(&self, dimension: Dimension) -> &str {
        split_of(&self.name, dimension).map_or(self.name.trim(), |(measured, _)| measured)
    }
}

/// The sign that stands for two units.
pub(super) const FARAD: &str = "F";
pub(super) const FAHRENHEIT: &str = "degF";

/// The unit as one of `dimension`: `F` is Fahrenheit where a word says that a temperature is measured, and farad elsewhere; a torque has no length.
fn meant(measured: &str, unit: &'static str, dimension: Dimension) -> Option<&'static str> {
    match dimension {
        Dimension::Length if unit == "nm" && is_torque(measured) => None,
        _ if unit != FARAD => Some(unit),
        Dimension::Temperature => told(Role::Temperature, measured).then_some(FAHRENHEIT),
        _ => (!told(Role::Temperature, measured)).then_some(unit),
    }
}

/// The units of a line that holds nothing else: no number, and a known unit in at least one cell. A row of a recording holds a number at least.
pub(super) fn units(cells: &[String]) -> Option<Vec<Option<String>>> {
    let is_number = |cell: &String| cell.replace(',', ".").parse::<f64>().is_ok();
    let units: Vec<Option<String>> = cells.iter().map(|cell| unit(cell)).collect();
    (!cells.iter().any(is_number) && units.iter().flatten().any(|unit| is_unit(unit))).then_some(units)
}

/// What a cell of that line says: with or without brackets, nothing where it is empty or a dash.
fn unit(cell: &str) -> Option<String> {
    let cell = cell.trim().trim_start_matches(['[', '(', '{', '<']).trim_end_matches([']', ')', '}', '>']).trim();
    (!matches!(cell, "" | "-" | "–" | "—")).then(|| cell.to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn cells(line: &str) -> Vec<String> {
        line.split(',').map(str::to_owned).collect()
    }

    #[test]
    fn a_line_of_units_is_told_from_a_row() {
        let some = |text: &str| Some(text.to_owned());
        assert_eq!(units(&cells("s,[N],(°C),-,counts")), Some(vec![some("s"), some("N"), some("°C"), None, some("counts")]));
        for row in ["0,1,74", "warm,cold", "2026-03-01T12:00,N,5", ",,", "nan,s"] {
            assert_eq!(units(&cells(row)), None, "{row}");
        }
    }

    /// Left out of the columns: F alone was taken for a farad.
    #[test]
    fn f_is_fahrenheit_where_a_temperature_is_measured() {
        let both = |heading: Heading| [Dimension::Temperature, Dimension::Capacitance].map(|d| heading.unit_of(d));
        for name in ["Temp (F)", "temperature_f", "T [F]", "Temperatur in F", "Room temp F", "T1 temp, F"] {
            assert_eq!(both(Heading::of(name)), [Some("degF"), None], "{name}");
        }
        for name in ["C (F)", "C_meas/F", "capacitance_f", "Kapazität [F]"] {
            assert_eq!(both(Heading::of(name)), [None, Some("F")], "{name}");
        }
        let below = |name: &str| both(Heading { below: Some("F".into()), ..Heading::of(name) });
        assert_eq!((below("Temp"), below("Cap")), ([Some("degF"), None], [None, Some("F")]));
        let proper = |name: &str| Heading::of(name).proper_unit().map(str::to_owned);
        assert_eq!(
            (proper("Temp (F)"), proper("temp_f"), proper("C (F)")),
            (Some("degF".into()), Some("degF".into()), Some("F".into()))
        );
    }

    /// `torque_nm` was in nanometres, and `Torque/Nm` had no unit.
    #[test]
    fn a_torque_is_in_newton_metres() {
        let read = |name: &str| {
            let heading = Heading::of(name);
            (heading.sure_unit().map(str::to_owned), heading.unit_of(Dimension::Length))
        };
        for name in ["torque_nm", "Torque (Nm)", "Torque/Nm", "moment_Nm", "Drehmoment in Nm", "x [Nm]", "Torque [nm]"] {
            assert_eq!(read(name), (Some("Nm".to_owned()), None), "{name}");
        }
        assert_eq!(read("roughness_nm"), (Some("nm".to_owned()), Some("nm")));
        let below = Heading { below: Some("Nm".to_owned()), ..Heading::of("Torque") };
        assert_eq!((below.sure_unit(), below.unit_of(Dimension::Length)), (Some("Nm"), None));
    }

    /// A diagnosis read it, and `truegap init` asked for it.
    #[test]
    fn a_unit_with_a_prefix_behind_an_underscore_is_one() {
        let sure = |name: &str| Heading::of(name).sure_unit().map(str::to_owned);
        assert_eq!((sure("response_mA"), sure("coil_ma")), (Some("mA".to_owned()), Some("mA".to_owned())));
        assert_eq!((sure("response_meas"), sure("channel_a")), (None, None));
    }

    #[test]
    fn a_line_of_units_outranks_the_name() {
        let heading = Heading { below: Some("mN".into()), ..Heading::of("force") };
        assert_eq!((heading.unit(), heading.unit_of(Dimension::Force)), (Some("mN"), Some("mN")));
        assert_eq!(Heading::of("Force in N").measured(Dimension::Force), "Force");
    }
}
