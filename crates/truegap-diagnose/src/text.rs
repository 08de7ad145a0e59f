//! Numbers as a person reads them: units that fit the size, digits that fit the error.
//!
//! Limits: only SI units without a prefix are rescaled; what already carries a prefix is left as it is.

/// A unit for display and the factor that leads to it.
#[derive(Clone, Debug, PartialEq)]
pub struct Scale {
    /// displayed value = factor x stored value
    pub factor: f64,
    /// displayed unit
    pub unit: String,
}

const PREFIXES: [(&str, i32); 9] =
    [("G", 9), ("M", 6), ("k", 3), ("", 0), ("m", -3), ("µ", -6), ("n", -9), ("p", -12), ("f", -15)];
const FARADS: [(&str, i32); 5] = [("aF", -18), ("fF", -15), ("pF", -12), ("nF", -9), ("µF", -6)];
const TAKES_PREFIX: [&str; 6] = ["Pa", "N", "m", "V", "Pa/K", "Hz"];

impl Scale {
    /// The unit in which a value of this size (stored in `unit`) reads as a number from 1 to 1000, where there is one.
    pub fn of(unit: &str, size: f64) -> Self {
        let same = Self { factor: 1.0, unit: if unit == "1" { String::new() } else { unit.replace("degC", "°C") } };
        if !size.is_finite() || size == 0.0 {
            return same;
        }
        if let Some(exponent) = farad_exponent(unit) {
            return farads(exponent, size.abs());
        }
        match unit {
            "s" => seconds(size.abs()),
            "s/s" if size.abs() < 1.0 => Self { unit: format!("{}/s", seconds(size.abs()).unit), ..seconds(size.abs()) },
            "1/K" if size.abs() < 1e-2 => Self { factor: 1e6, unit: "ppm/K".into() },
            "1/K" => Self { factor: 1e2, unit: "%/K".into() },
            "1/h" if size.abs() < 1e-2 => Self { factor: 1e6, unit: "ppm/h".into() },
            "1/h" => Self { factor: 1e2, unit: "%/h".into() },
            "1/%RH" => Self {
                factor: if size.abs() < 1e-2 { 1e6 } else { 1e2 },
                unit: if size.abs() < 1e-2 { "ppm/%RH" } else { "%/%RH" }.into(),
            },
            "%" | "%/K" if size.abs() < 1e-2 => Self { factor: 1e4, unit: unit.replace('%', "ppm") },
            "K" if size.abs() < 0.1 => Self { factor: 1e3, unit: "mK".into() },
            _ if TAKES_PREFIX.contains(&unit) => prefixed(unit, size.abs()),
            _ if unit.ends_with(" m") => by_length(unit.trim_end_matches(" m"), size.abs()),
            _ => same,
        }
    }

    /// `value` in the displayed unit with three significant digits, and the unit.
    pub fn text(&self, value: f64) -> String {
        join(&significant(value * self.factor, 3), &self.unit)
    }

    /// A column in the displayed unit.
    pub fn column(&self, values: &[f64]) -> Vec<f64> {
        values.iter().map(|v| v * self.factor).collect()
    }
}

fn farad_exponent(unit: &str) -> Option<i32> {
    match unit {
        "F" => Some(0),
        "uF" => Some(-6),
        _ => FARADS.iter().find(|(name, _)| *name == unit).map(|(_, exponent)| *exponent),
    }
}

fn farads(stored: i32, size: f64) -> Scale {
    let fits = |exponent: i32| size * 10f64.powi(stored - exponent) >= 1.0;
    let (name, exponent) = FARADS.iter().rev().find(|(_, exponent)| fits(*exponent)).unwrap_or(&FARADS[0]);
    Scale { factor: 10f64.powi(stored - exponent), unit: (*name).to_owned() }
}

fn seconds(size: f64) -> Scale {
    let (factor, unit) = match size {
        s if s < 1e-3 => (1e6, "µs"),
        s if s < 1.0 => (1e3, "ms"),
        s if s < 600.0 => (1.0, "s"),
        s if s < 10_800.0 => (1.0 / 60.0, "min"),
        s if s < 345_600.0 => (1.0 / 3600.0, "h"),
        s if s < 6.3e7 => (1.0 / 86_400.0, "days"),
        _ => (1.0 / 31_557_600.0, "years"),
    };
    Scale { factor, unit: unit.into() }
}

fn prefixed(unit: &str, size: f64) -> Scale {
    let fits = |exponent: &i32| size >= 10f64.powi(*exponent);
    let (prefix, exponent) = PREFIXES.iter().find(|(_, exponent)| fits(exponent)).unwrap_or(&PREFIXES[8]);
    Scale { factor: 10f64.powi(-exponent), unit: format!("{prefix}{unit}") }
}

/// A quantity times a length, such as pF m: the length takes the prefix.
fn by_length(unit: &str, size: f64) -> Scale {
    let length = prefixed("m", size);
    Scale { factor: length.factor, unit: format!("{unit} {}", length.unit) }
}

fn join(number: &str, unit: &str) -> String {
    if unit.is_empty() { number.to_owned() } else { format!("{number} {unit}") }
}

/// `value` with so many significant digits; powers of ten where it is very small or large.
pub fn significant(value: f64, digits: usize) -> String {
    if !value.is_finite() {
        return "–".into();
    }
    if value == 0.0 {
        return "0".into();
    }
    to_place(value, digits as i32 - 1 - value.abs().log10().floor() as i32)
}

/// `value` rounded to so many places after the point, before it where they are negative; powers of ten where it is very small or large.
fn to_place(value: f64, places: i32) -> String {
    let factor = 10f64.powi(places);
    let rounded = (value * factor).round() / factor;
    if rounded == 0.0 {
        return "0".into();
    }
    let exponent = (rounded.abs() * (1.0 + 1e-12)).log10().floor() as i32;
    if !(-4..7).contains(&exponent) {
        return format!("{rounded:.*e}", (places + exponent).max(0) as usize);
    }
    format!("{rounded:.*}", places.max(0) as usize)
}

/// `4.20 min (sd 0.10)`: the one way in which a sentence tells a number with its error.
///
/// Three significant digits at most, fewer where the error is large, in the unit that fits; the error has two at most, and no place that the number does not
/// have. Where it is smaller than the number's last place it is told as `sd < 0.01`; where there is none, it is left out.
pub(crate) fn with_sd(value: f64, sd: f64, unit: &str) -> String {
    if !(sd.is_finite() && sd > 0.0 && value.is_finite()) {
        return rounded(value, unit);
    }
    let scale = Scale::of(unit, value.abs().max(sd));
    let (value, sd) = (value * scale.factor, sd * scale.factor);
    let first = |x: f64| x.abs().log10().floor() as i32;
    let of_error = 1 - first(sd);
    let places = if value == 0.0 { of_error } else { of_error.min(2 - first(value)) };
    let step = 10f64.powi(-places);
    let error = if sd < 0.5 * step { format!("< {}", significant(step, 1)) } else { to_place(sd, places) };
    format!("{} (sd {error})", join(&to_place(value, places), &scale.unit))
}

/// A share with its error in per cent, or in ppm where it is small.
pub(crate) fn percent_with_sd(share: f64, sd: f64) -> String {
    with_sd(100.0 * share, 100.0 * sd, "%")
}

/// A share in per cent with two significant digits, or in ppm where it is small.
pub(crate) fn percent_of(share: f64) -> String {
    let scale = Scale::of("%", 100.0 * share.abs());
    join(&significant(100.0 * share * scale.factor, 2), &scale.unit)
}

/// `4.20 min`: three significant digits in the unit that fits.
pub fn rounded(value: f64, unit: &str) -> String {
    Scale::of(unit, value.abs()).text(value)
}

/// `value ± sd unit`, with two digits of the error; the unit fits the value.
pub fn measured(value: f64, sd: f64, unit: &str) -> String {
    let scale = Scale::of(unit, value.abs().max(sd));
    let (value, sd) = (value * scale.factor, sd * scale.factor);
    if !sd.is_finite() || sd <= 0.0 {
        return join(&significant(value, 4), &scale.unit);
    }
    let places = 1 - sd.log10().floor() as i32;
    if places > 7 || value.abs() >= 1e7 {
        return join(&format!("{} ± {}", significant(value, 6), significant(sd, 2)), &scale.unit);
    }
    let decimals = places.max(0) as usize;
    let rounded = format!("{value:.decimals$}");
    // what rounds to nothing has no sign
    let value = rounded.strip_prefix('-').filter(|digits| digits.chars().all(|c| c == '0' || c == '.')).unwrap_or(&rounded);
    join(&format!("{value} ± {sd:.decimals$}"), &scale.unit)
}

/// `1.20 to 3.40 N`: both ends in the unit that fits the larger, with three significant digits of it.
pub(crate) fn interval(low: f64, high: f64, unit: &str) -> String {
    let scale = Scale::of(unit, low.abs().max(high.abs()));
    let (low, high) = (low * scale.factor, high * scale.factor);
    let largest = low.abs().max(high.abs());
    let decimals = if largest > 0.0 { (2 - largest.log10().floor() as i32).clamp(0, 9) as usize } else { 0 };
    join(&format!("{} to {}", fixed(low, decimals), fixed(high, decimals)), &scale.unit)
}

/// Fixed decimals, and no minus before a zero.
fn fixed(value: f64, decimals: usize) -> String {
    let text = format!("{value:.decimals$}");
    if text.trim_start_matches('-').chars().all(|c| matches!(c, '0' | '.')) {
        text.trim_start_matches('-').to_owned()
    } else {
        text
    }
}

/// Two values of one quantity in one unit: three significant digits, more where they would read the same.
pub(crate) fn two(first: f64, second: f64, unit: &str) -> (String, String) {
    let scale = Scale::of(unit, first.abs().max(second.abs()));
    let text = |value: f64, digits: usize| join(&significant(value * scale.factor, digits), &scale.unit);
    let apart = |digits: &usize| text(first, *digits) != text(second, *digits);
    let digits = (3..=7).find(apart).unwrap_or(3);
    (text(first, digits), text(second, digits))
}

/// A probability in per cent that never claims certainty.
pub fn percent(probability: f64) -> String {
    match probability {
        p if !p.is_finite() => "–".into(),
        p if p > 0.999 => "> 99.9 %".into(),
        p if p < 0.001 => "< 0.1 %".into(),
        p if !(0.01..=0.99).contains(&p) => format!("{:.1} %", 100.0 * p),
        p => format!("{:.0} %", 100.0 * p),
    }
}

/// Standard deviations between two things: three digits, and a ceiling above which they mean nothing.
pub(crate) fn deviations(count: f64) -> String {
    match count {
        n if n >= 1000.0 => "more than 1000".into(),
        n if n < 10.0 => significant(n, 2),
        n => significant(n, 3),
    }
}

/// A detectability with three digits, and a ceiling above which they mean nothing.
pub fn detectability(d: f64) -> String {
    if d >= 1000.0 { "over 1000".into() } else { significant(d, 3) }
}

/// A p-value to one digit, with a floor below which the digits mean nothing.
pub fn p_value(p: f64) -> String {
    match p {
        p if !p.is_finite() => "–".into(),
        p if p < 1e-12 => "< 1e-12".into(),
        p if p < 1e-3 => format!("{p:.0e}"),
        p => significant(p, 2),
    }
}

/// `thermal lag` from `thermal_lag`.
pub fn spoken(id: &str) -> String {
    id.replace('_', " ").replace("mullins", "Mullins")
}

/// The text with its first letter made a capital.
pub fn capitalised(text: &str) -> String {
    let mut characters = text.chars();
    characters.next().map_or(String::new(), |first| first.to_uppercase().chain(characters).collect())
}

/// The text with its first letter made small, where it is not a name (`Young's modulus` stays).
pub(crate) fn uncapitalised(text: &str) -> String {
    const NAMES: [&str; 2] = ["Young", "Poisson"];
    let mut characters = text.chars();
    match characters.next() {
        Some(first) if !NAMES.iter().any(|name| text.starts_with(name)) => first.to_lowercase().chain(characters).collect(),
        _ => text.to_owned(),
    }
}

/// `a`, `a and b`, `a, b and c`, with the given last word.
pub fn listed<S: AsRef<str>>(items: &[S], last: &str) -> String {
    match items {
        [] => String::new(),
        [one] => one.as_ref().to_owned(),
        [start @ .., end] => {
            let start: Vec<&str> = start.iter().map(AsRef::as_ref).collect();
            format!("{} {last} {}", start.join(", "), end.as_ref())
        }
    }
}

/// Ids as a reader says them, [`listed`]: `thermal lag and offset drift`.
pub fn spoken_list<S: AsRef<str>>(ids: impl IntoIterator<Item = S>, last: &str) -> String {
    listed(&ids.into_iter().map(|id| spoken(id.as_ref())).collect::<Vec<_>>(), last)
}

/// What is left where `removed` is removed, in words that never say that nothing is.
pub(crate) fn share_left(removed: f64) -> String {
    let left = 100.0 * (1.0 - removed);
    if left < 1.0 { "less than 1 %".into() } else { format!("{left:.0} %") }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_person_keeps_the_capital() {
        assert_eq!(spoken("mullins_softening"), "Mullins softening");
    }

    #[test]
    fn a_value_is_shown_in_the_unit_that_fits_it() {
        let cases = [
            (1.0753e6, 0.0121e6, "Pa", "1.075 ± 0.012 MPa"),
            (162.3e-6, 4.8e-6, "m", "162.3 ± 4.8 µm"),
            (0.0021, 0.0003, "pF", "2.10 ± 0.30 fF"),
            (2.341e-10, 0.0, "F", "234.1 pF"),
            (7200.0, 60.0, "s", "120.0 ± 1.0 min"),
            (-3e-6, 0.245, "m", "0 ± 245 mm"),
            (2.0e-4, 1e-5, "1/K", "200 ± 10 ppm/K"),
            (0.25, 0.012, "1", "0.250 ± 0.012"),
            (0.02, 0.001, "1/h", "2.00 ± 0.10 %/h"),
            (-7.6e3, 1.1e3, "Pa/K", "-7.6 ± 1.1 kPa/K"),
            (239.7, 0.11, "counts", "239.70 ± 0.11 counts"),
        ];
        for (value, sd, unit, text) in cases {
            assert_eq!(measured(value, sd, unit), text);
        }
    }

    #[test]
    fn a_value_with_its_error_has_three_digits_and_no_error_finer_than_they_are() {
        assert_eq!(with_sd(252.0, 6.0, "s"), "252 s (sd 6)");
        assert_eq!(with_sd(445.817_71, 0.012, "s"), "446 s (sd < 1)");
        assert_eq!(with_sd(0.0, 0.0, "s"), "0 s");
        assert_eq!(with_sd(2.341, 0.052, "%"), "2.34 % (sd 0.05)");
        assert_eq!(with_sd(7.353, 0.012, "N"), "7.35 N (sd 0.01)");
        assert_eq!(with_sd(94_319.0, 20.0, "s"), "26.2 h (sd < 0.1)");
        assert_eq!(with_sd(138_743.902, 4.379, "%"), "139000 % (sd < 1000)");
        assert_eq!(with_sd(2.3, 15.0, "counts"), "2 counts (sd 15)");
        assert_eq!(with_sd(3e-6, 4e-7, "s"), "3.00 µs (sd 0.40)");
        assert_eq!(with_sd(99.96, 0.3, "s"), "100.0 s (sd 0.3)");
        assert_eq!(with_sd(4.1e8, 2e6, "s"), "13.0 years (sd 0.1)");
        assert_eq!(percent_of(0.000_012), "12 ppm");
    }

    #[test]
    fn an_interval_has_one_unit_and_three_digits_of_its_larger_end() {
        assert_eq!(interval(0.00123, 0.0081, "m"), "1.23 to 8.10 mm");
        assert_eq!(interval(-3e-9, 4.5, "N"), "0.00 to 4.50 N");
        assert_eq!(interval(0.0, 15_300.0, "s"), "0.00 to 4.25 h");
        assert_eq!(interval(5_562.0, 121_000.0, "Pa"), "6 to 121 kPa");
        assert_eq!(interval(20.04, 50.31, "°C"), "20.0 to 50.3 °C");
    }

    #[test]
    fn two_values_that_differ_do_not_read_the_same() {
        assert_eq!(two(1.0753e6, 0.821e6, "Pa"), ("1.08 MPa".into(), "0.821 MPa".into()));
        assert_eq!(two(162.31e-6, 162.34e-6, "m"), ("162.31 µm".into(), "162.34 µm".into()));
        assert_eq!(two(8.54e-4, 8.6e-4, "pF m"), ("854 pF µm".into(), "860 pF µm".into()));
    }

    #[test]
    fn no_probability_reads_as_certain() {
        assert_eq!(percent(1.0), "> 99.9 %");
        assert_eq!(percent(0.0), "< 0.1 %");
        assert_eq!(percent(0.62), "62 %");
    }

    #[test]
    fn what_is_not_a_number_is_a_dash() {
        assert_eq!(significant(f64::NAN, 3), "–");
        assert_eq!(significant(f64::INFINITY, 3), "–");
        assert_eq!(Scale::of("pF", f64::NAN), Scale { factor: 1.0, unit: "pF".into() });
    }
}
