//! What a request would take against what one command may take.
//!
//! Limits: the limit is the same on every machine unless [`VARIABLE`] says otherwise, so that a request is refused everywhere or nowhere.

use std::fmt;

/// Environment variable that sets the memory which one command may take, as `8 GB`.
pub const VARIABLE: &str = "TRUEGAP_MEMORY";

/// Memory that one command may take where [`VARIABLE`] says nothing, bytes.
const DEFAULT: f64 = 4e9;

/// What is asked for, and what it would take.
#[derive(Clone, Copy, Debug)]
pub struct Need<'a> {
    /// where it was asked: a file and key, or a flag
    pub place: &'a str,
    /// what was asked, in words and numbers: `1000000 loads x 1000000 temperatures`
    pub asked: &'a str,
    /// memory that it would take, bytes
    pub bytes: f64,
    /// what to ask for instead
    pub remedy: &'a str,
}

/// Why a request is refused before any work.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
#[allow(missing_docs)] // the fields are named by the messages
pub enum TooLarge {
    /// More memory than one command may take.
    #[error(
        "{place}: {asked} would take about {} of memory, and one command may take {}; {remedy}, or allow more: {VARIABLE}=\"{}\"",
        Bytes(*bytes), Bytes(*limit), Bytes(allowing(*bytes))
    )]
    Memory { place: String, asked: String, bytes: f64, limit: f64, remedy: String },
    /// More than the methods here are made for.
    #[error("{place}: {asked}, and at most {most} can be handled; {remedy}")]
    Count { place: String, asked: String, most: usize, remedy: String },
    /// The variable is no size.
    #[error(
        "{VARIABLE}=\"{text}\" is no amount of memory; write a number and a unit, as in {VARIABLE}=\"8 GB\", or leave it unset for {}",
        Bytes(DEFAULT)
    )]
    Setting { text: String },
}

/// Refuses what would take more memory than one command may.
///
/// # Errors
/// [`TooLarge::Memory`], or [`TooLarge::Setting`] where the variable is no size.
pub fn check(need: Need<'_>) -> Result<(), TooLarge> {
    within(need, memory_limit()?)
}

fn within(need: Need<'_>, limit: f64) -> Result<(), TooLarge> {
    if need.bytes <= limit {
        return Ok(());
    }
    let Need { place, asked, bytes, remedy } = need;
    Err(TooLarge::Memory { place: place.into(), asked: asked.into(), bytes, limit, remedy: remedy.into() })
}

/// Refuses more than `most` of something whose work grows faster than its number; `things` are what is counted.
///
/// # Errors
/// [`TooLarge::Count`].
pub fn count(place: &str, found: usize, things: &str, most: usize, remedy: &str) -> Result<(), TooLarge> {
    if found <= most {
        return Ok(());
    }
    Err(TooLarge::Count { place: place.into(), asked: format!("{found} {things}"), most, remedy: remedy.into() })
}

/// Memory that one command may take, bytes.
///
/// # Errors
/// [`TooLarge::Setting`] where the variable is set to what is no size.
pub fn memory_limit() -> Result<f64, TooLarge> {
    match std::env::var_os(VARIABLE).filter(|text| !text.is_empty()) {
        None => Ok(DEFAULT),
        Some(text) => {
            let text = text.to_string_lossy();
            bytes(&text).ok_or_else(|| TooLarge::Setting { text: text.escape_debug().to_string() })
        }
    }
}

/// Bytes of a text such as `8 GB`.
fn bytes(text: &str) -> Option<f64> {
    let text = text.trim();
    let end = text.find(|c: char| c.is_ascii_alphabetic() && !matches!(c, 'e' | 'E')).unwrap_or(text.len());
    let (number, unit) = (text[..end].trim(), text[end..].trim());
    let (_, factor) = UNITS.iter().find(|(name, _)| name.eq_ignore_ascii_case(unit))?;
    number.parse::<f64>().ok().filter(|v| v.is_finite() && *v > 0.0).map(|v| v * factor)
}

const UNITS: [(&str, f64); 5] = [("TB", 1e12), ("GB", 1e9), ("MB", 1e6), ("kB", 1e3), ("B", 1.0)];

/// A round number that is enough for `bytes`.
fn allowing(bytes: f64) -> f64 {
    let step = 10f64.powf(bytes.max(1.0).log10().floor());
    (bytes / step).ceil() * step
}

/// Bytes as a person reads them.
struct Bytes(f64);

impl fmt::Display for Bytes {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (unit, factor) = UNITS.into_iter().find(|(_, factor)| self.0 >= *factor).unwrap_or(("B", 1.0));
        let value = self.0 / factor;
        if value >= 1e4 { write!(f, "{value:.0e} {unit}") } else { write!(f, "{} {unit}", two_digits(value)) }
    }
}

fn two_digits(value: f64) -> f64 {
    let step = 10f64.powi((value.log10().floor() as i32 - 1).max(-1));
    (value / step).round() * step
}

#[cfg(test)]
mod tests {
    use super::*;

    fn need(bytes: f64) -> Need<'static> {
        Need { place: "--load", asked: "1000000 loads", bytes, remedy: "ask for fewer" }
    }

    #[test]
    fn what_is_too_large_is_told_with_place_size_limit_and_remedy() {
        assert_eq!(within(need(3.9e9), 4e9), Ok(()));
        let told = within(need(2.5e11), 4e9).unwrap_err().to_string();
        for part in ["--load: 1000000 loads", "250 GB", "4 GB", "ask for fewer", "TRUEGAP_MEMORY=\"300 GB\""] {
            assert!(told.contains(part), "{part}: {told}");
        }
        let told = within(need(f64::INFINITY), 4e9).unwrap_err().to_string();
        assert!(told.contains("inf"), "{told}");
        assert!(within(need(f64::NAN), 4e9).is_err(), "what cannot be estimated is not small");
    }

    #[test]
    fn a_size_is_a_number_and_a_unit() {
        for (text, size) in [("8 GB", 8e9), ("500MB", 5e8), ("1e3 kb", 1e6), (" 2 TB ", 2e12)] {
            assert_eq!(bytes(text), Some(size), "{text}");
        }
        for text in ["8", "GB", "-1 GB", "inf GB", "8 GiB", "eight GB", ""] {
            assert_eq!(bytes(text), None, "{text}");
        }
    }

    #[test]
    fn what_is_advised_is_enough_and_can_be_read_back() {
        for size in [1.0, 4.1e9, 9.99e9, 2.5e11, 7.3e15, 1e17] {
            let advised = allowing(size);
            assert!(advised >= size && advised < 2.0 * size, "{size}: {advised}");
            assert_eq!(bytes(&Bytes(advised).to_string()), Some(advised), "{}", Bytes(advised));
        }
    }

    #[test]
    fn a_count_is_told_with_its_limit() {
        assert_eq!(count("c.toml", 20, "corners", 20, "draw fewer"), Ok(()));
        let told = count("c.toml", 21, "corners", 20, "draw fewer").unwrap_err().to_string();
        assert_eq!(told, "c.toml: 21 corners, and at most 20 can be handled; draw fewer");
    }
}
