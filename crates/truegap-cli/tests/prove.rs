//! A blind study end to end, and what a study must refuse.

#![allow(clippy::unwrap_used)]

mod common;

use common::Bench;
use serde_json::Value;
use std::fs;

const STUDY: [&str; 9] = ["prove", "--cases", "3", "--seed", "7", "--protocols", "short", "-o", "s"];

fn json(path: std::path::PathBuf) -> Value {
    serde_json::from_str(&fs::read_to_string(path).unwrap()).unwrap()
}

#[test]
fn three_cases_are_sealed_diagnosed_and_scored_and_whatever_is_altered_is_refused() {
    let bench = Bench::new();
    let said = bench.run(&STUDY);
    assert!(said.code == 0 || said.code == 1, "{}", said.err);
    let commitments = fs::read_to_string(bench.path("s/commitments.txt")).unwrap();
    // answer, CSV and TOML of each case, and the plan
    assert_eq!(commitments.lines().count(), 3 * 3 + 1);
    assert!(said.out.starts_with(&commitments) && said.out.contains("false alarms, all nulls"), "{}", said.out);

    // the counts are those of the answers in the key and of the diagnoses, read here a second time
    let score = json(bench.path("s/score.json"));
    let (mut nulls, mut agreeing) = (0, 0);
    for case in ["case-001", "case-002", "case-003"] {
        let answer = json(bench.path(&format!("s/key/{case}.json")));
        let diagnosis = json(bench.path(&format!("s/diagnoses/{case}/diagnosis.json")));
        let null = answer["effects"].as_array().unwrap().is_empty() && answer["stranger"].is_null();
        nulls += usize::from(null);
        agreeing += usize::from(diagnosis["verdict"] == "agrees");
    }
    let row = |says: &str| score["targets"].as_array().unwrap().iter().find(|r| r["says"] == says).unwrap().clone();
    assert_eq!(row("false alarms, all nulls")["of"], nulls);
    assert_eq!(score["cases"].as_array().unwrap().iter().filter(|c| c["verdict"] == "agrees").count(), agreeing);
    assert_eq!(row("seconds for a diagnosis (median)")["of"], 3);
    assert_eq!(score["controls"].as_array().unwrap().len(), 4);
    assert!(fs::read_to_string(bench.path("s/score.md")).unwrap().contains("--cases 3 --seed 7"));

    // a line for each file that was said, and the hash of the diagnosis' own recording in both
    let answers = fs::read_to_string(bench.path("s/answers.txt")).unwrap();
    assert_eq!(answers.lines().count(), 3 * 3);
    let said_of = json(bench.path("s/diagnoses/case-002/diagnosis.json"));
    assert_eq!(said_of["recording"]["sha256"], hash(&commitments, "case-002/recording.csv"));
    assert!(fs::read_to_string(bench.path("s/score.md")).unwrap().contains(score["answers_sha256"].as_str().unwrap()));
    goes_on(&bench, said.code, &score);
    refuses_what_was_changed(&bench);
    refuses_what_was_changed_before_the_score(&bench);
}

/// The hash that a list has for a file.
fn hash<'a>(list: &'a str, file: &str) -> &'a str {
    let line = list.lines().find(|line| line.ends_with(&format!("  {file}"))).unwrap();
    line.split_once("  ").unwrap().0
}

/// Only what is missing is diagnosed again: broken off in the second case, between its diagnosis and the line that says so.
fn goes_on(bench: &Bench, code: i32, score: &Value) {
    unscored(bench);
    let answers = fs::read_to_string(bench.path("s/answers.txt")).unwrap();
    fs::write(bench.path("s/answers.txt"), without(&answers, "case-002")).unwrap();
    let written =
        |case: &str| fs::metadata(bench.path(&format!("s/diagnoses/{case}/diagnosis.json"))).unwrap().modified().unwrap();
    let kept = ["case-001", "case-002"].map(written);
    let again = bench.run(&["prove", "--resume", "--json", "-o", "s"]);
    assert_eq!(again.code, code, "{}", again.err);
    let told: Value = serde_json::from_str(&again.out).unwrap();
    assert_eq!(told["commitments_sha256"], score["commitments_sha256"]);
    let now = ["case-001", "case-002"].map(written);
    assert!(now[0] == kept[0] && now[1] > kept[1]);
}

fn unscored(bench: &Bench) {
    for file in ["s/score.json", "s/score.md"] {
        fs::remove_file(bench.path(file)).unwrap();
    }
}

fn without(list: &str, word: &str) -> String {
    list.lines().filter(|line| !line.contains(word)).fold(String::new(), |text, line| text + line + "\n")
}

const RESUME: [&str; 6] = ["prove", "--resume", "-q", "--json", "-o", "s"];

/// Changes a file (nothing: takes it away), expects a refusal with these words, and puts it back.
fn refuses(bench: &Bench, file: &str, change: impl Fn(&str) -> Option<String>, words: &[&str]) {
    let path = bench.path(file);
    let right = fs::read_to_string(&path).ok();
    match change(right.as_deref().unwrap_or_default()) {
        Some(text) => fs::write(&path, text).unwrap(),
        None => fs::remove_file(&path).unwrap(),
    }
    bench.refuses(&RESUME, words);
    match right {
        Some(text) => fs::write(&path, text).unwrap(),
        None => fs::remove_file(&path).unwrap(),
    }
}

fn refuses_what_was_changed(bench: &Bench) {
    let read = |file: &str| fs::read_to_string(bench.path(file)).unwrap();
    let altered = |file: &str, list: &str| {
        [file.to_owned(), "SHA-256 is".to_owned(), format!("altered after {list} was written: put it back")]
    };
    let changed = |file: &str, line: &str, list: &str, change: &dyn Fn(&str) -> Option<String>| {
        let words = altered(line, list);
        refuses(bench, &format!("s/{file}"), change, &[&words[0], &words[1], &words[2]]);
    };
    let commitments =
        |file: &str, line: &str, change: &dyn Fn(&str) -> Option<String>| changed(file, line, "commitments.txt", change);
    commitments("key/case-002.json", "case-002.json", &|t| Some(t.replacen("\"detectability\": ", "\"detectability\": 1", 1)));
    commitments("key/plan.json", "plan.json", &|t| Some(t.replace("\"cases\": 3", "\"cases\": 2")));
    commitments("key/plan.json", "plan.json", &|t| Some(t.replace("\"seed\": 7", "\"seed\": 8")));
    commitments("case-001/recording.csv", "case-001/recording.csv", &|t| Some(t.replacen("1,", "2,", 1)));
    commitments("case-001/recording.csv", "case-001/recording.csv", &|_| Some(read("s/case-002/recording.csv")));
    commitments("case-003/recording.toml", "case-003/recording.toml", &|t| Some(t.replace("warp = ", "warp =  ")));
    let answers = |change: &dyn Fn(&str) -> Option<String>| {
        changed("diagnoses/case-001/diagnosis.json", "diagnoses/case-001/diagnosis.json", "answers.txt", change);
    };
    answers(&|t| Some(t.replacen("\"verdict\"", "\"verdict \"", 1)));
    answers(&|_| Some(read("s/diagnoses/case-002/diagnosis.json")));
    let refuses = |file: &str, change: &dyn Fn(&str) -> Option<String>, words: &[&str]| refuses(bench, file, change, words);
    refuses(
        "s/commitments.txt",
        &|t| t.lines().next().map(|line| format!("{line}\n")),
        &["commitments.txt: no line for plan.json"],
    );
    refuses(
        "s/commitments.txt",
        &|t| Some(without(t, "case-003")),
        &["commitments.txt: no line for case-003.json", "put commitments.txt back"],
    );
    refuses(
        "s/commitments.txt",
        &|t| Some(format!("{t}{}  case-004/recording.csv\n", hash(t, "case-001/recording.csv"))),
        &["case-004/recording.csv"],
    );
    refuses("s/commitments.txt", &|t| Some(t[..t.len() - 20].to_owned()), &["commitments.txt"]);
    refuses("s/commitments.txt", &|_| None, &["commitments.txt is gone", "put it back"]);
    refuses(
        "s/key/plan.json",
        &|_| None,
        &["no key/plan.json", "put the plan back", "leave --resume out and give -o a folder that is new"],
    );
    refuses("s/key/case-001.json", &|_| None, &["case-001.json", "put it back where it is gone"]);
    refuses("s/case-001/without.txt", &|_| Some("thermal_lag".into()), &["without.txt", "take it away"]);
    refuses("s/diagnoses/case-001/refused.txt", &|_| Some("too hard".into()), &["refused.txt", "take it away"]);
    refuses("s/diagnoses/case-001/controls.json", &|_| None, &["controls.json", "put it back where it is gone"]);
    refuses(
        "s/answers.txt",
        &|_| None,
        &["answers.txt", "is not what score.json was counted from", "--resume answers all of it again"],
    );
    refuses("s/answers.txt", &|t| Some(without(t, "case-003")), &["is not what score.json was counted from"]);
    // all is as it was, so it is scored as it was
    let score = read("s/score.json");
    bench.run(&RESUME);
    assert_eq!(read("s/score.json"), score);
}

/// A diagnosis copied to another case, with its hashes: it says which recording it answers.
fn refuses_what_was_changed_before_the_score(bench: &Bench) {
    unscored(bench);
    let list = fs::read_to_string(bench.path("s/answers.txt")).unwrap();
    for file in ["diagnosis.json", "controls.json"] {
        let at = |case: &str| bench.path(&format!("s/diagnoses/{case}/{file}"));
        fs::copy(at("case-001"), at("case-003")).unwrap();
    }
    let copied = list.lines().map(|line| match line.split_once("case-003/") {
        Some((_, file)) if file != "augmented.toml" => {
            format!("{}  diagnoses/case-003/{file}", hash(&list, &format!("diagnoses/case-001/{file}")))
        }
        _ => line.to_owned(),
    });
    let copied: Vec<String> = copied.collect();
    fs::write(bench.path("s/answers.txt"), copied.join("\n") + "\n").unwrap();
    bench.refuses(&RESUME, &["diagnoses/case-003/diagnosis.json", "answers another recording than case-003/recording.csv"]);
}

#[test]
fn a_study_is_not_begun_where_something_lies_nor_gone_on_with_where_there_is_none() {
    let bench = Bench::new();
    fs::create_dir(bench.path("s")).unwrap();
    bench.refuses(&["prove", "--resume", "-o", "s"], &["no study", "leave --resume out"]);
    fs::write(bench.path("s/thesis.tex"), "mine").unwrap();
    bench.refuses(&STUDY, &["thesis.tex", "no study", "give -o a folder that is new"]);
    bench.refuses(
        &["prove", "--resume", "-o", "s"],
        &["thesis.tex", "put the plan back", "leave --resume out and give -o a folder that is new"],
    );
    let none = bench.run(&["prove", "--cases", "0", "-o", "new"]);
    assert!(none.code == 2 && none.err.contains("'--cases <N>': 0 is not in 1..=100000"), "{}", none.err);
    assert!(!bench.path("new").exists());
}
