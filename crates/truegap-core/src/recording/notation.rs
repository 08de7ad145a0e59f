//! How people write a unit into the name of a column: one table of notations.
//!
//! Limits: the name alone; where a unit stands in a line of its own under the header, see [`super::heading`].

use super::small_letters::is_newton_metres;
use crate::units::{Dimension, is_unit};

/// How far what stands where a unit may stand is to be trusted to be one.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Trust {
    /// nothing but a unit stands there, known or not
    Any,
    /// a unit of anything that is measured
    Known,
    /// a unit of what the rest of the name says is measured, and no other
    Fitting,
}

/// A place in a name where a unit may stand.
struct Notation {
    /// an example: name, what is measured, unit
    #[cfg_attr(not(test), allow(dead_code))]
    example: (&'static str, &'static str, &'static str),
    /// what is measured, and the unit
    cut: fn(&str) -> Option<(&str, &str)>,
    trust: Trust,
}

/// Every notation, the surest first.
const NOTATIONS: [Notation; 13] = [
    Notation { example: ("Load cell [N]", "Load cell", "N"), cut: |name| brackets(name, '[', ']'), trust: Trust::Any },
    Notation { example: ("temp (°C)", "temp", "°C"), cut: |name| brackets(name, '(', ')'), trust: Trust::Any },
    Notation { example: ("F {mN}", "F", "mN"), cut: |name| brackets(name, '{', '}'), trust: Trust::Any },
    Notation { example: ("F <mN>", "F", "mN"), cut: |name| brackets(name, '<', '>'), trust: Trust::Any },
    Notation { example: ("C_meas/pF", "C_meas", "pF"), cut: slash, trust: Trust::Known },
    Notation { example: ("T in degC", "T", "degC"), cut: |name| name.rsplit_once(" in "), trust: Trust::Known },
    Notation { example: ("force, N", "force", "N"), cut: |name| name.rsplit_once([',', ';', ':']), trust: Trust::Known },
    Notation { example: ("force_n", "force", "n"), cut: |name| name.rsplit_once('_'), trust: Trust::Any },
    Notation { example: ("Force..N.", "Force", "N"), cut: dots, trust: Trust::Fitting },
    Notation { example: ("force-N", "force", "N"), cut: |name| name.rsplit_once('-'), trust: Trust::Fitting },
    Notation { example: ("Temp deg C", "Temp", "deg C"), cut: degrees, trust: Trust::Fitting },
    Notation { example: ("Load cell N", "Load cell", "N"), cut: |name| name.rsplit_once(' '), trust: Trust::Fitting },
    Notation { example: ("tempC", "temp", "C"), cut: humps, trust: Trust::Fitting },
];

/// A name in which the unit stands in brackets at the end.
fn brackets(name: &str, open: char, close: char) -> Option<(&str, &str)> {
    name.strip_suffix(close)?.rsplit_once(open)
}

/// A name with its unit behind a slash that belongs to no unit.
fn slash(name: &str) -> Option<(&str, &str)> {
    if ratio(name).is_some() { None } else { name.split_once('/') }
}

/// A name that ends with a unit over a unit; one letter in front of the slash is the sign of what is measured, as in `Kraft F/N`.
fn ratio(name: &str) -> Option<(&str, &str)> {
    name.rsplit_once(' ').filter(|(_, unit)| is_ratio(unit))
}

/// Whether this is a unit over a unit.
pub(super) fn is_ratio(unit: &str) -> bool {
    unit.split_once('/').is_some_and(|(over, under)| over.chars().count() > 1 && is_unit(over) && is_unit(under))
}

/// `Force (N)` as R makes a name of it.
fn dots(name: &str) -> Option<(&str, &str)> {
    let (measured, unit) = name.trim_end_matches('.').rsplit_once('.')?;
    Some((measured.trim_end_matches('.'), unit))
}

/// A name that ends with degrees in two words.
fn degrees(name: &str) -> Option<(&str, &str)> {
    [" deg", " °", " º"].into_iter().find_map(|sign| name.find(sign)).map(|at| name.split_at(at))
}

/// A name that ends with a capital behind small letters; `pH` is one word.
fn humps(name: &str) -> Option<(&str, &str)> {
    if name.strip_suffix("pH").is_some_and(|before| !before.ends_with(char::is_alphabetic)) {
        return None;
    }
    let small = name.char_indices().rev().find(|(_, c)| c.is_lowercase())?;
    let at = if name.ends_with(|c: char| c.is_uppercase()) { small.0 + small.1.len_utf8() } else { return None };
    Some((&name[..at], &name[at..]))
}

/// What is measured and the text of the unit, by the first notation that `holds` lets pass.
fn cut(name: &str, holds: impl Fn(Trust, &str) -> bool) -> Option<(&str, &str)> {
    let name = name.trim();
    NOTATIONS.iter().find_map(|notation| {
        let (measured, unit) = (notation.cut)(name)?;
        let (measured, unit) = (measured.trim(), unit.trim());
        (!measured.is_empty() && !unit.is_empty() && holds(notation.trust, unit)).then_some((measured, unit))
    })
}

/// What is measured, and the unit, where the name itself shows that it is one: known, or in brackets or behind an underscore.
pub(super) fn split(name: &str) -> Option<(&str, &str)> {
    let shows = |trust, unit: &str| trust == Trust::Any || (trust == Trust::Known && (is_unit(unit) || is_newton_metres(unit)));
    ratio(name).or_else(|| cut(name, shows))
}

/// What is measured, and its unit among those of `dimension`, in any notation.
pub(super) fn split_of(name: &str, dimension: Dimension) -> Option<(&str, &'static str)> {
    let (measured, unit) = cut(name, |_, unit| dimension.unit_like(unit).is_some())?;
    Some((measured, dimension.unit_like(unit)?))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The name alone shows the unit where no other text can stand there; else it needs to be known what is measured.
    #[test]
    fn every_notation_is_cut_as_its_example_says() {
        let measured = [Dimension::Force, Dimension::Temperature, Dimension::Capacitance];
        for notation in &NOTATIONS {
            let (name, what, unit) = notation.example;
            let found =
                measured.into_iter().find_map(|d| split_of(name, d).filter(|(_, found)| d.unit_like(unit) == Some(*found)));
            assert_eq!(found.map(|(what, _)| what), Some(what), "{name}");
            let shown = (notation.trust < Trust::Fitting).then_some((what, unit));
            assert_eq!(split(name).filter(|(_, found)| *found == unit), shown, "{name}");
        }
    }

    #[test]
    fn what_is_no_unit_is_not_cut_off() {
        for name in [
            "load/unload",
            "check in progress",
            "counts",
            "Channel C",
            "run-2",
            "[N]",
            "v/mm/s",
            "force",
            "Fz",
            "pH",
            "buffer pH",
        ] {
            assert_eq!(split(name), None, "{name}");
        }
        assert_eq!(split("U/(mV/V)"), Some(("U/", "mV/V")));
        assert_eq!(split("bridge [mV/V]"), Some(("bridge", "mV/V")));
        assert_eq!(split("Brücke mV/V"), Some(("Brücke", "mV/V")));
        assert_eq!(split("Kraft F/N"), Some(("Kraft F", "N")));
        assert_eq!(split_of("force_setpoint_n", Dimension::Force), Some(("force_setpoint", "N")));
        assert_eq!(split_of("force_pf", Dimension::Force), None);
        assert_eq!((split_of("pH", Dimension::Time), split_of("runH", Dimension::Time)), (None, Some(("run", "h"))));
        assert_eq!(split_of("pressure [mPa]", Dimension::Pressure), None);
    }
}
