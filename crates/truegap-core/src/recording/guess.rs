//! Which column of a header plays which role, as far as names, units and dates show it.
//!
//! Limits: a role is taken where one column alone fits; where several do, they are told and none is taken.

use super::{
    default_names::{dimension, is_default},
    heading::Heading,
    roles::ROLES,
    words::told,
};
use crate::inputs::Role;
use crate::units::Dimension;
use std::collections::BTreeMap;

/// What a header shows.
#[derive(Debug, Default)]
pub(super) struct Guess {
    /// the column of a role, as an index of the header
    pub found: BTreeMap<Role, usize>,
    /// the columns of a role that several fit
    pub several: BTreeMap<Role, Vec<usize>>,
}

/// Whether a column may have a role, by one kind of evidence.
type Step<'a> = &'a dyn Fn(Role, &Heading) -> bool;

/// Guesses among the columns `usable`: by the default name, then by a word of the name, then by the unit, then by what is left over.
pub(super) fn guess(header: &[Heading], usable: &[usize]) -> Guess {
    // a day is a clock where nothing better is
    let left_over =
        |role: Role, heading: &Heading| if role == Role::Time { heading.days } else { role == Role::Response && !heading.dated };
    by_steps(header, usable, &[&is_default, &called, &measured, &left_over])
}

/// The same by names alone: the default one, or a word. A unit, or what is left over, is enough for a proposal that somebody looks at, and too little where nobody does.
pub(super) fn by_name(header: &[Heading], usable: &[usize]) -> Guess {
    by_steps(header, usable, &[&is_default, &called])
}

/// The columns that a name or a unit alone tells to be a reading, before anything that is left over.
pub(super) fn surely_read(header: &[Heading], usable: &[usize]) -> Vec<usize> {
    let mut guess = by_steps(header, usable, &[&is_default, &called, &measured]);
    let several = guess.several.remove(&Role::Response).unwrap_or_default();
    guess.found.remove(&Role::Response).into_iter().chain(several).collect()
}

fn by_steps(header: &[Heading], usable: &[usize], steps: &[Step<'_>]) -> Guess {
    let mut guess = Guess::default();
    for (number, fits) in steps.iter().enumerate() {
        for role in ROLES {
            if guess.found.contains_key(&role) || guess.several.contains_key(&role) {
                continue;
            }
            let fit = |index: &&usize| !guess.found.values().any(|taken| taken == *index) && fits(role, &header[**index]);
            let free: Vec<usize> = usable.iter().filter(fit).copied().collect();
            match free.as_slice() {
                [] => {}
                [only] => drop(guess.found.insert(role, *only)),
                // what is left over need not be a reading
                _ if number < 3 => drop(guess.several.insert(role, free)),
                _ => {}
            }
        }
    }
    guess
}

/// Whether a word of the name tells the role, and its unit does not tell another.
fn called(role: Role, heading: &Heading) -> bool {
    let of = |role: Role| dimension(role).is_some_and(|dimension| heading.unit_of(dimension).is_some());
    if heading.dated || !told(role, without_unit(heading)) {
        return heading.dated && !heading.days && role == Role::Time;
    }
    match role {
        // a reading is in any unit, but no clock and no thermometer is one
        Role::Response => !of(Role::Time) && !of(Role::Temperature),
        _ => of(role) || !told_by_unit(heading),
    }
}

/// What a unit may be one of.
fn dimensions() -> impl Iterator<Item = Dimension> {
    ROLES.into_iter().filter_map(dimension).chain([Dimension::Capacitance, Dimension::Voltage])
}

/// The name without what may be a unit: `pF` is no word for a pressure.
fn without_unit(heading: &Heading) -> &str {
    let by_unit =
        dimensions().find(|dimension| heading.unit_of(*dimension).is_some()).map(|dimension| heading.measured(dimension));
    by_unit.or(heading.unit_in_name().map(|(measured, _)| measured)).unwrap_or(&heading.name)
}

/// Whether the unit, seen without the name, is one of a role's.
fn told_by_unit(heading: &Heading) -> bool {
    let unit = heading.unit().unwrap_or_default();
    dimensions().any(|dimension| dimension.unit_like(unit).is_some())
}

/// Whether the unit is one of the role; a length need not be the gap between plates.
fn measured(role: Role, heading: &Heading) -> bool {
    let dimension = if role == Role::Response { Some(Dimension::Capacitance) } else { dimension(role) };
    role != Role::Gap && !heading.dated && dimension.is_some_and(|dimension| heading.shown_unit_of(dimension).is_some())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn roles(header: &str) -> String {
        let header: Vec<Heading> = header.split(';').map(Heading::of).collect();
        let guess = guess(&header, &(0..header.len()).collect::<Vec<_>>());
        let found = guess.found.iter().map(|(role, at)| format!("{}={at}", role.key()));
        found.chain(guess.several.iter().map(|(role, at)| format!("{}?{at:?}", role.key()))).collect::<Vec<_>>().join(" ")
    }

    /// Headers as people write them, each with what somebody who reads it would say.
    #[test]
    fn headers_as_people_write_them() {
        let all = "time=0 force=1 temperature=2 response=3";
        for header in [
            "t/s;Fz/N;T/°C;C_meas/pF",
            "Time (s);Force (N);temp (°C);Capacitance (pF)",
            "t/ms;F [mN];T in degC;C [pF]",
            "Zeit [s];Kraft [N];Temperatur [°C];Kapazität [pF]",
            "Temps (s);Force (N);Température (°C);Capacité (pF)",
            "Elapsed Time (sec);Applied Force (Newton);Temp (Celsius);Cap (picofarad)",
            "time.s;force.N;temp.C;cap.pF",
            "time {s};force {N};temp {°C};cap {pF}",
            "time, s;force, N;temp, °C;cap, pF",
            "Time [s];Load [g];Temp [deg C];Count",
            "timeS;loadN;tempC;reading",
            "t;F;T;C",
            "Time [s];Load cell [N];T_chamber [K];Bridge (mV/V)",
            "elapsed [min];fz [N];Load cell temp [K];C1",
            "Time (s);Load (lbf);Temp (F);Cap (pF)",
            "time_s;force_n;temperature_f;capacitance_f",
            "Zeit [s];Kraft [N];T [F];Kanal 1 [F]",
        ] {
            assert_eq!(roles(header), all, "{header}");
        }
        assert_eq!(roles("zeit in min;Druck in kPa;rel. Feuchte in %;Spannung in mV"), "time=0 pressure=1 humidity=2 response=3");
    }

    #[test]
    fn where_several_fit_none_is_taken() {
        assert_eq!(roles("t/s;C1/pF;C2/pF"), "time=0 response?[1, 2]");
        assert_eq!(roles("t/s;T1 [°C];T2 [°C];C/pF"), "time=0 response=3 temperature?[1, 2]");
        assert_eq!(roles("time_s;force_n;force_setpoint_n;capacitance_pf"), "time=0 force=1 response=3");
        // a length is no gap before somebody says so, and a word outranks a unit
        assert_eq!(roles("t/s;position [mm];C/pF"), "time=0 response=2");
    }
}
