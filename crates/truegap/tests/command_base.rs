//! `[base] model = "command"`: the reference clients against the formula and the base model `linear`, and programs that fail in every way.

#![allow(clippy::unwrap_used)]

use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::atomic::AtomicBool;
use std::time::{Duration, Instant};
use truegap::core::{Recording, SimulationError};
use truegap::diagnosis::{Diagnosed, DiagnosisError, Request, diagnose, open};
use truegap::models::{ModelFile, Programs, base_model, base_model_with};

const CLIENTS: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs/clients");

/// Whether a program can be run here; where it cannot, the test says what it did not try.
fn there_is(program: &str) -> bool {
    let there = Command::new(program).arg("--version").output().is_ok();
    if !there {
        eprintln!("NOT TESTED: there is no `{program}` on this machine, so no client that needs it was run");
    }
    there
}

/// Between 0 and 1, without any tone: splitmix64 (Steele, Lea & Flood 2014).
fn scattered(row: u64) -> f64 {
    let mixed = |z: u64, shift: u32, by: u64| (z ^ (z >> shift)).wrapping_mul(by);
    let z = mixed(row.wrapping_mul(0x9e37_79b9_7f4a_7c15), 30, 0xbf58_476d_1ce4_e5b9);
    let z = mixed(z, 27, 0x94d0_49bb_1331_11eb);
    ((z ^ (z >> 31)) >> 11) as f64 / (1u64 << 53) as f64
}

/// A spring of 2 N/mm and 1 mm, read without any noise but 1 um of dither, beside a program.
fn recording(folder: &Path, base: &str) -> Recording {
    let row = |i: usize| {
        let force = 5.0 + 5.0 * (i as f64 / 11.0).sin();
        let dither = 1e-3 * (scattered(i as u64) - 0.5);
        format!("{i},{force},{}\n", 1.0 + force / 2.0 + dither)
    };
    let rows: String = (0..300).map(row).collect();
    std::fs::write(folder.join("r.csv"), format!("time_s,force_n,response_mm\n{rows}")).unwrap();
    let toml = format!("schema = \"truegap.recording/1\"\nfile = \"r.csv\"\n[base]\n{base}");
    std::fs::write(folder.join("r.toml"), toml).unwrap();
    Recording::open(folder.join("r.toml")).unwrap()
}

/// `[base]` of a program in its folder.
fn program(run: &str) -> String {
    let parameters = "[base.parameters]\nk = { value = 1.8, sd = 0.5, unit = \"N/mm\", low = 0.1 }\n\
                      rest = { value = 0.0, sd = 3.0, unit = \"mm\" }\n";
    format!("model = \"command\"\nrun = {run}\ntimeout = \"5 s\"\n{parameters}")
}

/// The program `sh -c script`; the same with a short time-out.
fn script(text: &str) -> String {
    program(&format!("[\"sh\", \"-c\", '''{text}''']")).replace("5 s", "400 ms")
}

fn diagnosed(recording: Recording) -> Result<Diagnosed, DiagnosisError> {
    let request = Request::default();
    let files = vec![("r.csv".to_owned(), recording.sha256.clone())];
    diagnose(open(vec![recording], &request)?, files, &request, &|_| (), &AtomicBool::new(false))
}

/// Calibrated by a diagnosis, then run from its model file.
fn answers_as_the_formula(folder: &Path, run: &str) {
    let diagnosed = diagnosed(recording(folder, &program(run))).unwrap();
    let diagnosis = &diagnosed.outcome.diagnosis;
    let [k, rest] = [0, 1].map(|i| diagnosis.base.parameters[i].value);
    assert!((k - 2.0).abs() < 1e-3 && (rest - 1.0).abs() < 1e-3, "k = {k}, rest = {rest}");
    assert_eq!(diagnosis.base.model, "command");
    assert!(diagnosis.findings.is_empty(), "{}", diagnosis.says);
    let file = diagnosed.model_file().unwrap();
    let model = ModelFile::parse(&file.to_toml().unwrap(), Path::new("augmented.toml")).unwrap().build().unwrap();
    let force = diagnosed.recording.inputs.force_n.as_ref().unwrap();
    let response = model.respond(&diagnosed.recording.inputs).unwrap();
    for (value, force) in response.iter().zip(force) {
        assert!((value - (rest + force / k)).abs() < 1e-8, "{value}");
    }
}

#[test]
fn the_client_in_python_answers_as_the_formula() {
    if !there_is("python3") {
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    std::fs::copy(Path::new(CLIENTS).join("spring.py"), folder.path().join("spring.py")).unwrap();
    answers_as_the_formula(folder.path(), "[\"python3\", \"spring.py\"]");
}

#[test]
fn the_client_in_c_answers_as_the_formula() {
    if !there_is("cc") {
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    let source: PathBuf = Path::new(CLIENTS).join("spring.c");
    let built = Command::new("cc").arg(source).arg("-o").arg(folder.path().join("spring")).status().unwrap();
    assert!(built.success());
    answers_as_the_formula(folder.path(), "[\"./spring\"]");
}

/// Why the first question to a program has no answer.
fn failure(base: &str) -> String {
    let folder = tempfile::tempdir().unwrap();
    let recording = recording(folder.path(), base);
    let model = base_model(&recording).unwrap().simulator;
    let error = model.respond(&model.centre(), &recording.inputs, &[]).unwrap_err();
    assert!(matches!(error, SimulationError::Program { .. }), "{error:?}");
    // what failed stays failed, and at once
    let start = Instant::now();
    assert_eq!(model.respond(&[2.0, 0.0], &recording.inputs, &[]), Err(error.clone()));
    assert!(start.elapsed() < Duration::from_millis(100));
    error.to_string()
}

#[test]
fn a_program_that_fails_is_told_with_its_own_last_words() {
    let missing = failure(&program("[\"truegap-no-such-program\"]"));
    assert!(missing.contains("cannot be started") && missing.contains("truegap-no-such-program"), "{missing}");
    let crashed = failure(&script("read hello; echo truegap 1; read inputs; echo no licence for the solver >&2; exit 3"));
    assert!(crashed.contains("ended before it answered (exit status: 3)") && crashed.contains("| no licence"), "{crashed}");
    let late = failure(&script("read hello; echo truegap 1; echo still meshing >&2; sleep 20"));
    assert!(late.contains("gave no answer in 0.4 s") && late.contains("| still meshing"), "{late}");
    let chatty = failure(&script("read hello; echo Loading ...; sleep 20"));
    assert!(
        chatty.contains("wrote `Loading ...` where `truegap 1` was due") && chatty.contains("nothing to standard error"),
        "{chatty}"
    );
    let other = failure(&script("read hello; echo truegap 1; read inputs; echo answer 3; sleep 20"));
    assert!(other.contains("wrote `answer 3` where `answer 300` was due"), "{other}");
    let words = failure(&script("read hello; echo truegap 1; read inputs; echo answer 300; echo 1.5; echo abc; sleep 20"));
    assert!(words.contains("wrote `abc` where `number 2 of 300` was due"), "{words}");
    let told = failure(&script("read hello; echo truegap 1; read inputs; echo fail mesh has no cells; sleep 20"));
    assert!(told.contains("failed: mesh has no cells"), "{told}");
}

/// More rows than a pipe holds, and a program that reads none of them.
#[test]
fn a_program_that_does_not_read_is_not_waited_for() {
    let folder = tempfile::tempdir().unwrap();
    let mut recording = recording(folder.path(), &script("read hello; echo truegap 1; sleep 20"));
    recording = recording.select(&(0..300).cycle().take(30_000).collect::<Vec<_>>());
    let model = base_model(&recording).unwrap().simulator;
    let start = Instant::now();
    let error = model.respond(&model.centre(), &recording.inputs, &[]).unwrap_err().to_string();
    assert!(error.contains("gave no answer in 0.4 s") && start.elapsed() < Duration::from_secs(5), "{error}");
    drop(model);
    assert!(start.elapsed() < Duration::from_secs(5));
}

#[test]
fn no_answer_at_some_values_is_no_failure() {
    let folder = tempfile::tempdir().unwrap();
    let recording = recording(
        folder.path(),
        &script("read hello; echo truegap 1; while read word rest; do [ $word = ask ] && echo refuse; done"),
    );
    let model = base_model(&recording).unwrap().simulator;
    let refused = |values: &[f64]| model.respond(values, &recording.inputs, &[]).unwrap_err();
    assert!(matches!(refused(&[2.0, 0.0]), SimulationError::NotFinite { row: 0, .. }));
    assert!(matches!(refused(&[3.0, 0.0]), SimulationError::NotFinite { .. }));
}

/// It was told as "row 0", with the bare numbers.
#[test]
fn no_answer_at_all_is_told_with_the_names_of_what_was_asked() {
    let folder = tempfile::tempdir().unwrap();
    let refusing = script("read hello; echo truegap 1; while read word rest; do [ $word = ask ] && echo refuse; done");
    let told = diagnosed(recording(folder.path(), &refusing)).err().unwrap().to_string();
    assert!(told.contains("row 1: `command` has no finite response there with k = 1.8 N/mm, rest = 0 mm;"), "{told}");
}

/// A program that works for a while: what was found until then is not told as an answer.
#[test]
fn a_diagnosis_ends_with_the_program_that_it_asks() {
    if !there_is("python3") {
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    let client = std::fs::read_to_string(Path::new(CLIENTS).join("spring.py")).unwrap();
    let client = client.replace(
        "    elif word == \"ask\":\n",
        "    elif word == \"ask\":\n        calls += 1\n        assert calls < 40, \"licence expired\"\n",
    );
    std::fs::write(folder.path().join("spring.py"), client.replace("inputs = {}\n", "inputs, calls = {}, 0\n")).unwrap();
    let error = diagnosed(recording(folder.path(), &program("[\"python3\", \"spring.py\"]"))).err().unwrap().to_string();
    assert!(error.contains("r.toml") && error.contains("AssertionError: licence expired"), "{error}");
}

#[test]
fn what_is_wrong_under_base_is_told_by_name() {
    let folder = tempfile::tempdir().unwrap();
    let fails = |base: &str| base_model(&recording(folder.path(), base)).err().unwrap().to_string();
    assert!(fails("model = \"command\"\n").contains("run = [\"python3\", \"sim.py\"]"));
    assert!(fails("model = \"command\"\nrun = \"sim\"\n").contains("under [base], run = \"sim\" is not known"));
    assert!(fails("model = \"function\"\n").contains("docs/python.md"));
}

/// A slow program is asked once for what does not change: not by another diagnosis, and again where its file is another one.
#[test]
fn what_a_slow_program_has_answered_is_known_the_next_time() {
    if !there_is("python3") {
        return;
    }
    let (folder, cache) = (tempfile::tempdir().unwrap(), tempfile::tempdir().unwrap());
    let client = std::fs::read_to_string(Path::new(CLIENTS).join("spring.py")).unwrap();
    let write = |by: &str| {
        let slow =
            client.replace("    elif word == \"ask\":\n", &format!("    elif word == \"ask\":\n        time.sleep({by})\n"));
        std::fs::write(folder.path().join("spring.py"), slow.replace("import sys", "import sys, time")).unwrap();
    };
    let recording = recording(folder.path(), &program("[\"python3\", \"spring.py\"]"));
    let ask = |folder: Option<&Path>| {
        let programs = Programs::keeping(folder.map(Path::to_owned));
        let model = base_model_with(&recording, &programs).unwrap().simulator;
        let values = [[2.0, 0.0], [2.0, 1.0], [3.0, 0.0]];
        let answers = values.map(|values| model.respond(&values, &recording.inputs, &[]).unwrap());
        (answers, programs.calls())
    };
    write("0.03");
    let (first, calls) = ask(Some(cache.path()));
    assert_eq!((calls.count, calls.found), (3, 0));
    let (second, calls) = ask(Some(cache.path()));
    assert_eq!((calls.count, calls.found, second == first), (0, 3, true));
    assert_eq!(ask(None).1.count, 3);
    write("0.031");
    assert_eq!(ask(Some(cache.path())).1.count, 3);
}
