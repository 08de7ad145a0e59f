//! What moves and what is switched, end to end on recordings with a base that knows neither.

#![allow(clippy::unwrap_used)]

use std::sync::atomic::AtomicBool;
use truegap::core::Recording;
use truegap::diagnose::answer::Diagnosis;
use truegap::diagnosis::{Request, diagnose, open};

/// Noise of unit variance, always the same: twelve uniform numbers each.
fn noise() -> impl FnMut() -> f64 {
    let mut state = 1u64;
    let mut uniform = move || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 11) as f64 / (1u64 << 53) as f64
    };
    move || (0..12).map(|_| uniform()).sum::<f64>() - 6.0
}

fn diagnosed(toml: &str, header: &str, rows: &[Vec<f64>]) -> Diagnosis {
    let folder = tempfile::tempdir().unwrap();
    let line = |values: &Vec<f64>| values.iter().map(|v| format!("{v:.7}")).collect::<Vec<_>>().join(",") + "\n";
    std::fs::write(folder.path().join("r.csv"), format!("{header}\n{}", rows.iter().map(line).collect::<String>())).unwrap();
    let file = folder.path().join("r.toml");
    std::fs::write(&file, format!("schema = \"truegap.recording/1\"\nfile = \"r.csv\"\n{toml}")).unwrap();
    let recording = Recording::open(&file).unwrap();
    let (request, files) = (Request::default(), vec![("r.csv".to_owned(), recording.sha256.clone())]);
    let opened = open(vec![recording], &request).unwrap();
    diagnose(opened, files, &request, &|_| (), &AtomicBool::new(false)).unwrap().outcome.diagnosis
}

fn named(diagnosis: &Diagnosis) -> Vec<&str> {
    diagnosis.findings.iter().map(|f| f.effect.as_str()).collect()
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
    let mut noise = noise();
    let (mut height, mut wander) = (0.1, 0.0);
    let mut rows = Vec::new();
    let (mut law, mut given) = (Vec::new(), Vec::new());
    for i in 0..1200_u32 {
        // up 1.2 s, still 0.8 s, down 1 s, still 0.8 s; each begins and ends within 0.16 s
        let into = f64::from(i % 190);
        let ramp = |from: f64, to: f64| ((into - from) / 8.0).clamp(0.0, 1.0) * ((to - into) / 8.0).clamp(0.0, 1.0);
        let speed = 0.02 * ramp(0.0, 60.0) - 0.024 * ramp(100.0, 150.0);
        height += 0.02 * speed;
        wander = 0.97 * wander + 0.073 * noise();
        let share = if speed == 0.0 { 1.0 } else { 0.4 };
        law.push((speed / 0.003).tanh());
        given.push(1.0 + 0.75 * law[i as usize] + share * wander + 0.1 * noise());
        rows.push(vec![0.02 * f64::from(i), height, given[i as usize]]);
    }
    let toml = "[columns]\nresponse = \"motor\"\n[units]\nresponse = \"V\"\n[drivers]\nposition = { column = \"height\", unit = \"m\" }\n\
                [base]\nmodel = \"constant\"\n";
    let diagnosis = diagnosed(toml, "time_s,height,motor", &rows);
    assert_eq!(named(&diagnosis), ["friction"], "{}", diagnosis.says);
    let force = diagnosis.findings[0].parameters.iter().find(|p| p.name == "force").unwrap();
    assert!((force.value - 0.75).abs() < 3.0 * force.sd && force.sd < 0.15, "{} {}", force.value, force.sd);
    let unseen = diagnosis.fit.held_out.rmse_after.unwrap();
    assert!(unseen < 1.1 * left_by_a_line(&law, &given), "{unseen} against {}", left_by_a_line(&law, &given));
}

/// The zero alone is switched by 0.2 V, from one row to the next: 5 % of the range beside a gain that stays.
#[test]
fn a_zero_that_is_switched_is_told_as_a_zero() {
    let mut noise = noise();
    let mut simulated = 0.0;
    let row = |i: u32| {
        simulated = 0.98 * simulated + 0.2 * noise();
        vec![f64::from(i), simulated, 0.5 * simulated + if i > 316 { 0.2 } else { 0.0 } + 0.016 * noise()]
    };
    let rows: Vec<Vec<f64>> = (0..900).map(row).collect();
    let diagnosis =
        diagnosed("[base]\nmodel = \"external\"\nfree = [\"gain\", \"offset\"]\n", "time_s,simulated,response_v", &rows);
    assert_eq!(named(&diagnosis), ["regime_change"], "{}", diagnosis.says);
    let when = diagnosis.findings[0].parameters.iter().find(|p| p.name == "when").unwrap();
    assert!((when.value - 316.5).abs() < 2.0, "{}", when.value);
    let sentence = &diagnosis.findings[0].says;
    assert!(sentence.contains("and the reading by 20") || sentence.contains("and the reading by 19"), "{sentence}");
    assert!(!sentence.contains("limit"), "{sentence}");
}
