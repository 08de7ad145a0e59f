//! `prediction.csv`: every row of the recording with all predictions.
//!
//! Limits: inputs in SI (temperature in degrees Celsius), ten significant digits.

use std::fmt::Write;
use truegap_core::{Recording, Role};
use truegap_diagnose::Traces;

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
    for (row, run) in recording.inputs.run.iter().enumerate() {
        let _ = write!(text, "{run}"); // writing to a String cannot fail
        for (_, column) in &columns {
            text.push(',');
            text.push_str(&cell(column[row]));
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
        Role::Time => "time_s".into(),
        Role::Force => "force_n".into(),
        Role::Pressure => "pressure_pa".into(),
        Role::Gap => "gap_m".into(),
        Role::Temperature => "temperature_c".into(),
        Role::Humidity => "humidity_pct".into(),
        Role::Simulated => format!("simulated_{simulated}"),
        Role::Response => format!("recorded_{suffix}"),
        Role::Run => "run".into(),
        Role::Sensor => "sensor".into(),
    }
}

/// Ten significant digits, the shortest way to write them; empty where there is no number.
fn cell(value: f64) -> String {
    if !value.is_finite() {
        return String::new();
    }
    let rounded: f64 = format!("{value:.9e}").parse().unwrap_or(value);
    rounded.to_string()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_cell_has_ten_digits_and_no_tail() {
        assert_eq!(cell(8_538.000_000_000_001), "8538");
        assert_eq!(cell(0.1 + 0.2), "0.3");
        assert_eq!(cell(f64::NAN), "");
        assert_eq!(cell(234.397), "234.397");
    }

    #[test]
    fn a_unit_becomes_the_end_of_a_name() {
        assert_eq!(suffix("pF"), "pf");
        assert_eq!(suffix("counts"), "counts");
        assert_eq!(suffix("%"), "pct");
        assert_eq!(suffix(""), "1");
    }
}
