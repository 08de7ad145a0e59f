//! The same bytes whatever the number of threads, the folder, the language and the time zone; a folder of results whole whatever kills the program.

#![allow(clippy::unwrap_used)]

mod common;

use common::Bench;
use std::collections::BTreeMap;
use std::path::Path;
use std::process::{Command, Stdio};
use std::time::Duration;
use truegap_attack::list::material::{HEADER, csv};

const DIAGNOSE: &[&str] =
    &["-q", "diagnose", "r.csv", "--sensor", "singletact-s15-4.5n", "--effects", "offset_drift", "-o", "out"];
/// The whole library, on the built-in recording.
const WHOLE: &[&str] = &["-q", "diagnose", "example", "-o", "out"];
/// A diagnosis of a tenth of a second, to be killed and raced.
const SHORT: &[&str] =
    &["-q", "diagnose", "r.csv", "--base", "linear", "--effects", "offset_drift", "--library-only", "-o", "out"];
const STUDIES: [&[&str]; 3] = [
    &["-q", "sensitivity", "--rows", "128", "-o", "out"],
    &["-q", "tolerance", "--samples", "3000", "-o", "out"],
    &["-q", "optimise", "--searches", "1", "-o", "out"],
];

/// Threads and what else must not matter.
const SURROUNDINGS: [(&str, &str, &str); 3] =
    [("1", "C", "UTC"), ("2", "de_DE.UTF-8", "Asia/Kolkata"), ("7", "tr_TR.UTF-8", "America/St_Johns")];

/// A recording in which something is missing from the model: a reading that rises by itself.
fn drifting() -> String {
    let rows = csv(HEADER);
    let mut lines = rows.lines();
    let header = format!("{}\n", lines.next().unwrap());
    lines.enumerate().fold(header, |text, (row, line)| {
        let (inputs, reading) = line.rsplit_once(',').unwrap();
        let reading = reading.parse::<f64>().unwrap() - 2.0 * inputs.split(',').nth(1).unwrap().parse::<f64>().unwrap();
        text + &format!("{inputs},{:.5}\n", reading + 0.002 * row as f64)
    })
}

/// Every file below a folder, without what says how long something took.
fn files(folder: &Path, below: &str, into: &mut BTreeMap<String, String>) {
    for entry in std::fs::read_dir(folder).unwrap() {
        let entry = entry.unwrap();
        let name = format!("{below}{}", entry.file_name().to_str().unwrap());
        if entry.path().is_dir() {
            files(&entry.path(), &format!("{name}/"), into);
        } else {
            let text = String::from_utf8_lossy(&std::fs::read(entry.path()).unwrap()).into_owned();
            let timeless = |line: &&str| !(line.contains("\"seconds\":") || line.contains("<td>took</td>"));
            into.insert(name, text.lines().filter(timeless).collect::<Vec<_>>().join("\n"));
        }
    }
}

fn made(typed: &[&str], (threads, language, zone): (&str, &str, &str)) -> BTreeMap<String, String> {
    let bench = Bench::new();
    bench.file("r.csv", &drifting());
    let status = Command::new(env!("CARGO_BIN_EXE_truegap"))
        .args(typed)
        .current_dir(bench.path("."))
        .envs([("RAYON_NUM_THREADS", threads), ("LC_ALL", language), ("LANG", language), ("TZ", zone)])
        .stdout(Stdio::null())
        .status()
        .unwrap();
    assert!(matches!(status.code(), Some(0 | 1)), "{typed:?}: {status}");
    let mut all = BTreeMap::new();
    files(&bench.path("out"), "", &mut all);
    all
}

#[test]
fn nothing_but_the_input_matters() {
    for typed in STUDIES.into_iter().chain([DIAGNOSE, WHOLE]) {
        let [first, others @ ..] = SURROUNDINGS.map(|surroundings| made(typed, surroundings));
        assert!(first.len() > 2, "{typed:?} wrote {:?}", first.keys());
        for other in others {
            assert_eq!(first.keys().collect::<Vec<_>>(), other.keys().collect::<Vec<_>>(), "{typed:?}");
            for (name, text) in &first {
                // two runs may begin in different minutes
                let [one, two] =
                    [text, &other[name]].map(|text| text.lines().filter(|l| !l.contains("<td>made</td>")).collect::<Vec<_>>());
                let line = one.iter().zip(&two).find(|(one, two)| one != two);
                assert!(line.is_none() && one.len() == two.len(), "{typed:?}: {name}: {line:?}");
            }
        }
    }
}

fn start(bench: &Bench) -> std::process::Child {
    let mut command = Command::new(env!("CARGO_BIN_EXE_truegap"));
    command.args(SHORT).current_dir(bench.path(".")).stdout(Stdio::null()).stderr(Stdio::null()).spawn().unwrap()
}

/// Whether the folder holds a whole answer.
fn is_whole(bench: &Bench) -> bool {
    let text = |name: &str| std::fs::read_to_string(bench.path("out").join(name)).unwrap_or_default();
    text("diagnosis.json").trim_end().ends_with('}')
        && text("report.html").trim_end().ends_with("</html>")
        && text("prediction.csv").lines().count() == 201
        && text("augmented.toml").contains("truegap.model/1")
}

#[cfg(unix)]
#[test]
fn a_killed_run_leaves_the_earlier_answer_whole() {
    let bench = Bench::new();
    bench.file("r.csv", &drifting());
    let begin = std::time::Instant::now();
    assert_eq!(start(&bench).wait().unwrap().code(), Some(1));
    let whole = begin.elapsed();
    assert!(is_whole(&bench));
    // most moments near the end, where the folder changes
    for share in [0.1, 0.5, 0.8, 0.9, 0.95, 0.98, 1.0, 1.02, 1.05] {
        let mut child = start(&bench);
        std::thread::sleep(Duration::from_secs_f64(share * whole.as_secs_f64()));
        let _ = child.kill(); // it may have ended by itself
        child.wait().unwrap();
        assert!(is_whole(&bench), "killed after {share} of {whole:?}");
    }
}

#[test]
fn two_runs_into_one_folder_leave_one_whole_answer() {
    let bench = Bench::new();
    bench.file("r.csv", &drifting());
    let children = [start(&bench), start(&bench)];
    let codes = children.map(|mut child| child.wait().unwrap().code());
    assert!(codes.contains(&Some(1)) && codes.iter().all(|code| matches!(code, Some(1 | 2))), "{codes:?}");
    assert!(is_whole(&bench));
    assert_eq!(bench.names(), ["out", "r.csv"]);
}
