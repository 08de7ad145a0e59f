//! Laws that are found beside such a base model, with their numbers and words.

use crate::given::{Given, noisy, said, said_by, simulated};
use truegap_core::{Driver, EffectId, Inputs, Parameter};
use truegap_diagnose::mechanism::{self, Action, Composed, Form, Kinetics, Numbers, Quantity, Sentence};
use truegap_diagnose::{Context, Effect, FittedParameter, Verdict, library};

/// 0.3 V in half an hour: 30 times the noise of a row.
#[test]
fn a_drift_is_found_beside_a_simulation_without_a_free_number() {
    let inputs = simulated();
    let truth = inputs.simulated.clone().unwrap();
    let said = said(&Given::fixed(), &inputs, &noisy(2, |row| truth[row] + 0.3 * row as f64 / 1800.0, truth.len()));
    let named: Vec<&str> = said.findings.iter().map(|f| f.effect.as_str()).collect();
    assert!(named.contains(&"offset_drift") || said.ambiguity.iter().flatten().any(|id| id == "offset_drift"), "{}", said.says);
    assert!(said.fit.in_sample.rmse_after < 0.012, "{}", said.fit.in_sample.rmse_after);
}

/// What is simulated hardly moves, far from 0, and the zero drifts by 25 times as much: a gain that goes with the clock does the same there, and was likelier since that much drift was all but excluded beforehand.
#[test]
fn a_drift_many_times_what_moves_is_no_gain() {
    let truth: Vec<f64> = (0..1200).map(|row| 8.0 + 0.02 * (f64::from(row) / 70.0).sin()).collect();
    let inputs = Inputs {
        time_s: Some((0..1200).map(f64::from).collect()),
        run: vec![1; 1200],
        simulated: Some(truth.clone()),
        ..Inputs::default()
    };
    let said = said(&Given::fixed(), &inputs, &noisy(5, |row| truth[row] + row as f64 / 1200.0, 1200));
    let named: Vec<&str> = said.findings.iter().map(|f| f.effect.as_str()).collect();
    assert_eq!(named, ["offset_drift"], "{}", said.says);
}

/// A zero that rises by 0.2 V an hour and goes back as fast in the end, or rises on: that its speed changes for good is held at nothing for the one that does not turn, and opened for the other.
#[test]
fn a_drift_turns_where_rows_left_out_bear_it_out() {
    let inputs = simulated();
    let truth = inputs.simulated.clone().unwrap();
    for (per_square_hour, held) in [(0.0, true), (-0.8, false)] {
        let zero = |hours: f64| 0.2 * hours + 0.5 * per_square_hour * hours * hours;
        let read = noisy(17, |row| truth[row] + zero(row as f64 / 3600.0), truth.len());
        let said = said_by(&["offset_drift"], &Given::fixed(), &inputs, &read);
        assert_eq!(said.findings.len(), 1, "{}", said.says);
        let turning = said.findings[0].parameters.iter().find(|p| p.name == "turning").unwrap();
        assert_eq!(turning.meaning.contains("held at 0"), held, "{}", turning.meaning);
        assert!((turning.value - per_square_hour).abs() < 4.0 * turning.sd + 1e-12, "{}", said.says);
    }
}

/// A thermometer that its current heats, less in a quick stream: a gain that leaves alone a reading 1.8 spans above what was read stood for it.
#[test]
fn what_a_current_heats_is_no_gain_about_a_reading_far_away() {
    let rows = 480;
    let held = |row: usize, by: usize, of: &[f64]| of[(row / by * 7 + row / by / 3) % of.len()];
    let current: Vec<f64> = (0..rows).map(|row| held(row, 10, &[0.5, 3.0, 1.0, 5.0, 2.0])).collect();
    let stream: Vec<f64> = (0..rows).map(|row| held(row, 40, &[0.3, 1.6, 0.8, 1.1, 0.5, 2.0])).collect();
    let bath: Vec<f64> = (0..rows).map(|row| 20.0 + 5.0 * (row as f64 / 100.0).sin()).collect();
    let heated = |row: usize| bath[row] + 0.22 * current[row].powi(2) / (1.0 + 1.5 * stream[row].sqrt());
    let driver = |name: &str, unit: &str, values: &[f64]| Driver { name: name.into(), unit: unit.into(), values: values.into() };
    let inputs = Inputs {
        time_s: Some((0..rows).map(|row| 5.0 * row as f64).collect()),
        run: vec![1; rows],
        drivers: vec![driver("current", "mA", &current), driver("flow", "m/s", &stream)],
        simulated: Some(bath.clone()),
        ..Inputs::default()
    };
    let said = said(&Given::with_level(), &inputs, &noisy(33, heated, rows));
    let first = said.findings.first().map(|f| f.effect.as_str());
    assert!(matches!(first, Some("driver_coefficient" | "late_driver" | "discovered")), "{}", said.says);
}

/// An instrument that settles soon after it was switched on. With a fading of one over the recording as usual, a time constant of an eighth of a recording lay eight standard deviations away, and
/// something was said to be switched instead.
#[test]
fn a_drift_may_settle_within_an_eighth_of_a_recording() {
    let inputs = Inputs { time_s: Some((0..=3600).map(f64::from).collect()), run: vec![1; 3601], ..Inputs::default() };
    let base = Given::with_level();
    let context = Context::new(&inputs, &base, 0.3, 0.01);
    let library = library();
    let drift = library.iter().find(|effect| effect.id() == EffectId("offset_drift")).unwrap();
    let parameters = drift.parameters(&context);
    let fading = parameters.iter().find(|p| p.name == "fading").unwrap();
    // a recording of an hour: 8 an hour is a time constant of seven and a half minutes
    let (low, high) = fading.bounds;
    assert!(low < 0.0 && high > 8.0 && 8.0 < 2.0 * fading.sd(), "{low} to {high}, sd {}", fading.sd());
}

/// A drift or a wave of 25 times its usual size, and a reading that relaxes to a fifth, are unusual and no more: under a Gaussian they lay 25 and 40 deviations away.
#[test]
fn sizes_may_be_many_times_the_usual_ones() {
    let rows = 2000;
    let simulated = (0..rows).map(|row| 3.0 + 0.5 * (row as f64 / 30.0).sin()).collect();
    let time_s = (0..rows).map(|row| 600.0 * row as f64).collect();
    let inputs = Inputs { time_s: Some(time_s), run: vec![1; rows], simulated: Some(simulated), ..Inputs::default() };
    let base = Given::fixed();
    let context = Context::new(&inputs, &base, 1.0, 0.01);
    let library = library();
    for (id, times) in [("offset_drift", 25.0), ("daily_cycle", 25.0), ("stress_relaxation", 40.0)] {
        let effect = library.iter().find(|effect| effect.id() == EffectId(id)).unwrap();
        let size = effect.parameters(&context).swap_remove(0);
        let far = size.prior.z(times * size.sd());
        assert!(far > 3.0 && far < 5.5, "{id}: {} {far}", size.name);
    }
}

/// A fan that is switched every 200 s cools the reading by 0.2 V, with a time constant of 30 s.
#[test]
fn a_driver_that_acts_late_is_named_with_its_time_constant() {
    let on = |row: usize| if row / 200 % 2 == 1 { 1.0 } else { 0.0 };
    let inputs = Inputs {
        time_s: Some((0..1800).map(f64::from).collect()),
        run: vec![1; 1800],
        drivers: vec![Driver { name: "fan".into(), unit: "1".into(), values: (0..1800).map(on).collect() }],
        ..Inputs::default()
    };
    let mut late = 0.0;
    // a first-order lag of a step between two rows, in closed form from row to row
    let truth: Vec<f64> = (0..1800)
        .map(|row| {
            late += (on(row) - late) * (1.0 - (-1.0f64 / 30.0).exp());
            3.0 - 0.2 * late
        })
        .collect();
    let said = said(&Given::with_level(), &inputs, &noisy(6, |row| truth[row], 1800));
    let named: Vec<&str> = said.findings.iter().map(|f| f.effect.as_str()).collect();
    assert_eq!(named, ["late_driver"], "{}", said.says);
    let number = |name: &str| said.findings[0].parameters.iter().find(|p| p.name == name).unwrap();
    let (size, tau) = (number("per_unit"), number("tau"));
    // the effect takes the driver as straight between rows, the truth as held: half a row
    assert!((size.value + 0.2).abs() < 4.0 * size.sd && (tau.value - 30.0).abs() < 4.0 * tau.sd.hypot(0.5), "{}", said.says);
}

/// A zero that goes with a temperature, at once. The thermometer has noise of its own, which a lag of half a row smooths: that is no cause.
#[test]
fn a_lag_of_which_nothing_is_seen_is_a_plain_influence() {
    let rows = 700;
    let warm = |row: usize| 25.0 + 6.0 * (row as f64 / 160.0).sin();
    let inputs = Inputs {
        time_s: Some((0..rows).map(|row| 30.0 * row as f64).collect()),
        run: vec![1; rows],
        drivers: vec![Driver {
            name: "temp".into(),
            unit: "degC".into(),
            values: noisy(8, warm, rows).iter().map(|t| (10.0 * t).round() / 10.0).collect(),
        }],
        ..Inputs::default()
    };
    let said = said(&Given::with_level(), &inputs, &noisy(9, |row| 3.0 + 0.05 * (warm(row) - 25.0), rows));
    let named: Vec<&str> = said.findings.iter().map(|f| f.effect.as_str()).collect();
    assert_eq!(named, ["driver_coefficient"], "{}", said.says);
    assert!(!said.ambiguity.iter().flatten().any(|id| id == "late_driver"), "{}", said.says);
}

#[test]
fn a_threshold_of_the_reading_is_counted_from_its_least_and_so_is_what_it_makes() {
    let base = Given::with_level();
    let simulated: Vec<f64> = (0..100).map(|row| 5.0 + 0.04 * f64::from(row)).collect();
    let inputs = Inputs { simulated: Some(simulated), run: vec![1; 100], ..Inputs::default() };
    let context = Context::new(&inputs, &base, 4.0, 0.01);
    let sentence = Sentence {
        quantity: Quantity::Reading,
        action: Action::Adds,
        driver: mechanism::Driver::Reading,
        kinetics: Kinetics::Static,
        form: Form::Threshold,
        even: false,
        below: false,
        passing: false,
        sum: None,
    };
    let start = Numbers { threshold: 1.0, ..Numbers::default() };
    let found = Composed::found(EffectId("composed"), sentence, start, 1.0, &context);
    let fitted: Vec<FittedParameter> = found.parameters(&context).into_iter().zip([0.5, 1.0]).map(at).collect();
    let told = found.told(&fitted, &context, &[]);
    // the reading rises by 3.96 V above its least; 2.96 V of it lie above the threshold, and half of that is added
    assert!(told.contains("1.00 V (sd 0.10) above its least"), "{told}");
    assert!(told.contains("1.48 V"), "{told}");
}

fn at((parameter, value): (Parameter, f64)) -> FittedParameter {
    FittedParameter { parameter, value, sd: 0.1, sd_of_fit: 0.1, at_limit: false }
}

/// A thermometer in the sun and one in the shade of a wall: most of what the first shows comes to the second at once, an eighth with a time constant of two hours.
#[test]
fn a_part_that_comes_at_once_and_a_slow_rest_are_a_thermal_lag() {
    let rows = 1500;
    let time: Vec<f64> = (0..rows).map(|row| 900.0 * f64::from(row)).collect();
    let first: Vec<f64> = time.iter().map(|t| 15.0 + 6.0 * (t / 13_751.0).sin() + 3.0 * (t / 71_000.0).sin()).collect();
    let (mut slow, step) = (first[0], (-900.0f64 / 7200.0).exp());
    let truth: Vec<f64> = first
        .iter()
        .map(|now| {
            slow = now + (slow - now) * step;
            0.87 * now + 0.13 * slow
        })
        .collect();
    let inputs = Inputs { time_s: Some(time), run: vec![1; rows as usize], simulated: Some(first), ..Inputs::default() };
    let said = said(&Given { unit: "degC", ..Given::fixed() }, &inputs, &noisy(7, |row| truth[row], rows as usize));
    let named: Vec<&str> = said.findings.iter().map(|f| f.effect.as_str()).collect();
    assert_eq!(named, ["thermal_lag"], "{}", said.says);
    assert!(said.findings[0].parameters.iter().all(|p| !p.at_limit), "{}", said.findings[0].says);
    // nothing rubs in a temperature
    let friction = said.not_testable.iter().find(|effect| effect.effect == "friction").unwrap();
    assert!(friction.says.contains("is a temperature"), "{}", friction.says);
}

/// A rig that was carried in from the cold: the reading follows the thermometer with 90 s, and stands 2 K below it at the first row. At the end the
/// room is still, so that the noise is measured.
#[test]
fn a_recording_may_begin_out_of_equilibrium() {
    let rows = 1900;
    let time: Vec<f64> = (0..rows).map(|row| 2.0 * f64::from(row)).collect();
    let warm: Vec<f64> = time.iter().map(|t| 22.0 + 6.0 * (t.min(3000.0) / 600.0).sin()).collect();
    let (mut behind, step) = (20.0, (-2.0f64 / 90.0).exp());
    let truth: Vec<f64> = warm
        .iter()
        .map(|now| {
            behind = now + (behind - now) * step;
            3.0 + 0.05 * (behind - 22.0)
        })
        .collect();
    let inputs = Inputs { time_s: Some(time), run: vec![1; rows as usize], temperature_c: Some(warm), ..Inputs::default() };
    let said = said(&Given::with_level(), &inputs, &noisy(11, |row| truth[row], rows as usize));
    let mut named: Vec<&str> = said.findings.iter().map(|f| f.effect.as_str()).collect();
    named.sort_unstable();
    assert_eq!((said.verdict, named), (Verdict::Explained, vec!["temperature_coefficient", "thermal_lag"]), "{}", said.says);
    let tau = said.findings.iter().find(|f| f.effect == "thermal_lag").unwrap().parameters[0].clone();
    assert!((tau.value - 90.0).abs() < 3.0 * tau.sd && tau.sd < 20.0, "{} (sd {})", tau.value, tau.sd);
}

/// Water that cools after the kettle was switched off: nothing moves but the clock, and the way down was begun before the first row.
#[test]
fn what_was_switched_off_before_the_first_row_is_on_its_way_down() {
    let rows = 220;
    let inputs = Inputs {
        time_s: Some((0..rows).map(|row| 60.0 * f64::from(row)).collect()),
        run: vec![1; rows as usize],
        ..Inputs::default()
    };
    let model = Given { follows_clock: true, ..Given::with_level() };
    let said =
        said(&model, &inputs, &noisy(8, |row| 3.0 - 0.001 * row as f64 + 4.0 * (-(row as f64) / 30.0).exp(), rows as usize));
    let named: Vec<&str> = said.findings.iter().map(|f| f.effect.as_str()).collect();
    assert!(named == ["slow_response"] || said.ambiguity.iter().flatten().any(|id| id == "slow_response"), "{}", said.says);
}

/// A base model that is driven by a recorded driver, whose rows were stamped by another clock 2.5 rows late.
#[test]
fn the_clock_of_a_driver_is_found_and_named_by_its_driver() {
    let rows = 1200;
    let at = |t: f64| 2.0 * (t / 31.0).sin() + (t / 7.3).sin();
    let driver = Driver { name: "power".into(), unit: "W".into(), values: (0..rows).map(|row| at(f64::from(row))).collect() };
    let inputs = Inputs {
        time_s: Some((0..rows).map(f64::from).collect()),
        run: vec![1; rows as usize],
        drivers: vec![driver],
        ..Inputs::default()
    };
    let model = Given { follows_driver: true, ..Given::with_level() };
    let said = said(&model, &inputs, &noisy(9, |row| 3.0 + at(row as f64 + 2.5), rows as usize));
    let named: Vec<&str> = said.findings.iter().map(|f| f.effect.as_str()).collect();
    assert_eq!(named, ["time_offset"], "{}", said.says);
    assert!(said.findings[0].says.starts_with("power stands "), "{}", said.findings[0].says);
    let late = &said.findings[0].parameters[0];
    assert!((late.value - 2.5).abs() < 3.0 * late.sd && late.sd < 0.1, "{} (sd {})", late.value, late.sd);
}

/// A zero that moves over a fifth of the recording was not switched: where no other law follows it, it is said that this one has run to its limit.
#[test]
fn a_slow_change_of_the_zero_is_no_clean_switch() {
    let rows = 2000;
    let inputs = Inputs {
        time_s: Some((0..rows).map(|row| 60.0 * f64::from(row)).collect()),
        run: vec![1; rows as usize],
        ..Inputs::default()
    };
    let moved = |row: usize| 0.2 * ((row as f64 - 800.0) / 400.0).clamp(0.0, 1.0);
    let said = said(&Given::with_level(), &inputs, &noisy(10, |row| 3.0 + moved(row), rows as usize));
    assert_ne!(said.verdict, Verdict::Explained, "{}", said.says);
    for switch in said.findings.iter().filter(|f| f.effect == "regime_change") {
        assert!(switch.says.contains("ran to the limit of the time that the change takes"), "{}", switch.says);
    }
}

/// Two microphones hear one wandering sound 22 s apart, which is four of its half widths: straight steps from nothing end in the nearest wave.
#[test]
fn a_shift_by_many_waves_is_found() {
    let rows = 1500;
    let at = |time: f64| (0..9).map(|k| (0.21 * (1.0 + 0.17 * f64::from(k)) * time + f64::from(k * k)).sin()).sum::<f64>() / 3.0;
    let inputs = Inputs {
        time_s: Some((0..rows).map(f64::from).collect()),
        run: vec![1; rows as usize],
        simulated: Some((0..rows).map(|row| 3.0 + at(f64::from(row))).collect()),
        ..Inputs::default()
    };
    let said = said(
        &Given { follows_driver: true, ..Given::fixed() },
        &inputs,
        &noisy(27, |row| 3.0 + at(row as f64 + 22.0), rows as usize),
    );
    let named: Vec<&str> = said.findings.iter().map(|f| f.effect.as_str()).collect();
    assert_eq!(named, ["time_offset"], "{}", said.says);
    let late = &said.findings[0].parameters[0];
    assert!((late.value - 22.0).abs() < 0.05, "{}", said.says);
}

/// A carriage that reads with the square of where it stands, to either side: a bend of at most four over the range left a straight part that is not there.
#[test]
fn a_parabola_of_a_driver_about_its_zero_is_an_influence_of_it() {
    let at = |row: usize| 8.0 * (row as f64 / 70.0).sin() + 3.0 * (row as f64 / 23.0).cos();
    let drivers = vec![Driver { name: "position".into(), unit: "mm".into(), values: (0..1800).map(at).collect() }];
    let inputs = Inputs { drivers, ..simulated() };
    let truth = inputs.simulated.clone().unwrap();
    let read = noisy(46, |row| truth[row] + 0.002 * at(row).powi(2), 1800);
    let said = said_by(&["driver_coefficient", "driver_gain"], &Given::with_level(), &inputs, &read);
    let named: Vec<&str> = said.findings.iter().map(|f| f.effect.as_str()).collect();
    assert_eq!((said.verdict, named), (Verdict::Explained, vec!["driver_coefficient"]), "{}", said.says);
    assert!(said.fit.in_sample.rmse_after < 0.0105, "{}", said.fit.in_sample.rmse_after);
}
