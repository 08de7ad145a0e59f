//! What the columns of a role are called by default, what they measure and in which unit.
//!
//! Limits: names and units of headings; which column is taken is for [`super::columns`].

use super::{heading::Heading, roles::ROLES};
use crate::inputs::Role;
use crate::units::Dimension;

/// What a role measures; `None` for names, and for readings in any unit.
pub(super) fn dimension(role: Role) -> Option<Dimension> {
    match role {
        Role::Time => Some(Dimension::Time),
        Role::Force => Some(Dimension::Force),
        Role::Pressure => Some(Dimension::Pressure),
        Role::Gap => Some(Dimension::Length),
        Role::Temperature => Some(Dimension::Temperature),
        Role::Humidity => Some(Dimension::Humidity),
        Role::Response | Role::Simulated | Role::Run | Role::Sensor => None,
    }
}

/// The role that a driver of this name plays.
pub(super) fn role_of_driver(name: &str) -> Option<Role> {
    ROLES.into_iter().find(|role| role.key() == name && dimension(*role).is_some())
}

/// Name that the contract gives a role's column.
pub(super) fn default_name(role: Role) -> &'static str {
    match role {
        Role::Pressure => "pressure_kpa",
        Role::Gap => "gap_mm",
        Role::Response => "capacitance_pf",
        other => other.column_name(),
    }
}

/// Whether a column is one that a role has by default: the role's word, alone or with a unit behind it.
pub(super) fn is_default(role: Role, heading: &Heading) -> bool {
    let words: &[&str] = if role == Role::Response { &["capacitance", "response"] } else { &[role.key()] };
    let is_word = |text: &str| words.iter().any(|word| text.trim_end_matches('_').trim().eq_ignore_ascii_case(word));
    let lower = heading.name.trim().to_ascii_lowercase();
    let shown = heading.unit_in_name().map(|(measured, _)| measured.to_ascii_lowercase());
    match role {
        _ if is_word(&heading.name) => true,
        Role::Run | Role::Sensor => false,
        Role::Simulated => lower.starts_with("simulated_") || shown.is_some_and(|measured| is_word(&measured)),
        Role::Response if lower.starts_with("response_") || shown.as_deref() == Some("response") => true,
        _ => {
            let dimension = dimension(role).unwrap_or(Dimension::Capacitance);
            heading.unit_of(dimension).is_some() && is_word(heading.measured(dimension))
        }
    }
}

/// Whether a column's name is a role's word with one more behind it, where a unit stands: `force_xyz`, `Force [pF]`.
pub(super) fn called_after(role: Role, heading: &Heading) -> bool {
    heading.unit_in_name().is_some_and(|(measured, _)| measured.trim_end_matches('_').trim().eq_ignore_ascii_case(role.key()))
}

/// The unit of a role's column, as the header shows it.
pub(super) fn shown_unit(role: Role, heading: &Heading) -> Option<String> {
    match dimension(role) {
        Some(dimension) => heading.unit_of(dimension).map(str::to_owned),
        None => {
            let known = heading.unit_of(Dimension::Capacitance).or(heading.unit_of(Dimension::Voltage));
            known.or_else(|| heading.sure_unit()).map(str::to_owned)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_column_called_after_a_role_has_one_word_behind_it() {
        assert!(called_after(Role::Force, &Heading::of("force_pa")) && called_after(Role::Force, &Heading::of("Force [xyz]")));
        assert!(
            !called_after(Role::Force, &Heading::of("force_setpoint_n"))
                && !called_after(Role::Force, &Heading::of("force"))
                && !called_after(Role::Time, &Heading::of("timer_s"))
        );
    }

    #[test]
    fn a_default_name_is_the_word_and_a_unit() {
        assert!(
            is_default(Role::Force, &Heading::of("force_n"))
                && is_default(Role::Force, &Heading::of("Force [mN]"))
                && is_default(Role::Pressure, &Heading::of("pressure_bar"))
        );
        assert!(!is_default(Role::Force, &Heading::of("force_setpoint_n")) && !is_default(Role::Force, &Heading::of("force_pf")));
        assert!(
            is_default(Role::Response, &Heading::of("capacitance_ff"))
                && is_default(Role::Response, &Heading::of("response_counts"))
        );
        assert!(!is_default(Role::Response, &Heading::of("capacitance_spare_pf")));
        assert!(is_default(Role::Run, &Heading::of("run")) && !is_default(Role::Run, &Heading::of("running_hours")));
    }
}
