//! `prediction.csv`: every row of the recording with all predictions.
//!
//! Limits: inputs in SI (temperature in degrees Celsius), ten significant digits; of a clock that does not begin at 0, as many more as its range lies below its numbers.

use std::fmt::Write;
use truegap_core::{Recording, Role, ends};
use truegap_diagnose::Traces;

/// Significant digits of a number.
const DIGITS: usize = 10;

/// The CSV, units in the names of the columns.
///
/// Of several recordings, each row says which one it is of, and the clock is that recording's own.
pub(super) fn csv(recording: &Recording, parts: &[Recording], traces: &Traces) -> String {
    let (own, number) = (own_clock(recording, parts), numbers(parts));
    let columns = numbered(&own, &number, traces);
    let mut text = String::from("run");
    columns.iter().for_each(|(name, _)| {
        text.push(',');
        text.push_str(&crate::cells::cell(name));
    });
    text.push('\n');
    let digits: Vec<usize> = columns
        .iter()
        .map(|(name, column)| if name == Role::Time.column_name() { clock_digits(column) } else { DIGITS })
        .collect();
    for (row, run) in recording.inputs.run.iter().enumerate() {
        let _ = write!(text, "{run}"); // writing to a String cannot fail
        for ((_, column), digits) in columns.iter().zip(&digits) {
            text.push(',');
            text.push_str(&cell(column[row], *digits));
        }
        text.push('\n');
    }
    text
}

/// The same columns as numbers, the run first; nothing is rounded.
pub(super) fn table(recording: &Recording, parts: &[Recording], traces: &Traces) -> Vec<(String, Vec<f64>)> {
    let (own, number) = (own_clock(recording, parts), numbers(parts));
    let run = recording.inputs.run.iter().map(|run| f64::from(*run)).collect();
    let rest = numbered(&own, &number, traces).into_iter().map(|(name, column)| (name, column.to_vec()));
    std::iter::once(("run".to_owned(), run)).chain(rest).collect()
}

/// Number of the recording that each row is of; empty where there is one.
fn numbers(parts: &[Recording]) -> Vec<f64> {
    parts.iter().enumerate().flat_map(|(k, part)| vec![k as f64 + 1.0; part.len()]).collect()
}

fn numbered<'a>(own: &'a Recording, number: &'a [f64], traces: &'a Traces) -> Vec<(String, &'a [f64])> {
    let first = (!number.is_empty()).then(|| ("recording".to_owned(), number));
    first.into_iter().chain(columns(own, traces)).collect()
}

fn own_clock(recording: &Recording, parts: &[Recording]) -> Recording {
    let mut own = recording.clone();
    if let (false, Some(time)) = (parts.is_empty(), &mut own.inputs.time_s) {
        let clock = |p: &Recording| p.inputs.time_s.clone().unwrap_or_else(|| (0..p.len()).map(|row| row as f64).collect());
        *time = parts.iter().flat_map(clock).collect();
    }
    own
}

fn columns<'a>(recording: &'a Recording, traces: &'a Traces) -> Vec<(String, &'a [f64])> {
    let simulated = suffix(recording.simulated_unit.as_ref().unwrap_or(&recording.response_unit));
    let suffix = suffix(&recording.response_unit);
    let inputs = recording.quantities().into_iter().filter(|(role, _)| *role != Role::Response);
    let inputs = inputs.map(|(role, column)| (input_name(role, &suffix, &simulated), column));
    let drivers = recording.inputs.drivers.iter().map(|driver| (format!("driver_{}", driver.name), driver.values.as_slice()));
    let inputs = inputs.chain(drivers);
    let predictions: [(&str, &[f64]); 8] = [
        ("recorded", recording.response.as_slice()),
        ("base", &traces.before),
        ("augmented", &traces.after),
        ("noise_sd", &traces.noise_sd),
        ("base_held_out", &traces.held_out_before),
        ("augmented_held_out", &traces.held_out_after),
        ("flexible", &traces.flexible),
        ("flexible_held_out", &traces.held_out_flexible),
    ];
    let whole = predictions.into_iter().filter(|(_, column)| column.len() == recording.len());
    inputs.chain(whole.map(|(name, column)| (format!("{name}_{suffix}"), column))).collect()
}

/// `pf` from `pF`: letters and digits only.
fn suffix(unit: &str) -> String {
    let plain: String = unit.to_lowercase().replace('%', "pct").chars().filter(|c| c.is_ascii_alphanumeric()).collect();
    if plain.is_empty() { "1".into() } else { plain }
}

fn input_name(role: Role, suffix: &str, simulated: &str) -> String {
    match role {
        Role::Simulated => format!("simulated_{simulated}"),
        Role::Response => format!("recorded_{suffix}"),
        other => other.column_name().into(),
    }
}

/// Significant digits of a clock: its steps keep theirs where it counts from long ago, as seconds since 1970 do.
fn clock_digits(time: &[f64]) -> usize {
    let (low, high) = ends(time.iter().copied());
    let above = (low.abs().max(high.abs()) / (high - low)).log10();
    // seventeen tell any two numbers apart
    DIGITS + if above.is_finite() { above.floor().clamp(0.0, 7.0) as usize } else { 0 }
}

/// So many significant digits, the shortest way to write them; empty where there is no number.
fn cell(value: f64, digits: usize) -> String {
    if !value.is_finite() {
        return String::new();
    }
    let rounded: f64 = format!("{value:.*e}", digits - 1).parse().unwrap_or(value);
    rounded.to_string()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_cell_has_ten_digits_and_no_tail() {
        let told = [8_538.000_000_000_001, 0.1 + 0.2, f64::NAN, 234.397].map(|value| cell(value, DIGITS));
        assert_eq!(told, ["8538", "0.3", "", "234.397"]);
    }

    /// Rows half a second apart had one and the same second.
    #[test]
    fn a_clock_since_1970_keeps_its_steps() {
        let time = [1_772_366_350.0, 1_772_366_350.5, 1_772_366_469.25];
        let digits = clock_digits(&time);
        assert_eq!(time.map(|t| cell(t, digits)), ["1772366350", "1772366350.5", "1772366469.25"]);
        assert_eq!([&[0.0, 0.1, 119.5][..], &[5.0], &[]].map(clock_digits), [DIGITS; 3]);
    }

    #[test]
    fn a_unit_becomes_the_end_of_a_name() {
        assert_eq!(suffix("pF"), "pf");
        assert_eq!(suffix("counts"), "counts");
        assert_eq!(suffix("%"), "pct");
        assert_eq!(suffix(""), "1");
    }
}
