//! Laws of what goes up and down: play, loops, curves with turns, and what the greatest way leaves.

use crate::given::{Given, noisy, said, said_by};
use truegap_core::{Driver, Inputs};
use truegap_diagnose::Verdict;

/// A gear with play: what it turns stays behind by 0.06 until the play is taken up, and the whole play is told.
#[test]
fn a_play_is_told_with_its_width() {
    let rows = 3000;
    let told: Vec<f64> = (0..rows).map(|row| 2.0 * (row as f64 / 70.0).sin() + 0.7 * (row as f64 / 23.0).sin()).collect();
    let mut turned = told[0];
    let truth: Vec<f64> = told
        .iter()
        .map(|x| {
            turned = turned.clamp(x - 0.06, x + 0.06);
            turned
        })
        .collect();
    let inputs = Inputs {
        time_s: Some((0..rows).map(|row| 0.02 * row as f64).collect()),
        run: vec![1; rows],
        simulated: Some(told),
        ..Inputs::default()
    };
    let said = said(&Given { unit: "mm", ..Given::fixed() }, &inputs, &noisy(10, |row| truth[row], rows));
    let named: Vec<&str> = said.findings.iter().map(|f| f.effect.as_str()).collect();
    assert_eq!((said.verdict, named.as_slice()), (Verdict::Explained, &["friction"][..]), "{}", said.says);
    let number = |name: &str| said.findings[0].parameters.iter().find(|p| p.name == name).unwrap();
    let (force, width) = (number("force"), number("width"));
    assert!(
        (force.value.abs() - 0.06).abs() < 4.0 * force.sd && (width.value - 0.06).abs() < 4.0 * width.sd,
        "{}",
        said.findings[0].says
    );
    assert!(said.findings[0].says.contains("backlash"), "{}", said.findings[0].says);
}

/// A magnet in a field that goes up and down: many grains, each of which turns over at a field of its own, one or the other way. Nothing of the loop's equation is in it.
#[test]
fn grains_that_turn_over_make_a_loop_that_saturates() {
    let (rows, grains) = (1600, 400);
    let field: Vec<f64> = (0..rows).map(|row| 3.0 * (f64::from(row) / 120.0).sin()).collect();
    // thresholds of a logistic distribution about 0.8
    let turns_at: Vec<f64> =
        (0..grains).map(|k| (f64::from(k) + 0.5) / f64::from(grains)).map(|p| 0.8 + 0.1 * (p / (1.0 - p)).ln()).collect();
    let mut up = vec![false; grains as usize];
    let truth: Vec<f64> = field
        .iter()
        .map(|x| {
            up.iter_mut().zip(&turns_at).for_each(|(up, at)| *up = *x >= *at || (*up && *x > -at));
            3.0 + 0.4 * (2.0 * up.iter().filter(|up| **up).count() as f64 / f64::from(grains) - 1.0)
        })
        .collect();
    let inputs = driven("field", "kOe", field);
    let said = said(&Given::with_level(), &inputs, &noisy(21, |row| truth[row], rows as usize));
    let named: Vec<&str> = said.findings.iter().map(|f| f.effect.as_str()).collect();
    assert_eq!(named.first(), Some(&"saturating_loop"), "{}", said.says);
    let number = |name: &str| said.findings[0].parameters.iter().find(|p| p.name == name).unwrap().value;
    // the law is another one, so its numbers are near and no more
    assert!((number("height") - 0.4).abs() < 0.04 && (number("half_width") - 0.8).abs() < 0.04, "{}", said.says);
}

/// Neither a slide that rubs nor a curve without a loop is a loop that saturates.
#[test]
fn friction_and_a_curve_are_no_loop_that_saturates() {
    let rows = 1600;
    let x: Vec<f64> = (0..rows).map(|row| 3.0 * (f64::from(row) / 120.0).sin()).collect();
    let mut slip = 0.0;
    let rubs: Vec<f64> = (0..rows as usize)
        .map(|row| {
            let step: f64 = if row == 0 { 0.0 } else { x[row] - x[row - 1] };
            slip = (slip + step / 0.05_f64).clamp(-1.0, 1.0);
            3.0 + 0.3 * x[row] + 0.1 * slip
        })
        .collect();
    let bends: Vec<f64> = x.iter().map(|x| 3.0 + 0.4 * (x / 0.7).tanh()).collect();
    for (truth, seed) in [(rubs, 22), (bends, 23)] {
        let inputs = driven("place", "mm", x.clone());
        let said =
            said(&Given { follows_driver: true, ..Given::with_level() }, &inputs, &noisy(seed, |row| truth[row], rows as usize));
        assert!(said.findings.iter().all(|f| f.effect != "saturating_loop"), "{}", said.says);
    }
}

/// Dew lies on a window from a humidity of 88 % on, the same on the way up and down: a flank of no width stood for the knee.
#[test]
fn a_knee_in_a_driver_is_no_loop() {
    let damp: Vec<f64> =
        (0..1400).map(f64::from).map(|row| 66.0 + 22.0 * (row / 40.0).sin() + 12.0 * (row / 17.3).sin()).collect();
    let inputs = driven("damp", "%", damp.clone());
    let said = said(&Given::with_level(), &inputs, &noisy(27, |row| 3.0 + 0.004 * (damp[row] - 88.0).max(0.0), damp.len()));
    assert!(!said.findings.is_empty(), "{}", said.says);
    assert!(said.findings.iter().all(|f| f.effect != "saturating_loop" && f.effect != "friction"), "{}", said.says);
}

/// A stage that goes up and down, with a scale that is bent by 0.2 V in the middle, or in waves of 0.2 V: further weights are held at nothing for the one, and opened for the other.
#[test]
fn a_curve_has_further_turns_where_rows_left_out_bear_them_out() {
    let x: Vec<f64> = (0..1800).map(|row| usize::abs_diff(row % 300, 150) as f64 / 150.0).collect();
    let arch = |x: f64| 0.8 * x * (1.0 - x);
    let waves = |x: f64| 0.2 * (5.0 * std::f64::consts::PI * x).sin();
    for (departure, seed, held) in [(&arch as &dyn Fn(f64) -> f64, 31, true), (&waves, 32, false)] {
        let inputs = driven("place", "mm", x.clone());
        let given = Given { follows_driver: true, ..Given::with_level() };
        let said = said_by(&["nonlinearity"], &given, &inputs, &noisy(seed, |row| 3.0 + x[row] + departure(x[row]), x.len()));
        assert_eq!(said.findings.len(), 1, "{}", said.says);
        // five half waves are the same seen from both ends, so that of the two weights one is needed
        let ripple = said.findings[0].parameters.iter().find(|p| p.name == "ripple").unwrap();
        assert_eq!(ripple.meaning.contains("held at 0"), held, "{}", ripple.meaning);
        // noise of 0.01; five half waves are not quite a polynomial of the fourth degree on an arch
        assert!(said.fit.in_sample.rmse_after < 0.02, "{}: {}", said.fit.in_sample.rmse_after, said.says);
    }
}

/// A press that goes a step farther each time and back again: 2, 4, ... 12 mm.
fn pressed() -> Vec<f64> {
    let way = |stroke: usize, row: usize| 2.0 * (stroke + 1) as f64 * (1.0 - (row as f64 - 100.0).abs() / 100.0);
    (0..6).flat_map(|stroke| (0..200).map(move |row| way(stroke, row))).collect()
}

/// A foam that gives 1 V for each mm and keeps, by the square of the greatest way so far, 0.3 V more at 12 mm; the generator takes the set as pressed flat in thin layers, one after another.
#[test]
fn a_set_that_the_greatest_way_leaves_is_named() {
    let x = pressed();
    let mut layers = [false; 240];
    let truth: Vec<f64> = x
        .iter()
        .map(|x| {
            layers.iter_mut().enumerate().for_each(|(k, flat)| *flat |= *x > 0.05 * (k as f64 + 0.5));
            // layers take more of it the deeper they lie
            let set: f64 =
                layers.iter().enumerate().filter(|(_, flat)| **flat).map(|(k, _)| (k as f64 + 0.5) * 2.0 / 57_600.0).sum();
            3.0 + x + 0.3 * set
        })
        .collect();
    let inputs = driven("place", "mm", x);
    let said = said(&Given { follows_driver: true, ..Given::with_level() }, &inputs, &noisy(24, |row| truth[row], truth.len()));
    let named: Vec<&str> = said.findings.iter().map(|f| f.effect.as_str()).collect();
    assert_eq!(named, ["permanent_set"], "{}", said.says);
    let number = |name: &str| said.findings[0].parameters.iter().find(|p| p.name == name).unwrap();
    let (left, exponent) = (number("left"), number("exponent"));
    assert!((left.value - 0.3).abs() < 4.0 * left.sd && (exponent.value - 2.0).abs() < 4.0 * exponent.sd, "{}", said.says);
}

/// A slide that rubs and a curve go the same way each time: nothing stays.
#[test]
fn friction_and_a_curve_leave_no_set() {
    let x = pressed();
    let mut slip = 0.0;
    let rubs: Vec<f64> = (0..x.len())
        .map(|row| {
            let step: f64 = if row == 0 { 0.0 } else { x[row] - x[row - 1] };
            slip = (slip + step / 0.2_f64).clamp(-1.0, 1.0);
            3.0 + x[row] + 0.1 * slip
        })
        .collect();
    let bends: Vec<f64> = x.iter().map(|x| 3.0 + x + 0.3 * (x / 6.0).tanh()).collect();
    for (truth, seed) in [(rubs, 25), (bends, 26)] {
        let inputs = driven("place", "mm", x.clone());
        let said =
            said(&Given { follows_driver: true, ..Given::with_level() }, &inputs, &noisy(seed, |row| truth[row], truth.len()));
        assert!(said.findings.iter().all(|f| f.effect != "permanent_set"), "{}", said.says);
    }
}

/// A recorded driver on a clock of whole seconds.
fn driven(name: &str, unit: &str, values: Vec<f64>) -> Inputs {
    let rows = values.len();
    let drivers = vec![Driver { name: name.into(), unit: unit.into(), values }];
    Inputs { time_s: Some((0..rows).map(|row| row as f64).collect()), run: vec![1; rows], drivers, ..Inputs::default() }
}
