//! Units behind an underscore in a name that is written in small letters: `response_v` is in V.
//!
//! Limits: where small letters leave two units, as `mpa` does, the tail stays as it is written.

/// Units that have a capital, with what becomes of them in small letters.
const CAPITALS: [(&str, &str); 34] = [
    ("v", "V"),
    ("uv", "uV"),
    ("mv", "mV"),
    ("kv", "kV"),
    ("a", "A"),
    ("na", "nA"),
    ("ua", "uA"),
    ("ma", "mA"),
    ("ohm", "Ohm"),
    ("kohm", "kOhm"),
    ("w", "W"),
    ("mw", "mW"),
    ("kw", "kW"),
    ("j", "J"),
    ("hz", "Hz"),
    ("khz", "kHz"),
    ("mhz", "MHz"),
    ("ghz", "GHz"),
    ("n", "N"),
    ("mn", "mN"),
    ("kn", "kN"),
    ("pa", "Pa"),
    ("hpa", "hPa"),
    ("kpa", "kPa"),
    ("gpa", "GPa"),
    ("mmhg", "mmHg"),
    ("c", "degC"),
    ("degc", "degC"),
    ("degf", "degF"),
    ("k", "K"),
    ("mk", "mK"),
    ("t", "T"),
    ("mt", "mT"),
    ("db", "dB"),
];

/// The unit of a torque.
pub(super) const NEWTON_METRES: &str = "Nm";

/// Whether a text is the unit of a torque, in capitals as it is written; in small letters it is nanometres.
pub(super) fn is_newton_metres(unit: &str) -> bool {
    let letters: String = unit.chars().filter(|c| c.is_alphanumeric()).collect();
    letters == NEWTON_METRES || matches!(letters.as_str(), "mNm" | "kNm")
}

/// Whether a text is a unit of the table as it is written, with more than one letter: one alone may number a channel.
pub(super) fn has_prefix(unit: &str) -> bool {
    unit.len() > 1 && CAPITALS.iter().any(|(_, proper)| *proper == unit)
}

/// The unit that the tail of a name in small letters stands for; `unit` itself in any other name, and where no unit is known by it.
pub(super) fn proper<'a>(name: &str, unit: &'a str) -> &'a str {
    let is_tail = name.trim().strip_suffix(unit).is_some_and(|measured| measured.ends_with('_'));
    let found = CAPITALS.iter().find(|(small, _)| is_tail && *small == unit);
    found.map_or(unit, |(_, proper)| proper)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_tail_in_small_letters_is_the_unit_that_it_stands_for() {
        assert_eq!([proper("response_v", "v"), proper("fan_mv", "mv"), proper("oven_c", "c")], ["V", "mV", "degC"]);
        // what somebody wrote with care, or what may be two things, stays
        for (name, unit) in
            [("U [v]", "v"), ("response_V", "V"), ("speed_rpm", "rpm"), ("p_mpa", "mpa"), ("response_counts", "counts")]
        {
            assert_eq!(proper(name, unit), unit, "{name}");
        }
    }
}
