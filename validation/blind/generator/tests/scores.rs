//! The scorer on diagnoses whose worth is known: an oracle, a liar, one that never says anything.

use serde_json::{Value, json};
use std::path::PathBuf;
use truegap_generator::protocol::Kind;
use truegap_generator::score::folder::{score_folder, truths};
use truegap_generator::score::targets::{Row, by_detectability, rows};
use truegap_generator::score::truth::Truth;
use truegap_generator::score::{Scored, score, table::table};
use truegap_generator::{Answer, Options, Study};

/// Answers of a study as truths; the cases are cheap, 200 rows each.
fn study() -> Vec<Truth> {
    let study = Study::new(17, 60, Options { protocols: vec![Kind::Short], ..Options::default() }).expect("options");
    study.iter().map(|case| Truth::from(&case.expect("case").answer)).collect()
}

fn says(verdict: &str, named: &[&str], probability: f64) -> Value {
    let findings: Vec<Value> = named.iter().map(|id| json!({"effect": id, "probability": probability})).collect();
    json!({"verdict": verdict, "findings": findings, "fit": {"held_out": {"misfit_removed": 0.97}}})
}

fn oracle(truth: &Truth) -> Value {
    let causes: Vec<&str> = truth.causes.iter().map(String::as_str).collect();
    match (&truth.stranger, causes.is_empty()) {
        (Some(_), _) => says("unexplained", &[], 1.0),
        (None, true) => says("agrees", &[], 1.0),
        (None, false) => says("explained", &causes, 0.99),
    }
}

fn scored(diagnose: impl Fn(&Truth) -> Value) -> Vec<Scored> {
    study().into_iter().map(|truth| score(truth.clone(), &diagnose(&truth)).expect("scored")).collect()
}

fn row<'a>(rows: &'a [Row], says: &str) -> &'a Row {
    rows.iter().find(|row| row.says.starts_with(says)).unwrap_or_else(|| panic!("no row {says}"))
}

#[test]
fn an_oracle_meets_every_target_that_has_cases() {
    let rows = rows(&scored(oracle));
    assert!(rows.iter().all(|row| row.met != Some(false)), "{rows:#?}");
    assert!(row(&rows, "exact effect named").of >= 5);
    let bands = by_detectability(&scored(oracle));
    assert!(
        bands.iter().filter(|row| row.of > 0).all(|row| row.value == Some(f64::from(u8::from(!row.says.ends_with("wrong")))))
    );
    assert_eq!(row(&rows, "exact effect named").value, Some(1.0));
    assert!(row(&rows, "calibration").value.is_some_and(|ece| (ece - 0.01).abs() < 1e-9));
}

#[test]
fn a_liar_fails_where_it_should() {
    let rows = rows(&scored(|truth| {
        let lie = if truth.causes.contains("dead_gap") { "ageing" } else { "dead_gap" };
        says("explained", &[lie], 0.95)
    }));
    for target in ["false alarms, all", "exact effect", "wrong single", "strangers called", "calibration"] {
        assert_eq!(row(&rows, target).met, Some(false), "{target}");
    }
    assert_eq!(row(&rows, "wrong single").value, Some(1.0));
    assert!(row(&rows, "calibration").value.is_some_and(|ece| (ece - 0.95).abs() < 1e-9));
}

#[test]
fn silence_raises_no_alarm_and_detects_nothing() {
    let rows = rows(&scored(|_| says("agrees", &[], 1.0)));
    assert_eq!(row(&rows, "false alarms, all").value, Some(0.0));
    assert_eq!(row(&rows, "exact effect").value, Some(0.0));
    assert_eq!(row(&rows, "wrong single").value, None);
    let text = table(&scored(|_| says("agrees", &[], 1.0)));
    assert!(text.contains("nothing") && text.contains("exact effect named"), "{text}");
}

#[test]
fn a_folder_of_diagnoses_is_scored_after_its_commitments() {
    let folder = tempfile::tempdir().expect("folder");
    let study = Study::new(23, 4, Options { protocols: vec![Kind::Short], ..Options::default() }).expect("options");
    study.write(folder.path(), "{}", |_| ()).expect("written");
    let answers: Vec<Answer> = study.iter().map(|case| case.expect("case").answer).collect();
    for answer in &answers[..3] {
        let place = folder.path().join("said").join(&answer.case);
        std::fs::create_dir_all(&place).expect("folder");
        std::fs::write(place.join("diagnosis.json"), oracle(&Truth::from(answer)).to_string()).expect("diagnosis");
    }
    let scores = score_folder(folder.path(), &folder.path().join("said")).expect("scored");
    assert_eq!(scores.scored.len(), 3);
    assert_eq!(scores.absent, ["case-004"]);
}

/// The open recordings of the shared folder: an oracle that reads their truth is right on all of them.
#[test]
fn the_shared_open_recordings_can_be_scored() {
    let root = std::env::var_os("TRUEGAP_RECORDINGS").map(PathBuf::from).and_then(|p| p.parent().map(PathBuf::from));
    let beside = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../../../../shared");
    let Some(open) = root.into_iter().chain([beside]).map(|shared| shared.join("blind/open")).find(|path| path.exists()) else {
        println!("skipped: no ../shared/blind/open and TRUEGAP_RECORDINGS is not set");
        return;
    };
    let said = tempfile::tempdir().expect("folder");
    for truth in truths(&open).expect("truths") {
        std::fs::write(said.path().join(format!("{}.json", truth.case)), oracle(&truth).to_string()).expect("written");
    }
    let scores = score_folder(&open, said.path()).expect("scored");
    assert_eq!((scores.scored.len(), scores.absent.len()), (29, 0));
    let rows = rows(&scores.scored);
    assert!(rows.iter().all(|row| row.met != Some(false)), "{rows:#?}");
}
