//! Shards against the whole, and what a killed process leaves behind.

#![allow(clippy::unwrap_used)]

use serde::{Deserialize, Serialize};
use std::collections::BTreeSet;
use std::fs;
use std::path::Path;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use truegap_sweep::{Control, Progress, Shard, Sweep, SweepError, describe, write_atomically, write_once};

#[derive(Clone, Debug, Serialize, PartialEq)]
struct Case {
    seed: u64,
    scale: f64,
}

#[derive(Clone, Debug, Serialize, Deserialize, PartialEq)]
struct Answer {
    root: f64,
    words: Vec<String>,
}

fn sweep(scale: f64) -> Sweep<Case> {
    let cases = (0..41).map(|seed| Case { seed, scale }).collect();
    Sweep::new("test/1", &serde_json::json!({"what": "roots"}), cases).unwrap()
}

fn solve(case: &Case) -> Result<Answer, String> {
    Ok(Answer { root: (case.seed as f64 / case.scale).sqrt(), words: vec![format!("seed {}", case.seed)] })
}

/// Every file of a folder below `cases`, by name and content.
fn bytes(folder: &Path) -> Vec<(String, Vec<u8>)> {
    let mut all: Vec<_> = fs::read_dir(folder.join("cases"))
        .unwrap()
        .map(|e| e.unwrap().path())
        .map(|p| (p.file_name().unwrap().to_string_lossy().into_owned(), fs::read(&p).unwrap()))
        .collect();
    all.sort();
    all
}

fn run(folder: &Path, of: usize) {
    for index in (1..=of).rev() {
        sweep(3.0).run(folder, Shard::new(index, of).unwrap(), Control::default(), solve).unwrap();
    }
}

#[test]
fn any_number_of_shards_leaves_the_same_bytes_and_the_same_answers() {
    let place = tempfile::tempdir().unwrap();
    let folders = [1, 2, 16].map(|of| (of, place.path().join(of.to_string())));
    for (of, folder) in &folders {
        run(folder, *of);
    }
    let known: Vec<Answer> = sweep(3.0).cases().iter().map(|c| solve(c).unwrap()).collect();
    let (_, one) = &folders[0];
    for (_, folder) in &folders {
        assert_eq!(bytes(folder), bytes(one));
        assert_eq!(fs::read(folder.join("sweep.json")).unwrap(), fs::read(one.join("sweep.json")).unwrap());
        // bit for bit what was computed, though it went through text
        assert_eq!(sweep(3.0).merge::<Answer>(folder).unwrap().complete().unwrap(), known);
    }
    let memory = sweep(3.0).in_memory(Control::default(), solve).unwrap().1;
    assert_eq!(memory.into_iter().flatten().collect::<Vec<_>>(), known);
}

#[test]
fn a_killed_shard_loses_nothing_and_doubles_nothing() {
    let place = tempfile::tempdir().unwrap();
    let folder = place.path().join("killed");
    let computed = AtomicUsize::new(0);
    let counted = |case: &Case| {
        computed.fetch_add(1, Ordering::Relaxed);
        solve(case)
    };
    let sweep = sweep(3.0);
    sweep.run(&folder, Shard::new(1, 2).unwrap(), Control::default(), counted).unwrap();
    assert_eq!(computed.load(Ordering::Relaxed), 21);
    // what kill -9 leaves: a file begun and not renamed; and, from a disk that lied, one that is cut short
    let half = &bytes(&folder)[0];
    fs::write(folder.join("cases").join(format!("{}.7-0.part", half.0)), &half.1[..half.1.len() / 2]).unwrap();
    fs::write(folder.join("cases").join(&half.0), &half.1[..half.1.len() / 2]).unwrap();
    let missing = sweep.merge::<Answer>(&folder).unwrap_err();
    assert!(matches!(missing, SweepError::Damaged { .. }), "{missing}");
    let ran = sweep.run(&folder, Shard::WHOLE, Control::default(), counted).unwrap();
    assert_eq!((ran.found, ran.computed, ran.of), (20, 21, 41));
    assert_eq!(computed.load(Ordering::Relaxed), 21 + 1 + 20, "the one cut short, and the other half");
    let whole = place.path().join("whole");
    run(&whole, 1);
    let kept: Vec<_> = bytes(&folder).into_iter().filter(|(name, _)| name.ends_with(".json")).collect();
    assert_eq!(kept, bytes(&whole));
    assert_eq!(sweep.merge::<Answer>(&folder).unwrap().complete().unwrap().len(), 41);
}

#[test]
fn what_is_missing_is_named() {
    let place = tempfile::tempdir().unwrap();
    let sweep = sweep(3.0);
    sweep.run(place.path(), Shard::new(2, 2).unwrap(), Control::default(), solve).unwrap();
    let merged = sweep.merge::<Answer>(place.path()).unwrap();
    assert_eq!((merged.answers.len(), merged.missing.len()), (20, 21));
    let told = merged.complete().unwrap_err().to_string();
    assert!(told.contains("21 of 41 cases are missing") && told.contains(&sweep.hashes()[0][..12]), "{told}");
}

#[test]
fn a_stopped_run_keeps_what_is_done_and_says_so() {
    let place = tempfile::tempdir().unwrap();
    let (stop, told) = (AtomicBool::new(false), AtomicUsize::new(0));
    let progress = |p: Progress| {
        assert!(p.done <= p.of && p.of == 41);
        if told.fetch_add(1, Ordering::Relaxed) == 5 {
            stop.store(true, Ordering::Relaxed);
        }
    };
    let control = Control { progress: Some(&progress), cancel: Some(&stop) };
    let ran = sweep(3.0).run(place.path(), Shard::WHOLE, control, solve).unwrap();
    assert!(ran.cancelled && ran.computed >= 5 && ran.computed < 41, "{ran:?}");
    assert_eq!(bytes(place.path()).len(), ran.computed);
    let rest = sweep(3.0).run(place.path(), Shard::WHOLE, Control::default(), solve).unwrap();
    assert_eq!((rest.found, rest.found + rest.computed, rest.cancelled), (ran.computed, 41, false));
}

#[test]
fn a_case_without_an_answer_is_listed_and_tried_again() {
    let place = tempfile::tempdir().unwrap();
    let odd = |case: &Case| if case.seed == 7 { Err("seven has none".to_owned()) } else { solve(case) };
    let ran = sweep(3.0).run(place.path(), Shard::WHOLE, Control::default(), odd).unwrap();
    assert_eq!((ran.failed.as_slice(), ran.cancelled), (&[(7, "seven has none".to_owned())][..], false));
    assert_eq!(sweep(3.0).run(place.path(), Shard::WHOLE, Control::default(), solve).unwrap().computed, 1);
}

#[test]
fn another_sweep_is_kept_out_of_the_folder() {
    let place = tempfile::tempdir().unwrap();
    sweep(3.0).run(place.path(), Shard::WHOLE, Control::default(), solve).unwrap();
    let other = sweep(4.0).run(place.path(), Shard::WHOLE, Control::default(), solve);
    assert!(matches!(other, Err(SweepError::OtherSweep { .. })));
    assert_eq!(describe(place.path()).unwrap().context["what"], "roots");
    assert!(matches!(sweep(3.0).merge::<Answer>(&place.path().join("none")), Err(SweepError::NoSweep { .. })));
}

#[test]
fn names_depend_on_study_context_and_case_and_on_nothing_else() {
    let name = |study: &str, context: &str, scale: f64| {
        Sweep::new(study, &context, vec![Case { seed: 1, scale }]).unwrap().hashes()[0].clone()
    };
    let known = name("a/1", "c", 1.0);
    assert_eq!(known, name("a/1", "c", 1.0));
    let others = BTreeSet::from([known, name("a/2", "c", 1.0), name("a/1", "d", 1.0), name("a/1", "c", 1.0 + 1e-16 * 3.0)]);
    assert_eq!(others.len(), 4);
    let twice = Sweep::new("a/1", &"c", vec![1, 2, 1]);
    assert!(matches!(twice, Err(SweepError::Twice { first: 0, second: 2, .. })));
    assert!(matches!(Sweep::<u8>::new("a/1", &"c", vec![]), Err(SweepError::Empty { .. })));
}

#[test]
fn a_result_that_json_cannot_hold_is_an_error_and_leaves_no_file() {
    let place = tempfile::tempdir().unwrap();
    let bad = |_: &Case| Ok::<_, String>(Answer { root: f64::NAN, words: vec![] });
    assert!(matches!(sweep(3.0).run(place.path(), Shard::WHOLE, Control::default(), bad), Err(SweepError::Unwritable { .. })));
    assert!(!place.path().join("cases").exists());
}

#[test]
fn a_file_that_is_written_once_is_never_replaced() {
    let place = tempfile::tempdir().unwrap();
    let file = place.path().join("a.toml");
    write_once(&file, b"one").unwrap();
    let again = write_once(&file, b"two").unwrap_err();
    assert!(matches!(&again, SweepError::Disk { source, .. } if source.kind() == std::io::ErrorKind::AlreadyExists), "{again}");
    assert_eq!(fs::read(&file).unwrap(), b"one");
    assert_eq!(fs::read_dir(place.path()).unwrap().count(), 1);
}

#[test]
fn a_file_is_replaced_whole() {
    let place = tempfile::tempdir().unwrap();
    let file = place.path().join("a/b.json");
    write_atomically(&file, b"one").unwrap();
    write_atomically(&file, b"two").unwrap();
    assert_eq!(fs::read(&file).unwrap(), b"two");
    assert_eq!(fs::read_dir(place.path().join("a")).unwrap().count(), 1);
}
