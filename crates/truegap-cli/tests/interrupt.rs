//! Ctrl-C in the middle of a diagnosis: a report of what is known by then.
//!
//! The signal is sent to the built program by `kill -INT`, once its first note shows that it has begun; the recording is long enough to keep it
//! busy for some seconds.

#![cfg(unix)]
#![allow(clippy::unwrap_used)]

mod common;

use common::Bench;
use std::io::{BufRead, BufReader, Read};
use std::process::{Command, Stdio};

/// The built-in example many times over, a run after another.
fn long_recording() -> String {
    let example = truegap::diagnosis::example_recording().unwrap();
    let (time, force) = (example.inputs.time_s.as_ref().unwrap(), example.inputs.force_n.as_ref().unwrap());
    let temperature = example.inputs.temperature_c.as_ref().unwrap();
    let mut text = String::from("run,time_s,force_n,temperature_c,capacitance_pf\n");
    for again in 0..12u32 {
        let later = f64::from(again) * 20_000.0;
        for row in 0..example.len() {
            let run = example.inputs.run[row] + 10 * again;
            let reading = example.response[row] + 1e-3 * f64::from(again % 3);
            text += &format!("{run},{:.3},{:.4},{:.3},{reading:.5}\n", time[row] + later, force[row], temperature[row]);
        }
    }
    text
}

#[test]
fn ctrl_c_leaves_a_report_of_what_is_known() {
    let bench = Bench::new();
    bench.file("long.csv", &long_recording());
    // a note is printed when the recording has been read
    bench.file("long.toml", "");
    let mut program = Command::new(env!("CARGO_BIN_EXE_truegap"))
        .args(["diagnose", "long.csv", "--sensor", "singletact-s15-4.5n", "-o", "out"])
        .current_dir(bench.path("."))
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    let mut lines = BufReader::new(program.stderr.take().unwrap()).lines();
    let first = lines.next().unwrap().unwrap();
    assert!(first.starts_with("note:"), "{first}");
    let kill = Command::new("kill").args(["-INT", &program.id().to_string()]).status().unwrap();
    assert!(kill.success());
    let rest: Vec<String> = lines.map(|line| line.unwrap()).collect();
    assert_eq!(rest.iter().filter(|line| line.starts_with("stopping")).count(), 1, "{rest:?}");
    let status = program.wait().unwrap();
    let mut out = String::new();
    program.stdout.take().unwrap().read_to_string(&mut out).unwrap();
    // 128 + SIGINT: 1 would say that something was found, and a script could not tell the two apart
    assert_eq!(status.code(), Some(130), "{out}");
    // what was not looked for to the end is not said to be absent
    assert!(!out.contains("nothing is missing"), "{out}");
    let json = std::fs::read_to_string(bench.path("out/diagnosis.json")).unwrap();
    let diagnosis: serde_json::Value = serde_json::from_str(&json).unwrap();
    assert_eq!(diagnosis["verdict"], "undecided");
    assert!(diagnosis["says"].as_str().unwrap().contains("stopped"), "{}", diagnosis["says"]);
    let next = diagnosis["next_experiment"]["says"].as_str().unwrap();
    assert!(next.contains("let the search end"), "{next}");
    assert_eq!(diagnosis["findings"].as_array().unwrap().len(), 0);
    // what is known by then: the calibrated base model and its errors
    assert!(diagnosis["base"]["parameters"].as_array().unwrap().iter().all(|p| p["sd"].as_f64().unwrap() > 0.0));
    assert!(diagnosis["fit"]["in_sample"]["rmse_before"].as_f64().unwrap() > 0.0);
    let page = std::fs::read_to_string(bench.path("out/report.html")).unwrap();
    assert!(page.contains("stopped before its end") && !page.contains("nothing is missing"));
}

/// Where a program answers slowly, what is known by then costs hundreds of questions more: it was asked them all the same.
#[test]
fn a_slow_program_is_asked_no_further_after_ctrl_c() {
    let bench = Bench::new();
    let client = include_str!("../../../docs/clients/spring.py");
    let slow = client.replace(
        "    elif word == \"ask\":\n",
        "    elif word == \"ask\":\n        time.sleep(0.03)\n        open(\"asked\", \"a\").write(\".\")\n",
    );
    bench.file("sim.py", &slow.replace("import sys", "import sys, time"));
    let load = |i: usize| 5.0 + 4.0 * (i as f64 / 9.0).sin();
    let rows: String =
        (0..200).map(|i| format!("{i},{},{}\n", load(i), 1.0 + 0.5 * load(i) + 1e-3 * ((i * 37 % 11) as f64))).collect();
    bench.file("b.csv", &format!("time_s,force_n,response_mm\n{rows}"));
    let base = "[base]\nmodel = \"command\"\nrun = [\"python3\", \"sim.py\"]\n[base.parameters]\nk = { value = 2.0, sd = 0.3 }\nrest = { value = 0.0, sd = 3.0 }\n";
    bench.file("b.toml", &format!("schema = \"truegap.recording/1\"\nfile = \"b.csv\"\n{base}"));
    let asked = || std::fs::read(bench.path("asked")).map_or(0, |dots| dots.len());
    let mut program = Command::new(env!("CARGO_BIN_EXE_truegap"))
        .args(["diagnose", "b.toml", "-o", "out", "--cache", "answers"])
        .current_dir(bench.path("."))
        .stdout(Stdio::null())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    while asked() < 20 {
        assert!(program.try_wait().unwrap().is_none(), "it ended before it was stopped");
        std::thread::sleep(std::time::Duration::from_millis(20));
    }
    let before = asked();
    assert!(Command::new("kill").args(["-INT", &program.id().to_string()]).status().unwrap().success());
    let mut told = String::new();
    program.stderr.take().unwrap().read_to_string(&mut told).unwrap();
    assert_eq!(program.wait().unwrap().code(), Some(130), "{told}");
    // one that was under way, and those of the twentieth of a second until it is seen
    assert!(asked() <= before + 10, "{} questions after {before}: {told}", asked());
    assert!(told.contains("asked no further, as the diagnosis was stopped; its answers are kept"), "{told}");
    assert!(!bench.path("out").exists());
}
