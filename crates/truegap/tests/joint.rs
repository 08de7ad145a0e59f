//! Several recordings diagnosed together: the same answer as of one, and what only several can tell.

#![allow(clippy::unwrap_used)]

use std::path::Path;
use std::sync::atomic::AtomicBool;
use truegap::Sensor;
use truegap::core::{BaseSpec, Inputs, Recording, Simulator};
use truegap::diagnose::answer::{Diagnosis, Verdict};
use truegap::diagnose::{Context, library};
use truegap::diagnosis::{Request, diagnose, example_recording, open};
use truegap::model::Stack;

fn diagnosed(recordings: Vec<Recording>, request: &Request) -> Diagnosis {
    let files = recordings.iter().enumerate().map(|(k, r)| (format!("{}.csv", k + 1), r.sha256.clone())).collect();
    let several = recordings.len() > 1;
    let opened = open(recordings, request).unwrap();
    let diagnosed = diagnose(opened, files, request, &|_| (), &AtomicBool::new(false)).unwrap();
    assert_eq!(truegap::diagnosis::report::html(&diagnosed.subject()).contains("The recordings"), several);
    assert_eq!(diagnosed.prediction_csv().starts_with("run,recording,time_s"), several);
    diagnosed.outcome.diagnosis
}

/// Rows of some runs as a recording of their own, whose clock starts at 0.
fn runs_of(whole: &Recording, wanted: std::ops::RangeInclusive<u32>) -> Recording {
    let rows: Vec<usize> = (0..whole.len()).filter(|row| wanted.contains(&whole.inputs.run[*row])).collect();
    let mut part = whole.select(&rows);
    let start = part.inputs.time_s.as_ref().unwrap()[0];
    part.inputs.time_s.iter_mut().flatten().for_each(|t| *t -= start);
    part
}

#[test]
fn a_recording_in_two_files_has_the_answer_of_the_whole() {
    let whole = example_recording().unwrap();
    let parts = vec![runs_of(&whole, 1..=4), runs_of(&whole, 5..=7)];
    let (one, two) = (diagnosed(vec![whole], &Request::default()), diagnosed(parts, &Request::default()));
    assert_eq!((one.verdict, two.verdict), (Verdict::Explained, Verdict::Explained));
    let tau = |d: &Diagnosis| (d.findings[0].effect.clone(), d.findings[0].parameters[0].value, d.findings[0].parameters[0].sd);
    let ((effect, value, sd), (other, split, split_sd)) = (tau(&one), tau(&two));
    assert_eq!((effect.as_str(), other.as_str()), ("thermal_lag", "thermal_lag"));
    // the same rows, parameters and priors: only the noise is measured in each part, which moves weights by some per cent
    assert!((value - split).abs() < 0.3 * sd && (split_sd / sd - 1.0).abs() < 0.1, "{value} +- {sd}, {split} +- {split_sd}");
    assert_eq!((two.recording.rows, two.recording.runs), (one.recording.rows, one.recording.runs));
    let each: Vec<(usize, u32)> = two.recording.recordings.iter().map(|r| (r.runs, r.first_run)).collect();
    assert_eq!(each, [(4, 1), (3, 5)]);
    assert_eq!(two.fit.held_out.recordings.len(), 2);
    let (before, after) = (two.fit.held_out.rmse_before.unwrap(), one.fit.held_out.rmse_before.unwrap());
    approx::assert_relative_eq!(before, after, max_relative = 0.02);
}

/// A sheet of foam between bare plates read against one another, of this diameter in mm.
fn sensor_toml(diameter_mm: f64, height_um: f64) -> String {
    let full_scale = 0.06 * std::f64::consts::PI * 0.25 * diameter_mm * diameter_mm; // 60 kPa
    format!(
        "schema = \"truegap.sensor/1\"\nname = \"disc-{diameter_mm}\"\ndescription = \"test\"\nlayout = \"mutual\"\n\
         full_scale = \"{full_scale} N\"\nreference_temperature = \"20 degC\"\n\
         [electrode]\ndiameter = \"{diameter_mm} mm +- 0.2 %\"\nconductor = {{ material = \"copper\", thickness = \"34 um\" }}\n\
         [insulator]\nmaterial = \"polyimide\"\nthickness = \"25 um\"\n\
         [dielectric]\nmaterial = \"foam\"\nheight = \"{height_um} um +- 3 %\"\nsolid = {{ coverage = \"100 %\" }}\n\
         [stray]\ncapacitance = \"0 pF\"\n\
         [materials.foam]\nyoung = \"300 kPa +- 20 %\"\nsoftening = \"0 kPa/K\"\npoisson = 0.1\nexpansion = \"250 ppm/K\"\n\
         permittivity = 1.4\n"
    )
}

/// Unit Gaussian numbers, always the same for a seed.
fn gaussian(seed: u64) -> impl FnMut() -> f64 {
    let mut state = seed;
    let mut uniform = move || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        ((state >> 11) as f64 + 0.5) / (1u64 << 53) as f64
    };
    move || (-2.0 * uniform().ln()).sqrt() * (std::f64::consts::TAU * uniform()).cos()
}

/// Rest, and two staircases up and down, in a run each.
fn staircases(full: f64) -> Inputs {
    let level = |row: usize| {
        let step = row / 15;
        if step < 8 { 0.0 } else { f64::from(10 - (step as i32 - 18).abs()).max(0.0) / 10.0 }
    };
    let rows = 29 * 15;
    Inputs {
        time_s: Some((0..2 * rows).map(|row| 0.5 * row as f64 + if row < rows { 0.0 } else { 60.0 }).collect()),
        run: (0..2 * rows).map(|row| if row < rows { 1 } else { 2 }).collect(),
        force_n: Some((0..2 * rows).map(|row| full * level(row % rows)).collect()),
        ..Inputs::default()
    }
}

/// What a sensor of this size reads with a field outside its plates: by the expansion that the fitter does not use, its height off its drawing.
fn with_fringing(folder: &Path, diameter_mm: f64, height_off: f64) -> Recording {
    let name = format!("disc-{diameter_mm}.toml");
    std::fs::write(folder.join(&name), sensor_toml(diameter_mm, 500.0)).unwrap();
    let truth = Sensor::from_toml(&sensor_toml(diameter_mm, 500.0 * (1.0 + height_off)), "truth").unwrap();
    let stack = Stack::new(&truth, truegap::model::StackOptions::default());
    let inputs = staircases(truth.full_scale);
    let values: Vec<f64> = stack.parameters().iter().map(|p| p.centre()).collect();
    let effects = library();
    let fringing = effects.iter().find(|e| e.id().0 == "fringing_field").unwrap();
    let context = Context::new(&inputs, &stack, 1.0, 0.01);
    let field = fringing.sibling(&[1.0], &context).unwrap();
    let mut response = stack.respond(&values, &inputs, &[field.as_ref()]).unwrap();
    let mut noise = gaussian(diameter_mm as u64);
    response.iter_mut().for_each(|r| *r += 0.01 * noise());
    let base = BaseSpec { model: "stack".into(), sensor: Some(folder.join(name).display().to_string()), ..BaseSpec::default() };
    Recording::new(inputs, response, "pF", base).unwrap()
}

#[test]
fn one_diameter_cannot_tell_a_field_outside_the_plates_from_a_stray_capacitance_and_three_can() {
    let folder = std::env::temp_dir().join(format!("truegap-joint-{}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    let sizes = [(15.0, 0.012), (8.0, -0.017), (30.0, 0.006)];
    let recordings: Vec<Recording> = sizes.iter().map(|(d, off)| with_fringing(&folder, *d, *off)).collect();
    let one = diagnosed(recordings[..1].to_vec(), &Request::default());
    let all = diagnosed(recordings, &Request::default());
    let _ = std::fs::remove_dir_all(&folder);
    assert_eq!(one.verdict, Verdict::Ambiguous, "{}", one.says);
    let both = |set: &Vec<String>| ["fringing_field", "parasitic_capacitance"].iter().all(|e| set.iter().any(|s| s == e));
    assert!(one.ambiguity.iter().any(both), "{:?}", one.ambiguity);
    assert_eq!((all.verdict, all.findings[0].effect.as_str()), (Verdict::Explained, "fringing_field"), "{}", all.says);
    assert_eq!(all.findings.len(), 1);
    let factor = &all.findings[0].parameters[0];
    // the two expansions differ by up to 4 % at these gaps (test of the effect), and by 7 % at the widest of them
    assert!((factor.value - 1.0).abs() < 0.08 + 3.0 * factor.sd, "{} +- {}", factor.value, factor.sd);
    let sharing = all.recording.sharing.as_ref().unwrap();
    assert_eq!(sharing.shared, ["young_rtv"]);
    assert_eq!(sharing.own.len(), 3, "{}", sharing.says);
}
