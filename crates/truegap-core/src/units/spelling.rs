//! Units as people spell them: `sec`, `Newton`, `deg C`, `°C`, `µs`, `g` of a load cell.
//!
//! Limits: text to text, whatever is measured; English and German words, and French ones where they differ.

use std::borrow::Cow;

/// A unit of this program, and other spellings of it: words in small letters, symbols as they are written.
const SPELLINGS: &[(&str, &[&str])] = &[
    ("s", &["sec", "secs", "second", "seconds", "sekunde", "sekunden", "seconde", "secondes"]),
    ("ms", &["msec", "msecs", "millisec", "millisecond", "milliseconds", "millisekunde", "millisekunden"]),
    ("us", &["usec", "usecs", "microsec", "microsecond", "microseconds", "mikrosekunden"]),
    ("min", &["mins", "minute", "minutes", "minuten"]),
    ("h", &["hr", "hrs", "hour", "hours", "std", "stunde", "stunden", "heure", "heures"]),
    ("d", &["day", "days", "tag", "tage", "jour", "jours"]),
    ("N", &["newton", "newtons"]),
    ("mN", &["millinewton", "millinewtons"]),
    ("kN", &["kilonewton", "kilonewtons"]),
    // what a scale or a load cell calls grams is the force that so much weighs
    ("gf", &["g", "gram", "grams", "gramm", "gramme", "gramforce", "gram-force"]),
    ("kgf", &["kg", "kp", "kilogram", "kilograms", "kilogramm", "kilopond", "kilogram-force"]),
    ("lbf", &["lb", "lbs", "pound", "pounds", "pound-force"]),
    ("Pa", &["pascal", "pascals"]),
    ("hPa", &["hectopascal", "hektopascal"]),
    ("kPa", &["kilopascal", "kilopascals"]),
    ("MPa", &["megapascal", "megapascals"]),
    ("mbar", &["millibar", "millibars"]),
    ("m", &["metre", "meter", "metres", "meters"]),
    ("cm", &["centimetre", "centimeter", "centimetres", "centimeters", "zentimeter"]),
    ("mm", &["millimetre", "millimeter", "millimetres", "millimeters"]),
    ("um", &["micrometre", "micrometer", "micrometres", "micrometers", "mikrometer", "micron", "microns"]),
    ("nm", &["nanometre", "nanometer", "nanometres", "nanometers"]),
    ("in", &["inch", "inches", "zoll"]),
    (
        "degC",
        &["deg c", "deg. c", "c deg", "celsius", "degree celsius", "degrees celsius", "deg celsius", "grad celsius", "grad c"],
    ),
    ("K", &["kelvin", "deg k", "degk"]),
    ("degF", &["deg f", "deg. f", "fahrenheit", "degrees fahrenheit", "degree fahrenheit", "deg fahrenheit"]),
    ("%", &["percent", "per cent", "prozent"]),
    ("%RH", &["% rh", "rh%", "% r.h.", "%r.h.", "% rel", "% rf", "%rf", "% r.f.", "rel. %"]),
    ("V", &["volt", "volts"]),
    ("mV", &["millivolt", "millivolts"]),
    ("uF", &["microfarad", "microfarads", "mikrofarad"]),
    ("nF", &["nanofarad", "nanofarads"]),
    ("pF", &["picofarad", "picofarads", "pikofarad"]),
    ("fF", &["femtofarad", "femtofarads"]),
    ("aF", &["attofarad", "attofarads"]),
];

/// The unit that a text spells, by its name in this program; the text, without signs that ASCII lacks, where it is no known spelling.
pub(super) fn canonical(text: &str) -> Cow<'_, str> {
    let plain = ascii(text.trim());
    let lower = plain.to_lowercase();
    // a symbol has its case: `g` weighs, `G` does not
    let spelt = |spelling: &&str| if spelling.chars().count() > 2 { **spelling == *lower } else { **spelling == *plain };
    match SPELLINGS.iter().find(|(_, spellings)| spellings.iter().any(&spelt)) {
        Some((name, _)) => Cow::Borrowed(name),
        None => plain,
    }
}

/// Signs that ASCII lacks, as this program writes them: `µ` is u, `°` is deg, `℃` is degC.
fn ascii(text: &str) -> Cow<'_, str> {
    if text.is_ascii() {
        return Cow::Borrowed(text);
    }
    let signs = [("µ", "u"), ("μ", "u"), ("℃", "degC"), ("℉", "degF"), ("°", "deg"), ("º", "deg"), ("˚", "deg"), ("\u{a0}", " ")];
    Cow::Owned(signs.into_iter().fold(text.to_owned(), |text, (sign, plain)| text.replace(sign, plain)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn people_spell_units_in_many_ways() {
        let spelt = [
            ("sec", "s"),
            ("Sekunden", "s"),
            ("Newton", "N"),
            ("g", "gf"),
            ("°C", "degC"),
            ("ºC", "degC"),
            ("℃", "degC"),
            ("deg C", "degC"),
            ("° C", "degC"),
            ("Celsius", "degC"),
            ("°F", "degF"),
            ("µs", "us"),
            ("μm", "um"),
            ("% RH", "%RH"),
            ("picofarad", "pF"),
        ];
        for (text, unit) in spelt {
            assert_eq!(canonical(text), unit, "{text}");
        }
    }

    #[test]
    fn what_is_no_spelling_stays_as_it_is() {
        for text in ["N", "kPa", "G", "mV/V", "counts", "PF", "xyz"] {
            assert_eq!(canonical(text), text);
        }
    }

    #[test]
    fn no_spelling_stands_for_two_units() {
        let all: Vec<&str> = SPELLINGS.iter().flat_map(|(_, spellings)| spellings.iter().copied()).collect();
        let twice: Vec<&&str> = all.iter().filter(|s| all.iter().filter(|other| other == s).count() > 1).collect();
        assert!(twice.is_empty(), "{twice:?}");
        let small = |s: &&&str| s.chars().count() > 2 && s.to_lowercase() != ***s;
        assert!(all.iter().find(small).is_none(), "words are compared in small letters");
    }
}
