//! What follows the clock and what follows the way that an input goes, end to end: loops, drifts and days.

#![allow(clippy::unwrap_used)]

#[path = "common/noise.rs"]
mod noise;

use noise::noise;
use std::sync::atomic::AtomicBool;
use truegap::core::Recording;
use truegap::diagnose::answer::Diagnosis;
use truegap::diagnosis::{Request, diagnose, open};

fn diagnosed(toml: &str, header: &str, rows: usize, row: impl FnMut(usize) -> Vec<f64>) -> Diagnosis {
    let folder = tempfile::tempdir().unwrap();
    let line = |values: Vec<f64>| values.iter().map(|v| format!("{v:.6}")).collect::<Vec<_>>().join(",") + "\n";
    let rows: String = (0..rows).map(row).map(line).collect();
    std::fs::write(folder.path().join("r.csv"), format!("{header}\n{rows}")).unwrap();
    let toml = format!("schema = \"truegap.recording/1\"\nfile = \"r.csv\"\n{toml}");
    std::fs::write(folder.path().join("r.toml"), toml).unwrap();
    let recording = Recording::open(folder.path().join("r.toml")).unwrap();
    let request = Request::default();
    let files = vec![("r.csv".to_owned(), recording.sha256.clone())];
    let opened = open(vec![recording], &request).unwrap();
    diagnose(opened, files, &request, &|_| (), &AtomicBool::new(false)).unwrap().outcome.diagnosis
}

fn named(diagnosis: &Diagnosis) -> Vec<&str> {
    let found = diagnosis.findings.iter().map(|f| f.effect.as_str());
    found.chain(diagnosis.ambiguity.iter().flatten().map(String::as_str)).collect()
}

/// A stage goes out in 3 s, stands for 3 s and goes back in 3 s. It is 2 um behind either way, which changes over within 3 V of a turn (Dahl's law), and creeps by a micrometre. One law on
/// the way out and another one on the way back is what a change at the turn would say as well.
#[test]
fn one_loop_is_friction_and_no_change_of_regime() {
    let (mut noise, mut way, mut before) = (noise(5), 0.0, 0.0);
    let row = |i: usize| {
        let t = 0.01 * i as f64;
        let volts = if t < 3.0 {
            10.0 * t
        } else if t < 6.0 {
            30.0
        } else {
            90.0 - 10.0 * t
        };
        let travel: f64 = volts - before;
        if travel != 0.0 {
            way = travel.signum() + (way - travel.signum()) * (-travel.abs() / 3.0).exp();
        }
        before = volts;
        let creep = 1.0 - (-t / 4.0).exp();
        vec![t, volts, volts - 2.0 * way + creep + 0.02 * noise()]
    };
    let toml = "[columns]\ntime = \"time_s\"\nresponse = \"sensed\"\n[units]\nresponse = \"um\"\n[drivers]\ncommand = { column = \"command_v\", unit = \"V\" }\n[base]\nmodel = \"linear\"\ndriver = \"command\"\n";
    let said = diagnosed(toml, "time_s,command_v,sensed", 900, row);
    assert!(named(&said).contains(&"friction"), "{}", said.says);
    let regime = said.not_testable.iter().find(|n| n.effect == "regime_change").unwrap();
    assert!(regime.says.contains("no more than once"), "{}", regime.says);
}

const CONSTANT: &str =
    "[columns]\ntime = \"time_s\"\nresponse = \"phase_ns\"\n[units]\nresponse = \"ns\"\n[base]\nmodel = \"constant\"\n";

/// 20 ns in two hours beside a phase that walks by 0.1 ns a row (1.9 ns over the recording, where it is kept near 0 by a memory of 100 rows).
#[test]
fn a_clock_of_another_rate_drifts() {
    let (mut noise, mut walk) = (noise(5), 0.0);
    let row = |i: usize| {
        walk = 0.99 * walk + 0.1 * noise();
        vec![10.0 * i as f64, 20.0 * i as f64 / 720.0 + walk]
    };
    let said = diagnosed(CONSTANT, "time_s,phase_ns", 720, row);
    assert!(said.findings.iter().any(|f| f.effect == "offset_drift"), "{}", said.says);
    let rate = &said.findings.iter().find(|f| f.effect == "offset_drift").unwrap().parameters[0];
    // 10 ns/h; the walk alone makes 0.7 ns of either end
    assert!((rate.value - 10.0).abs() < 1.5 && rate.unit == "ns/h", "{} {}", rate.value, rate.unit);
}

/// Two and a half days of a cycle of 3 ns, every five minutes.
#[test]
fn two_days_show_the_time_of_day() {
    let mut noise = noise(5);
    let row = |i: usize| {
        let day = i as f64 / 288.0;
        vec![300.0 * i as f64, 1.5 * (std::f64::consts::TAU * (day - 0.3)).cos() + 0.5 * noise()]
    };
    let said = diagnosed(CONSTANT, "time_s,phase_ns", 720, row);
    assert_eq!(said.findings.iter().map(|f| f.effect.as_str()).collect::<Vec<_>>(), ["daily_cycle"], "{}", said.says);
    let size = &said.findings[0].parameters[0];
    // 0.5 ns of noise in 720 rows: 0.05 ns of the way from least to most
    assert!((size.value - 3.0).abs() < 0.2, "{}", size.value);
}

/// Two instruments look at one quantity, which is all that changes.
#[test]
fn a_simulation_that_moves_is_an_input_that_changes() {
    let mut noise = noise(5);
    let row = |i: usize| {
        let truth = 10.0 * (i as f64 / 40.0).sin();
        vec![i as f64, truth, truth + 0.1 * noise()]
    };
    let said = diagnosed("[units]\nresponse = \"degC\"\n[base]\nmodel = \"external\"\n", "time_s,simulated,response", 600, row);
    assert!(!said.recording_issues.iter().any(|issue| issue.contains("no input changes")), "{:?}", said.recording_issues);
}

/// Root mean square of what a straight line of `y` on `x` leaves.
fn left_by_a_line(x: &[f64], y: &[f64]) -> f64 {
    let rows = x.len() as f64;
    let mean = |column: &[f64]| column.iter().sum::<f64>() / rows;
    let (of_x, of_y) = (mean(x), mean(y));
    let slope =
        x.iter().zip(y).map(|(x, y)| (x - of_x) * (y - of_y)).sum::<f64>() / x.iter().map(|x| (x - of_x).powi(2)).sum::<f64>();
    (x.iter().zip(y).map(|(x, y)| (y - of_y - slope * (x - of_x)).powi(2)).sum::<f64>() / rows).sqrt()
}

/// A motor that lifts and lowers a weight, with pauses: it gives 1 V, and 0.75 V more or less while it moves, as tanh(speed / 3 mm/s). At standstill its controller wanders, so that the
/// noise measured there is louder and slower than that of the motion: a fit under it halves the friction. The yardstick is the law itself by least squares.
#[test]
fn what_a_motor_gives_while_it_moves_is_friction() {
    let mut noise = noise(1);
    let (mut height, mut wander) = (0.1, 0.0);
    let (mut law, mut given) = (Vec::new(), Vec::new());
    let row = |i: usize| {
        // up 1.2 s, still 0.8 s, down 1 s, still 0.8 s; each begins and ends within 0.16 s
        let into = (i % 190) as f64;
        let ramp = |from: f64, to: f64| ((into - from) / 8.0).clamp(0.0, 1.0) * ((to - into) / 8.0).clamp(0.0, 1.0);
        let speed = 0.02 * ramp(0.0, 60.0) - 0.024 * ramp(100.0, 150.0);
        height += 0.02 * speed;
        wander = 0.97 * wander + 0.073 * noise();
        let share = if speed == 0.0 { 1.0 } else { 0.4 };
        law.push((speed / 0.003).tanh());
        given.push(1.0 + 0.75 * law[i] + share * wander + 0.1 * noise());
        vec![0.02 * i as f64, height, given[i]]
    };
    let toml = "[columns]\nresponse = \"motor\"\n[units]\nresponse = \"V\"\n[drivers]\nposition = { column = \"height\", unit = \"m\" }\n\
                [base]\nmodel = \"constant\"\n";
    let diagnosis = diagnosed(toml, "time_s,height,motor", 1200, row);
    assert_eq!(named(&diagnosis), ["friction"], "{}", diagnosis.says);
    let force = diagnosis.findings[0].parameters.iter().find(|p| p.name == "force").unwrap();
    assert!((force.value - 0.75).abs() < 3.0 * force.sd && force.sd < 0.15, "{} {}", force.value, force.sd);
    let unseen = diagnosis.fit.held_out.rmse_after.unwrap();
    assert!(unseen < 1.1 * left_by_a_line(&law, &given), "{unseen} against {}", left_by_a_line(&law, &given));
}

/// The zero alone is switched by 0.2 V, from one row to the next: 5 % of the range beside a gain that stays.
#[test]
fn a_zero_that_is_switched_is_told_as_a_zero() {
    let mut noise = noise(1);
    let mut simulated = 0.0;
    let row = |i: usize| {
        simulated = 0.98 * simulated + 0.2 * noise();
        vec![i as f64, simulated, 0.5 * simulated + if i > 316 { 0.2 } else { 0.0 } + 0.016 * noise()]
    };
    let diagnosis =
        diagnosed("[base]\nmodel = \"external\"\nfree = [\"gain\", \"offset\"]\n", "time_s,simulated,response_v", 900, row);
    assert_eq!(named(&diagnosis), ["regime_change"], "{}", diagnosis.says);
    let when = diagnosis.findings[0].parameters.iter().find(|p| p.name == "when").unwrap();
    assert!((when.value - 316.5).abs() < 2.0, "{}", when.value);
    let sentence = &diagnosis.findings[0].says;
    assert!(sentence.contains("the zero changes by 20") || sentence.contains("the zero changes by 19"), "{sentence}");
    assert!(!sentence.contains("limit"), "{sentence}");
}
