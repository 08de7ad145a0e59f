//! A base model without any free number, and recordings with hardly anything beside the response: every step of a diagnosis has an answer.

#![allow(clippy::unwrap_used)]

use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;
use rand_distr::{Distribution, StandardNormal};
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use truegap_core::{
    Driver, EffectId, Inputs, Parameter, Readout, Role, SimulationError, Simulator, Stage, simulator::StageName,
    walk_without_plates,
};
use truegap_diagnose::mechanism::{self, Action, Composed, Form, Kinetics, Numbers, Quantity, Sentence};
use truegap_diagnose::quality::{Rows, repeated};
use truegap_diagnose::{
    Context, Diagnosis, Effect, FittedParameter, Options, Problem, RecordingFacts, Verdict, diagnose, library,
};

/// A reading that is given row by row, or 3 where none is, with a level to calibrate or without.
///
/// One that follows its first driver counts how often it is asked without any.
struct Given {
    parameters: Vec<Parameter>,
    unit: &'static str,
    follows_driver: bool,
    follows_clock: bool,
    asked_without: AtomicUsize,
}

impl Given {
    fn fixed() -> Self {
        Self {
            parameters: Vec::new(),
            unit: "V",
            follows_driver: false,
            follows_clock: false,
            asked_without: AtomicUsize::new(0),
        }
    }

    fn with_level() -> Self {
        Self { parameters: vec![Parameter::normal("level", "V", 3.0, 5.0, "level")], ..Self::fixed() }
    }
}

impl Simulator for Given {
    fn name(&self) -> &str {
        "given"
    }
    fn unit(&self) -> &str {
        self.unit
    }
    fn parameters(&self) -> &[Parameter] {
        &self.parameters
    }
    fn needs(&self) -> &[Role] {
        &[]
    }
    fn lacks(&self, stage: StageName) -> Option<&'static str> {
        let has = matches!(stage, StageName::ThermalPath | StageName::Readout);
        (!has && !(self.follows_driver && stage == StageName::Inputs)).then_some("nothing is known of it")
    }
    fn full_load(&self) -> Option<f64> {
        None
    }
    fn load(&self, _: &Inputs) -> Option<Vec<f64>> {
        None
    }
    fn respond(&self, values: &[f64], inputs: &Inputs, stages: &[&dyn Stage]) -> Result<Vec<f64>, SimulationError> {
        walk_without_plates(self, values, inputs, stages, |drive| {
            let level = values.first().copied().unwrap_or(3.0);
            let mut value = drive.inputs.simulated.clone().unwrap_or_else(|| vec![level; inputs.len()]);
            if let Some(time) = inputs.time_s.as_ref().filter(|_| self.follows_clock) {
                value.iter_mut().zip(time).for_each(|(value, t)| *value -= 0.001 / 60.0 * (t - time[0]));
            }
            if self.follows_driver {
                match drive.inputs.drivers.first() {
                    Some(driver) => value.iter_mut().zip(&driver.values).for_each(|(value, x)| *value += x),
                    None => _ = self.asked_without.fetch_add(1, Ordering::Relaxed),
                }
            }
            Ok((value, Readout { zero: 3.0, span: 1.0 }))
        })
    }
}

fn noisy(seed: u64, truth: impl Fn(usize) -> f64, rows: usize) -> Vec<f64> {
    let random = &mut ChaCha8Rng::seed_from_u64(seed);
    (0..rows).map(|row| truth(row) + 0.01 * Distribution::<f64>::sample(&StandardNormal, random)).collect()
}

fn said(model: &Given, inputs: &Inputs, response: &[f64]) -> Diagnosis {
    let problem = Problem { inputs, response, simulator: model };
    let facts = RecordingFacts { rows: response.len(), runs: inputs.runs().len(), ..RecordingFacts::default() };
    diagnose(&problem, facts, &Options::default(), &|_| (), &AtomicBool::new(false)).unwrap().diagnosis
}

/// Half an hour at 1 s of a simulation that goes up and down.
fn simulated() -> Inputs {
    let rows = 1800;
    Inputs {
        time_s: Some((0..rows).map(f64::from).collect()),
        run: vec![1; rows as usize],
        simulated: Some((0..rows).map(|row| 3.0 + (f64::from(row) / 90.0).sin()).collect()),
        ..Inputs::default()
    }
}

#[test]
fn a_simulation_without_a_free_number_that_is_right_agrees() {
    let inputs = simulated();
    let truth = inputs.simulated.clone().unwrap();
    let said = said(&Given::fixed(), &inputs, &noisy(1, |row| truth[row], truth.len()));
    assert_eq!((said.verdict, said.findings.len()), (Verdict::Agrees, 0), "{}", said.says);
}

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

/// One row a run, an hour apart: no time passes inside a run, and a drift is told from run to run.
#[test]
fn one_row_a_run_with_a_clock_is_diagnosed() {
    let rows = 120;
    let inputs = Inputs {
        time_s: Some((0..rows).map(|row| 3600.0 * f64::from(row)).collect()),
        run: (1..=rows).collect(),
        temperature_c: Some((0..rows).map(|row| 22.0 + 5.0 * (f64::from(row) / 9.0).sin()).collect()),
        ..Inputs::default()
    };
    let warm = inputs.temperature_c.clone().unwrap();
    let said = said(&Given::with_level(), &inputs, &noisy(3, |row| 3.0 + 0.05 * (warm[row] - 20.0), rows as usize));
    let named: Vec<&str> = said.findings.iter().map(|f| f.effect.as_str()).collect();
    assert_eq!(named, ["temperature_coefficient"], "{}", said.says);
    let lag = said.not_testable.iter().find(|n| n.effect == "thermal_lag").unwrap();
    assert!(lag.says.contains("every run is one row"), "{}", lag.says);
}

/// A thermometer that swings by 5 K, 2 mV/K: one standard deviation of a row. One row in 1800 is off by a hundred.
#[test]
fn a_single_wild_row_does_not_take_the_verdict() {
    let inputs = Inputs {
        time_s: Some((0..1800).map(f64::from).collect()),
        run: vec![1; 1800],
        temperature_c: Some((0..1800).map(|row| 22.0 + 5.0 * (f64::from(row) / 90.0).sin()).collect()),
        ..Inputs::default()
    };
    let warm = inputs.temperature_c.clone().unwrap();
    let wild = |row: usize| if row == 700 { 1.0 } else { 0.0 };
    let said = said(&Given::with_level(), &inputs, &noisy(5, |row| 3.0 + 0.002 * (warm[row] - 20.0) + wild(row), 1800));
    let named: Vec<&str> = said.findings.iter().map(|f| f.effect.as_str()).collect();
    assert_eq!((said.verdict, named), (Verdict::Explained, vec!["temperature_coefficient"]), "{}", said.says);
    assert!(said.noise.says.contains("wild"), "{}", said.noise.says);
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

/// Nothing but the reading, no clock, and it drifts: there is no input along which it could be located, and the answer says that it is wrong.
#[test]
fn a_response_alone_is_diagnosed() {
    let inputs = Inputs { run: vec![1; 400], ..Inputs::default() };
    let said = said(&Given::with_level(), &inputs, &noisy(4, |row| 3.0 + 0.002 * row as f64, 400));
    assert!(said.verdict != Verdict::Agrees && said.findings.is_empty() && said.mismatch.is_empty(), "{}", said.says);
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

/// A level that jumps by 1 V after a fifth of the rows, under noise with a long memory. Under that noise a fit follows changes from row to row and ends midway between the ends of
/// the recording, 0.5 V off at each; by least squares the level is the mean, and what it leaves is the scatter about it.
#[test]
fn the_base_model_alone_is_calibrated_by_least_squares() {
    let base = Given::with_level();
    let mut random = ChaCha8Rng::seed_from_u64(12);
    let mut slow = 0.0;
    let mut noisy = |row: usize| {
        let unit: f64 = StandardNormal.sample(&mut random);
        slow = 0.97 * slow + 0.005 * unit;
        3.0 + slow + f64::from(u8::from(row >= 160))
    };
    let response: Vec<f64> = (0..800).map(&mut noisy).collect();
    let time = (0..800).map(f64::from).collect();
    let inputs = Inputs { time_s: Some(time), run: vec![1; 800], ..Inputs::default() };
    let problem = Problem { inputs: &inputs, response: &response, simulator: &base };
    let facts = RecordingFacts { rows: 800, runs: 1, ..RecordingFacts::default() };
    let found = diagnose(&problem, facts, &Options::default(), &|_| (), &AtomicBool::new(false)).unwrap().diagnosis;
    let mean = response.iter().sum::<f64>() / 800.0;
    let scatter = (response.iter().map(|y| (y - mean).powi(2)).sum::<f64>() / 800.0).sqrt();
    assert_ne!(found.verdict, Verdict::Agrees, "{}", found.says);
    // the prior of the level, 5 V wide, weighs nothing beside 800 rows; iterations end within a thousandth
    approx::assert_relative_eq!(found.fit.in_sample.rmse_before, scatter, max_relative = 2e-3);
}

#[test]
fn friction_is_not_looked_for_where_nothing_turns() {
    let base = Given::with_level();
    let asked = |x: &dyn Fn(f64) -> f64| {
        let values = (0..200).map(|row| x(f64::from(row) / 200.0)).collect();
        let driver = Driver { name: "stage".into(), unit: "m".into(), values };
        let time = (0..200).map(f64::from).collect();
        let inputs = Inputs { time_s: Some(time), run: vec![1; 200], drivers: vec![driver], ..Inputs::default() };
        let context = Context::new(&inputs, &base, 1.0, 0.01);
        library().iter().find(|effect| effect.id().0 == "friction").unwrap().testable(&context)
    };
    let one_way = asked(&|t| 3.0 * t + 0.02 * (300.0 * t).sin()).unwrap_err();
    assert!(one_way.contains("stage") && one_way.contains("one way"), "{one_way}");
    assert!(asked(&|t| (7.0 * t).sin()).is_ok());
}

/// Set points in any order turn at every second row; that is no way that friction could hold back.
#[test]
fn friction_is_not_looked_for_in_a_table_of_set_points() {
    let base = Given::with_level();
    let asked = |values: Vec<f64>| {
        let driver = Driver { name: "stage".into(), unit: "m".into(), values };
        let inputs = Inputs { run: vec![1; 200], drivers: vec![driver], ..Inputs::default() };
        let context = Context::new(&inputs, &base, 1.0, 0.01);
        library().iter().find(|effect| effect.id().0 == "friction").unwrap().testable(&context).is_ok()
    };
    assert!(!asked((0..200).map(|row| f64::from(row * 77 % 200)).collect()));
    assert!(asked((0..200).map(|row| f64::from(100 - (row - 100i32).abs())).collect()));
}

/// Every fifth specimen of a table reads as the one before it. With a clock that is a logger that wrote old values again.
#[test]
fn rows_repeat_where_a_clock_says_that_they_follow_one_another() {
    let base = Given::with_level();
    let mut random = ChaCha8Rng::seed_from_u64(5);
    let mut response: Vec<f64> = Vec::new();
    for row in 0..400 {
        let unit: f64 = StandardNormal.sample(&mut random);
        let drawn = (1e4 * (3.0 + 0.05 * unit)).round() / 1e4;
        response.push(if row % 5 == 4 { response[row - 1] } else { drawn });
    }
    let said = |time_s: Option<Vec<f64>>| {
        let inputs = Inputs { time_s, run: vec![1; 400], ..Inputs::default() };
        let problem = Problem { inputs: &inputs, response: &response, simulator: &base };
        repeated(&problem, &Rows { inputs: &inputs, given: None, unit: "V" }).is_some()
    };
    assert!(said(Some((0..400).map(f64::from).collect())));
    assert!(!said(None));
}

/// A rudder that is told to stand still for some rows now and then, read in steps of 3 mrad, coarser than its noise: neighbouring rows are equal since nothing moves, and none is left out.
#[test]
fn a_reading_in_steps_does_not_repeat_where_what_it_follows_stands_still() {
    let told = |row: usize| 4.0 * ((row - (row % 12).min(3)) as f64 / 7.0).sin();
    let mut random = ChaCha8Rng::seed_from_u64(6);
    let mut read = |row: usize| {
        let unit: f64 = StandardNormal.sample(&mut random);
        ((told(row) + 0.0004 * unit) / 0.003).round() * 0.003
    };
    let response: Vec<f64> = (0..800).map(&mut read).collect();
    let inputs = Inputs {
        time_s: Some((0..800).map(f64::from).collect()),
        run: vec![1; 800],
        simulated: Some((0..800).map(told).collect()),
        ..Inputs::default()
    };
    let problem = Problem { inputs: &inputs, response: &response, simulator: &Given::fixed() };
    assert!(repeated(&problem, &Rows { inputs: &inputs, given: None, unit: "rad" }).is_none());
}

/// The proof is a function of the user's own: an exception in it ends the whole diagnosis, even where it is thrown by the last question of all.
#[test]
fn a_simulator_is_never_asked_without_the_drivers_that_were_recorded() {
    let fan = |row: usize| (row as f64 / 40.0).sin();
    let inputs = Inputs {
        time_s: Some((0..900).map(f64::from).collect()),
        run: vec![1; 900],
        temperature_c: Some((0..900).map(|row| 22.0 + 5.0 * (f64::from(row) / 90.0).sin()).collect()),
        drivers: vec![Driver { name: "fan".into(), unit: "1/s".into(), values: (0..900).map(fan).collect() }],
        ..Inputs::default()
    };
    let warm = inputs.temperature_c.clone().unwrap();
    let simulator = Given { follows_driver: true, ..Given::with_level() };
    let response = noisy(7, |row| 3.0 + fan(row) + 0.02 * (warm[row] - 20.0), 900);
    let said = said(&simulator, &inputs, &response);
    assert!(said.findings.iter().any(|f| f.effect == "temperature_coefficient"), "{}", said.says);
    assert_eq!(simulator.asked_without.load(Ordering::Relaxed), 0);
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
    assert!(said.findings[0].says.starts_with("the clock of power is "), "{}", said.findings[0].says);
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
