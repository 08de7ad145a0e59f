//! Units and measures as a file writes them.

use super::*;

#[test]
fn a_text_with_a_unit_becomes_si() {
    let cases = [
        ("180 um", Dimension::Length, 180e-6),
        ("1.075MPa", Dimension::Pressure, 1.075e6),
        ("-7.6 kPa/K", Dimension::PressurePerKelvin, -7600.0),
        ("300 K", Dimension::Temperature, 26.85),
        ("50 °C", Dimension::Temperature, 50.0),
        ("1e-3 m", Dimension::Length, 1e-3),
        ("3.4", Dimension::Ratio, 3.4),
        ("25µm", Dimension::Length, 25e-6),
    ];
    for (text, dimension, si) in cases {
        approx::assert_relative_eq!(parse(text, dimension).unwrap(), si, max_relative = 1e-14);
    }
}

#[test]
fn the_end_of_a_name_is_a_unit_in_any_case_that_can_be_meant() {
    for (text, unit) in
        [("pf", "pF"), ("PF", "pF"), ("kpa", "kPa"), ("KPa", "kPa"), ("mn", "mN"), ("MM", "mm"), ("°C", "degC"), ("sec", "s")]
    {
        let found = [
            Dimension::Capacitance,
            Dimension::Pressure,
            Dimension::Force,
            Dimension::Length,
            Dimension::Temperature,
            Dimension::Time,
        ];
        assert!(found.into_iter().any(|d| d.unit_like(text) == Some(unit)), "{text}");
    }
    // capitals alone say nothing of which was meant
    assert_eq!([Dimension::Force.unit_like("MN"), Dimension::Voltage.unit_like("MV")], [None, None]);
    assert_eq!([Dimension::Force.unit_like("mn"), Dimension::Length.unit_like("MM")], [Some("mN"), Some("mm")]);
    // read as MPa before: a thousandth of a pascal is no million
    assert_eq!((Dimension::Pressure.unit_like("mPa"), Dimension::Pressure.unit_like("MPa")), (None, Some("MPa")));
    assert!(is_unit("min") && is_unit("% RH") && !is_unit("counts") && !is_unit(""));
}

#[test]
fn a_spread_may_be_relative_or_in_a_unit() {
    let relative = Measure::parse("34 um +- 5 %", Dimension::Length).unwrap();
    let absolute = Measure::parse("34 um ± 1.7 um", Dimension::Length).unwrap();
    approx::assert_relative_eq!(relative.sd, absolute.sd, max_relative = 1e-14);
    approx::assert_relative_eq!(relative.sd, 1.7e-6, max_relative = 1e-14);
}

#[test]
fn what_is_wrong_is_named() {
    assert!(matches!(parse("180", Dimension::Length), Err(UnitError::Missing { .. })));
    assert!(matches!(parse("180 N", Dimension::Length), Err(UnitError::Unknown { .. })));
    assert!(matches!(parse("thick", Dimension::Length), Err(UnitError::NotANumber { .. })));
    assert!(matches!(parse("inf m", Dimension::Length), Err(UnitError::NotANumber { .. })));
    assert!(matches!(parse("1e308 kN", Dimension::Force), Err(UnitError::TooLarge { .. })));
}

#[test]
fn what_cannot_be_is_refused() {
    for text in ["-300 degC", "-1 K", "-460 degF"] {
        assert!(matches!(parse(text, Dimension::Temperature), Err(UnitError::BelowAbsoluteZero { .. })), "{text}");
    }
    for text in ["0 K", "-273.15 degC", "-459.67 degF"] {
        approx::assert_abs_diff_eq!(parse(text, Dimension::Temperature).unwrap(), ABSOLUTE_ZERO_C, epsilon = 1e-9);
    }
    assert!(parse("-300 K", Dimension::TemperatureDifference).is_ok(), "a difference may be anything");
    for text in ["162 um +- -5 um", "162 um +- -5 %"] {
        assert!(matches!(Measure::parse(text, Dimension::Length), Err(UnitError::NegativeSpread { .. })), "{text}");
    }
}

#[test]
fn very_large_and_very_small_numbers_are_powers_of_ten() {
    let told = [(1e300, "1e300"), (-4.5, "-4.5"), (1e-300, "1e-300"), (0.0, "0"), (0.1 + 0.2, "0.3"), (f64::NAN, "NaN")];
    for (value, text) in told {
        assert_eq!(readable(value), text);
    }
}

#[test]
fn messages_show_the_number_that_was_written() {
    // there and back through SI, as a thickness in um goes
    for (scaled, written) in
        [(-162.0 * 1e-6 * 1e6, "-162"), (0.1 + 0.2, "0.3"), (-5e-4, "-0.0005"), (123_456.789_012, "123456.789012")]
    {
        assert_eq!(twelve_digits(scaled).to_string(), written);
    }
    assert_ne!((-162.0 * 1e-6 * 1e6).to_string(), "-162", "nothing to round here");
    assert!(twelve_digits(f64::NAN).is_nan() && twelve_digits(f64::NEG_INFINITY) == f64::NEG_INFINITY);
}
