//! Readings that follow late in other ways than with one time constant, and laws that no straight step leads to.
//!
//! Each recording is made by closed forms from row to row, with noise of 0.01 V a row.

use crate::given::{Given, noisy, said, said_by};
use truegap_core::{Driver, Inputs, Simulator};
use truegap_diagnose::{Diagnosis, Verdict};

const ROWS: usize = 1500;

/// A simulation that steps every minute between 3 and 4 V, in an order without a pattern.
fn stepped() -> Inputs {
    let level = |step: usize| 3.0 + ((step * step * 37 + 11 * step) % 101) as f64 / 100.0;
    Inputs { simulated: Some((0..ROWS).map(|row| level(row / 60)).collect()), ..clocked() }
}

fn clocked() -> Inputs {
    Inputs { time_s: Some((0..ROWS).map(|row| row as f64).collect()), run: vec![1; ROWS], ..Inputs::default() }
}

/// A first-order lag of a column that is straight from row to row, 1 s each: the exact step, written out.
fn lagged(x: &[f64], tau: f64) -> Vec<f64> {
    let decay = (-1.0 / tau).exp();
    let mut y = x[0];
    let late = x.windows(2).map(|pair| {
        let slope = pair[1] - pair[0];
        // y = x - slope tau + (y0 - x0 + slope tau) exp(-t / tau)
        y = pair[1] - slope * tau + (y - pair[0] + slope * tau) * decay;
        y
    });
    std::iter::once(x[0]).chain(late).collect()
}

/// A reading that goes from row to row as `step` says, from where the simulation is and where it was itself.
fn following(inputs: &Inputs, step: impl Fn(f64, f64) -> f64) -> Vec<f64> {
    let simulated = inputs.simulated.as_ref().unwrap();
    let mut read = simulated[0];
    let mut go = |x: &f64| {
        read += step(*x, read);
        read
    };
    simulated.iter().map(&mut go).collect()
}

fn names(said: &Diagnosis) -> Vec<&str> {
    said.findings.iter().map(|finding| finding.effect.as_str()).collect()
}

/// Value and deviation of a number of the first finding.
fn number(said: &Diagnosis, name: &str) -> (f64, f64) {
    let number = said.findings[0].parameters.iter().find(|p| p.name == name).unwrap();
    (number.value, number.sd)
}

fn close(said: &Diagnosis, name: &str, truth: f64) {
    let (value, sd) = number(said, name);
    assert!((value - truth).abs() < 4.0 * sd, "{name} {value} (sd {sd}), it is {truth}: {}", said.says);
}

/// Two names were told for it, a lag of the electronics beside a slow response.
#[test]
fn two_stages_one_behind_the_other_are_one_cause() {
    let inputs = stepped();
    let truth = lagged(&lagged(inputs.simulated.as_ref().unwrap(), 7.0), 12.0);
    let said = said(&Given::fixed(), &inputs, &noisy(31, |row| truth[row], ROWS));
    assert_eq!((said.verdict, names(&said)), (Verdict::Explained, vec!["slow_response"]), "{}", said.says);
    assert!(said.findings[0].says.contains("behind a first stage of"), "{}", said.findings[0].says);
    // which of the two comes first is not seen
    let ((tau, sd), (ratio, _)) = (number(&said, "tau"), number(&said, "first_stage"));
    assert!((tau + ratio * tau - 19.0).abs() < 4.0 * sd, "{tau} and {}", ratio * tau);
    assert!(said.fit.in_sample.rmse_after < 0.0105, "{}", said.fit.in_sample.rmse_after);
}

/// A valve that opens right behind a row, and a meter with a time constant of 7 s: straight lines between rows leave 0.03 V, and a mechanism in words stood beside the lag.
#[test]
fn what_changes_right_behind_a_row_is_held_and_no_second_cause() {
    // a new level every quarter of a minute, up to 3 V away
    let level = |step: usize| 3.0 + 3.0 * ((step * step * 37 + 11 * step) % 101) as f64 / 100.0;
    let inputs = Inputs { simulated: Some((0..ROWS).map(|row| level(row / 15)).collect()), ..clocked() };
    let truth = following(&inputs, |x, y| (x - y) * -(-1.0f64 / 7.0).exp_m1());
    // a slow response has a share that comes at once, which does the same
    let effects = ["readout_lag", "time_offset", "clock_rate", "friction", "nonlinearity"];
    let said = said_by(&effects, &Given::fixed(), &inputs, &noisy(46, |row| truth[row], ROWS));
    assert_eq!((said.verdict, names(&said)), (Verdict::Explained, vec!["readout_lag"]), "{}", said.says);
    assert!(said.carried.is_empty(), "{}", said.says);
    [("tau", 7.0), ("between_rows", 1.0)].into_iter().for_each(|(name, truth)| close(&said, name, truth));
    assert!(
        said.findings[0].says.contains("between two rows the true value is already that of the later row"),
        "{}",
        said.findings[0].says
    );
    assert!(said.fit.in_sample.rmse_after < 0.0105, "{}", said.fit.in_sample.rmse_after);
}

/// A chemical sensor that takes 8 s for more and 25 s for less: it was told as one time constant, which leaves more than the noise.
#[test]
fn a_reading_that_recovers_slowly_has_two_time_constants() {
    let inputs = stepped();
    let truth = following(&inputs, |x, y| (x - y) * -(-1.0 / if x > y { 8.0f64 } else { 25.0 }).exp_m1());
    let said = said(&Given::fixed(), &inputs, &noisy(32, |row| truth[row], ROWS));
    assert_eq!((said.verdict, names(&said)), (Verdict::Explained, vec!["slow_response"]), "{}", said.says);
    close(&said, "recovery", (25.0f64 / 8.0).ln());
    assert!(said.findings[0].says.contains("where the reading rises"), "{}", said.findings[0].says);
}

/// A pen that goes 0.02 V a second at most.
#[test]
fn a_reading_with_a_limit_of_its_rate_is_named() {
    let inputs = stepped();
    let truth = following(&inputs, |x, y| (x - y).clamp(-0.02, 0.02));
    let said = said(&Given::fixed(), &inputs, &noisy(33, |row| truth[row], ROWS));
    assert_eq!((said.verdict, names(&said)), (Verdict::Explained, vec!["rate_limit"]), "{}", said.says);
    close(&said, "slowness", 50.0);
}

/// A simulation 3 % too small: it was told as a bent characteristic, and nothing else was offered.
#[test]
fn a_scale_that_is_off_is_named_as_such() {
    let inputs = stepped();
    let simulated = inputs.simulated.clone().unwrap();
    let said = said(&Given::fixed(), &inputs, &noisy(34, |row| 1.03 * simulated[row], ROWS));
    assert_eq!((said.verdict, names(&said)), (Verdict::Explained, vec!["gain_error"]), "{}", said.says);
    close(&said, "error", 0.03);
}

/// Dirt on a window: less is lost of what is left, and rain at two thirds takes a tenth of it. It was told in words.
#[test]
fn a_window_that_collects_dirt_is_a_gain_that_ages() {
    let inputs = stepped();
    let simulated = inputs.simulated.clone().unwrap();
    let washed = |row: usize| if row > 2 * ROWS / 3 { 0.9 } else { 1.0 };
    let dirt = |row: usize| 0.2 * washed(row) * (1.0 - 1.0 / (1.0 + 2.0 * row as f64 / ROWS as f64));
    let said = said(&Given::fixed(), &inputs, &noisy(40, |row| (1.0 - dirt(row)) * simulated[row], ROWS));
    assert_eq!(names(&said)[0], "gain_ageing", "{}", said.says);
    assert!(said.findings[0].says.contains("falls by 1"), "{}", said.findings[0].says);
}

/// A crystal whose turning point lies at the reference: its coefficient there is nothing, and nothing was found. Two swings of the temperature: of a single sine the square of the rate is as good, a level apart.
#[test]
fn a_parabola_about_the_reference_is_a_temperature_coefficient() {
    let base = Given::with_level();
    let swing = |row: usize| 6.0 * (row as f64 / 160.0).sin() + 3.0 * (row as f64 / 57.0).cos();
    let warm: Vec<f64> = (0..ROWS).map(|row| base.reference_c() + swing(row)).collect();
    let inputs = Inputs { temperature_c: Some(warm.clone()), ..clocked() };
    let read = noisy(35, |row| 3.0 + 0.002 * (warm[row] - base.reference_c()).powi(2), ROWS);
    let said = said(&base, &inputs, &read);
    assert_eq!(names(&said), ["temperature_coefficient"], "{}", said.says);
    assert!(said.fit.in_sample.rmse_after < 0.0105, "{}", said.fit.in_sample.rmse_after);
}

/// A crystal that turns at the reference, or 0.2 K beside it, under one swing of the temperature: a bend of at most a few times the usual kept a slope that is not there, and half of the parabola.
#[test]
fn a_parabola_that_turns_beside_the_reference_is_told_with_its_turn() {
    let base = Given::with_level();
    for turn in [0.0, 0.2, -3.0] {
        let above: Vec<f64> = (0..ROWS).map(|row| 1.0 + 9.0 * (row as f64 / 160.0).sin()).collect();
        let warm = above.iter().map(|x| base.reference_c() + x).collect();
        let inputs = Inputs { temperature_c: Some(warm), ..clocked() };
        let read = noisy(45, |row| 3.0 - 0.02 * (above[row] - turn).powi(2), ROWS);
        let said = said_by(&["temperature_coefficient"], &base, &inputs, &read);
        assert_eq!((said.verdict, names(&said)), (Verdict::Explained, vec!["temperature_coefficient"]), "{}", said.says);
        let [(slope, _), (bend, _)] = ["per_kelvin", "bend"].map(|name| number(&said, name));
        approx::assert_relative_eq!(0.5 * slope * bend, -0.02, max_relative = 0.01);
        approx::assert_abs_diff_eq!(-bend.recip(), turn, epsilon = 0.02);
        assert!(said.findings[0].says.contains("along a parabola"), "{}", said.findings[0].says);
    }
}

/// The element whose gain goes with temperature is a minute behind the thermometer: the gain followed the thermometer itself, and no model held both.
#[test]
fn beside_no_plates_the_gain_follows_what_is_behind_the_thermal_path() {
    let warm: Vec<f64> = (0..ROWS).map(|row| 20.0 + 8.0 * (row as f64 / 80.0).sin()).collect();
    let inputs = Inputs { temperature_c: Some(warm.clone()), ..stepped() };
    let (late, base) = (lagged(&warm, 60.0), Given::fixed());
    let simulated = inputs.simulated.clone().unwrap();
    // the gain acts about 3 V, the zero of this simulation
    let truth = |row: usize| simulated[row] + (simulated[row] - 3.0) * 0.01 * (late[row] - base.reference_c());
    let said = said_by(&["gain_drift", "thermal_lag", "temperature_coefficient"], &base, &inputs, &noisy(36, truth, ROWS));
    assert_eq!(names(&said), ["gain_drift", "thermal_lag"], "{}", said.says);
    close(&said, "per_kelvin", 0.01);
    assert!(said.fit.in_sample.rmse_after < 0.0105, "{}", said.fit.in_sample.rmse_after);
}

/// Humidity that is recorded as such was told in words at best, since no effect of the library followed it beside a base model without plates.
#[test]
fn a_recorded_humidity_is_a_driver() {
    let humid: Vec<f64> = (0..ROWS).map(|row| 45.0 + 15.0 * (row as f64 / 120.0).sin()).collect();
    let inputs = Inputs { humidity_pct: Some(humid.clone()), ..stepped() };
    let simulated = inputs.simulated.clone().unwrap();
    let read = noisy(37, |row| simulated[row] + 0.002 * humid[row], ROWS);
    let said = said_by(&["driver_coefficient", "late_driver", "offset_drift", "friction"], &Given::fixed(), &inputs, &read);
    assert_eq!(names(&said), ["driver_coefficient"], "{}", said.says);
    close(&said, "per_unit", 0.002);
    assert!(said.findings[0].says.contains("humidity"), "{}", said.findings[0].says);
}

/// A voltage that falls with the charge that was drawn. A drift was named of which nothing is seen beside the mechanism, and the mechanism was carried.
#[test]
fn a_name_of_which_nothing_is_seen_beside_a_mechanism_is_dropped() {
    let current = |row: usize| ((row / 45 * 29 + 7) % 13) as f64 / 2.0 - 1.0;
    let inputs = Inputs {
        drivers: vec![Driver { name: "current".into(), unit: "A".into(), values: (0..ROWS).map(current).collect() }],
        ..clocked()
    };
    let mut charge = 0.0;
    let drawn: Vec<f64> = (0..ROWS)
        .map(|row| {
            charge += current(row);
            charge
        })
        .collect();
    let base = Given { follows_driver: true, ..Given::with_level() };
    let said = said(&base, &inputs, &noisy(38, |row| 3.0 + current(row) - 1e-4 * drawn[row], ROWS));
    assert_eq!(names(&said), ["discovered"], "{}", said.says);
    assert!(said.findings[0].says.contains("added up over time"), "{}", said.findings[0].says);
}

/// A gain that is right at 25 degC and readings of both signs: it was told with a zero that moves and a scale that is off, which are the gain seen from another zero and another temperature.
#[test]
fn a_gain_that_moves_is_one_cause_whatever_it_is_counted_from() {
    let base = Given { zero: -0.5, ..Given::fixed() };
    let inputs = stepped();
    let simulated: Vec<f64> = inputs.simulated.as_ref().unwrap().iter().map(|level| level - 3.5).collect();
    let warm: Vec<f64> = (0..ROWS).map(|row| 22.0 + 8.0 * (row as f64 / 80.0).sin()).collect();
    let inputs = Inputs { temperature_c: Some(warm.clone()), simulated: Some(simulated.clone()), ..inputs };
    let truth = |row: usize| simulated[row] * (1.0 + 0.02 * (warm[row] - 25.0));
    let effects = ["gain_drift", "gain_error", "temperature_coefficient", "offset_drift"];
    let said = said_by(&effects, &base, &inputs, &noisy(39, truth, ROWS));
    assert_eq!(names(&said), ["gain_drift"], "{}", said.says);
    close(&said, "per_kelvin", 0.02);
    close(&said, "neutral", 25.0 - base.reference_c());
}

/// A motor whose speed was logged and whose base model is its inertia: dry and viscous friction were told as a loop, or in words.
#[test]
fn friction_follows_a_speed_that_was_recorded() {
    let speed: Vec<f64> = (0..ROWS).map(|row| 8.0 * (row as f64 / 37.0).sin() + 3.0 * (row as f64 / 11.0).cos()).collect();
    let driver = Driver { name: "speed".into(), unit: "rad/s".into(), values: speed.clone() };
    let inputs = Inputs { drivers: vec![driver], ..stepped() };
    let simulated = inputs.simulated.clone().unwrap();
    let truth = |row: usize| simulated[row] + 0.1 * (speed[row] / 0.5).tanh() + 0.005 * speed[row];
    let effects = ["friction", "saturating_loop", "driver_coefficient", "nonlinearity", "late_driver"];
    let said = said_by(&effects, &Given::fixed(), &inputs, &noisy(40, truth, ROWS));
    assert_eq!((said.verdict, names(&said)), (Verdict::Explained, vec!["friction"]), "{}", said.says);
    let fastest = speed.iter().fold(0.0f64, |most, speed| most.max(speed.abs()));
    [("force", 0.1), ("viscous", 0.05 * fastest)].into_iter().for_each(|(name, truth)| close(&said, name, truth));
    assert!(said.findings[0].says.contains("whose speed is speed"), "{}", said.findings[0].says);
}

/// A cell whose voltage rises with the charge that has gone in, 0.12 V/Ah: a late influence with a time constant as long as the recording, beside a drift, stood for the current added up.
#[test]
fn a_charge_is_no_late_influence_of_the_current() {
    let rows = 900;
    let current: Vec<f64> =
        (0..rows).map(|row| [0.6, -1.4, 2.6, 1.1, -0.5, 2.1, -1.9, 1.7][(row / 31 * 5 + row / 93) % 8]).collect();
    let mut charge = 0.0;
    let volts: Vec<f64> = current
        .iter()
        .map(|i| {
            charge += i * 10.0 / 3600.0;
            3.0 + charge
        })
        .collect();
    let inputs = Inputs {
        time_s: Some((0..rows).map(|row| 10.0 * row as f64).collect()),
        run: vec![1; rows],
        drivers: vec![Driver { name: "current".into(), unit: "A".into(), values: current }],
        ..Inputs::default()
    };
    let said = said(&Given::with_level(), &inputs, &noisy(34, |row| volts[row], rows));
    assert!(said.findings.iter().all(|f| f.effect != "late_driver"), "{}", said.says);
}
