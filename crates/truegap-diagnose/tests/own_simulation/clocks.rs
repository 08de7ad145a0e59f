//! Two clocks: rows for which nothing was recorded on the clock of the response, and times that go with the recording.

use crate::given::{Given, noisy, said, said_by};
use truegap_core::{Driver, Inputs};
use truegap_diagnose::{Context, Diagnosis, Effect, Verdict, library};

/// Seconds between two rows.
const STEP: f64 = 0.1;
const ROWS: usize = 2000;

/// What moves, V: three periods, the quickest of nine seconds.
fn moved(t: f64) -> f64 {
    let wave = |size: f64, period: f64| size * (std::f64::consts::TAU * t / period).sin();
    wave(1.5, 37.3) + wave(0.75, 9.1) + wave(1.0, 101.0)
}

fn recorded() -> Inputs {
    let time: Vec<f64> = (0..ROWS).map(|row| STEP * row as f64).collect();
    let values = time.iter().copied().map(moved).collect();
    let drivers = vec![Driver { name: "bench".into(), unit: "V".into(), values }];
    Inputs { time_s: Some(time), run: vec![1; ROWS], drivers, ..Inputs::default() }
}

/// What is said of readings that follow what moves, and the names.
fn of(read: impl Fn(usize) -> f64) -> (Diagnosis, Vec<String>) {
    let model = Given { follows_driver: true, ..Given::with_level() };
    let said = said(&model, &recorded(), &noisy(41, |row| 3.0 + read(row), ROWS));
    let names = said.findings.iter().map(|f| f.effect.clone()).collect();
    (said, names)
}

/// A shift of three seconds, of which the first or the last 30 rows know nothing: what was made up for them was taken for a wrong equation, and for noise.
#[test]
fn rows_that_a_shift_reads_from_beyond_the_ends_tell_nothing() {
    for late_s in [3.0, -3.0] {
        let (said, names) = of(|row| moved(STEP * row as f64 + late_s));
        assert_eq!((said.verdict, names), (Verdict::Explained, vec!["time_offset".to_owned()]), "{}", said.says);
        // the noise of a row is 10 mV, and that of 2000 rows is known to a fiftieth
        let errors = [said.fit.in_sample.rmse_after, said.fit.held_out.rmse_after.unwrap(), said.fit.noise_floor];
        assert!(errors.iter().all(|error| (error / 0.01 - 1.0).abs() < 0.1), "{errors:?}");
        let shift = &said.findings[0].parameters[0];
        assert!(
            (shift.value - late_s).abs() < 4.0 * shift.sd && shift.sd < 0.5 * STEP,
            "{} (sd {}) {:?}",
            shift.value,
            shift.sd,
            said.findings[0].parameters
        );
        assert!(said.noise.says.contains("rows at the ends"), "{}", said.noise.says);
    }
}

/// What an oscilloscope records in microseconds is what a logger records in milliseconds: numbers in seconds, and their limits, go with the recording.
#[test]
fn times_of_effects_are_those_of_the_recording() {
    let faster = |times: f64| {
        let mut inputs = recorded();
        inputs.time_s.iter_mut().flatten().for_each(|t| *t /= times);
        inputs.temperature_c = Some((0..ROWS).map(|row| 20.0 + 5.0 * (row as f64 / 200.0).sin()).collect());
        inputs
    };
    let (slow, fast) = (faster(1e3), faster(1e6));
    let model = Given { follows_driver: true, ..Given::with_level() };
    let [in_slow, in_fast] = [&slow, &fast].map(|inputs| Context::new(inputs, &model, 1.0, 0.01));
    let library = library();
    let testable: Vec<&Box<dyn Effect>> = library.iter().filter(|effect| effect.testable(&in_slow).is_ok()).collect();
    assert!(testable.len() > 10, "{}", testable.len());
    for effect in testable {
        assert!(effect.testable(&in_fast).is_ok());
        for (slow, fast) in effect.parameters(&in_slow).iter().zip(&effect.parameters(&in_fast)) {
            let power = match slow.unit.as_str() {
                // a rate of clocks is a number
                "s/s" => 0,
                unit if unit == "s" || unit.starts_with("s/") => -1,
                unit if unit.ends_with("/s") || unit.ends_with("/h") => 1,
                unit if unit.ends_with("/h^2") => 2,
                _ => 0,
            };
            let name = format!("{} {} ({})", effect.id(), slow.name, slow.unit);
            let expected = |value: f64| value * 1e3_f64.powi(power);
            for (slow, fast) in [(slow.bounds.0, fast.bounds.0), (slow.bounds.1, fast.bounds.1), (slow.sd(), fast.sd())] {
                let same = slow == fast && !slow.is_finite();
                assert!(same || (expected(slow) - fast).abs() <= 1e-9 * fast.abs(), "{name}: {} is {fast}", expected(slow));
            }
        }
    }
}

/// What moves was recorded by another logger, 1.5 s early; the supply by that of the reading. Shifted with what moves, it acted at the wrong times: a lag was named instead.
#[test]
fn a_driver_that_was_recorded_with_the_reading_is_not_late_with_what_moves() {
    let late_s = -1.5;
    let supply = |t: f64| (std::f64::consts::TAU * t / 7.3).sin() + 0.5 * (std::f64::consts::TAU * t / 2.9).cos();
    for (with_the_reading, apart) in [(true, 1.0), (false, 0.0)] {
        let mut inputs = recorded();
        let time = inputs.time_s.clone().unwrap();
        let values = time.iter().map(|t| supply(*t)).collect();
        inputs.drivers.push(Driver { name: "supply".into(), unit: "V".into(), values });
        let acts = |row: usize| supply(time[row] + if with_the_reading { 0.0 } else { late_s });
        let read = noisy(43, |row| 3.0 + moved(time[row] + late_s) + 0.4 * acts(row), ROWS);
        let model = Given { follows_driver: true, ..Given::with_level() };
        let said = said_by(&["time_offset", "second_driver_coefficient", "readout_lag", "slow_response"], &model, &inputs, &read);
        let mut names: Vec<&str> = said.findings.iter().map(|f| f.effect.as_str()).collect();
        names.sort_unstable();
        assert_eq!(
            (said.verdict, names),
            (Verdict::Explained, vec!["second_driver_coefficient", "time_offset"]),
            "{}",
            said.says
        );
        let clock = said.findings.iter().find(|f| f.effect == "time_offset").unwrap();
        for (name, truth) in [("late", late_s), ("apart", apart)] {
            let number = clock.parameters.iter().find(|p| p.name == name).unwrap();
            assert!((number.value - truth).abs() < 4.0 * number.sd + 1e-9, "{name} {} (sd {})", number.value, number.sd);
        }
    }
}

/// A flow that wanders and is switched, read 31 rows later. Half as many rows from there it is like nothing, so that a search from shifts a width apart ended beside it, and a lag was named.
#[test]
fn a_rough_input_is_found_however_late_it_is() {
    let late = 31;
    let flow = rough(ROWS + late);
    let drivers = vec![Driver { name: "bench".into(), unit: "V".into(), values: flow[late..].to_vec() }];
    let inputs =
        Inputs { time_s: Some((0..ROWS).map(|row| row as f64).collect()), run: vec![1; ROWS], drivers, ..Inputs::default() };
    let model = Given { follows_driver: true, ..Given::with_level() };
    let said =
        said_by(&["time_offset", "slow_response", "readout_lag"], &model, &inputs, &noisy(45, |row| 3.0 + flow[row], ROWS));
    let names: Vec<&str> = said.findings.iter().map(|f| f.effect.as_str()).collect();
    assert_eq!((said.verdict, names), (Verdict::Explained, vec!["time_offset"]), "{}", said.says);
    let shift = &said.findings[0].parameters[0];
    assert!((shift.value + 31.0).abs() < 4.0 * shift.sd + 0.01, "{} (sd {})", shift.value, shift.sd);
}

/// What wanders and is switched, V, a value each second.
fn rough(rows: usize) -> Vec<f64> {
    let random = noisy(44, |_| 0.0, rows);
    let mut wander = 0.0;
    let value = |row: usize| {
        wander = 0.98 * wander + 140.0 * random[row];
        20.0 + wander + if (row as f64 / 140.0).sin() > 0.0 { 9.0 } else { 0.0 }
    };
    (0..rows).map(value).collect()
}

/// What is said of a reading beside a column that is recorded each second, with effects that come late or smooth, and a drift.
fn beside(column: Vec<f64>, read: &[f64]) -> Diagnosis {
    let rows = column.len();
    let drivers = vec![Driver { name: "bench".into(), unit: "V".into(), values: column }];
    let inputs =
        Inputs { time_s: Some((0..rows).map(|row| row as f64).collect()), run: vec![1; rows], drivers, ..Inputs::default() };
    let model = Given { follows_driver: true, ..Given::with_level() };
    said_by(&["time_offset", "slow_response", "readout_lag", "friction", "offset_drift"], &model, &inputs, read)
}

/// A logger writes means over six seconds at the end of each. Without a mean in its law a clock that is late was named beside a lag the other way.
#[test]
fn a_mean_that_is_written_at_its_end_is_late_by_half_of_it() {
    let (rows, wide) = (1500, 6);
    let flow = rough(rows + wide);
    // of straight lines between the rows: the trapezoidal rule
    let mean = |end: usize| (0..wide).map(|back| 0.5 * (flow[end - back] + flow[end - back - 1])).sum::<f64>() / wide as f64;
    let said = beside(flow[wide..].to_vec(), &noisy(46, |row| 3.0 + mean(row + wide), rows));
    let names: Vec<&str> = said.findings.iter().map(|f| f.effect.as_str()).collect();
    assert_eq!((said.verdict, names), (Verdict::Explained, vec!["time_offset"]), "{}", said.says);
    for (name, truth) in [("late", -3.0), ("half_width", 3.0)] {
        let number = said.findings[0].parameters.iter().find(|p| p.name == name).unwrap();
        assert!((number.value - truth).abs() < 4.0 * number.sd + 0.01, "{name} {} (sd {})", number.value, number.sd);
    }
    assert!(said.says.contains("time_offset") && said.findings[0].says.contains("to both sides"), "{}", said.findings[0].says);
}

/// A zero that drifts, beside a column with noise of its own. A lag smooths that noise and predicts better; a mean does as much, so that it is carried and not claimed.
#[test]
fn what_only_smooths_a_noisy_column_is_not_claimed_beside_a_cause() {
    let rows = 1500;
    let flow = rough(rows);
    let noise = noisy(47, |_| 0.0, rows);
    let column = flow.iter().zip(&noise).map(|(flow, noise)| flow + 60.0 * noise).collect();
    let said = beside(column, &noisy(48, |row| 3.0 + flow[row] + 2e-3 * row as f64, rows));
    let names: Vec<&str> = said.findings.iter().map(|f| f.effect.as_str()).collect();
    assert_eq!(names, ["offset_drift"], "{}", said.says);
}
