//! `truegap firmware` on the command line: exit codes, what is printed, and what is written.

#![allow(clippy::unwrap_used)]

mod common;

use common::{Bench, LATE_SIMULATION};
use serde_json::Value;

fn bench() -> Bench {
    let bench = Bench::new();
    bench.file("augmented.toml", LATE_SIMULATION);
    bench
}

#[test]
fn a_file_in_c_is_printed_or_written_and_told() {
    let bench = bench();
    let printed = bench.run(&["firmware", "augmented.toml"]);
    assert_eq!(printed.code, 0, "{}", printed.err);
    assert!(printed.out.starts_with("/* Written by `truegap firmware`"), "{}", printed.out);
    assert!(printed.err.contains("Corrects for readout lag"), "{}", printed.err);
    let written = bench.run(&["-q", "firmware", "augmented.toml", "-o", "correction.c", "--noise-growth", "5"]);
    assert_eq!((written.code, written.err.as_str()), (0, ""));
    assert!(written.out.contains("Corrects for readout lag") && written.out.contains("by a factor of 5.00"), "{}", written.out);
    let again = bench.run(&["-q", "firmware", "augmented.toml", "-o", "correction.c"]);
    assert_eq!(again.code, 0, "{}", again.err);
    assert_eq!(std::fs::read_to_string(bench.path("correction.c")).unwrap().trim_end(), printed.out.trim_end());
    let said = bench.run(&["-q", "--json", "firmware", "augmented.toml"]);
    let document: Value = serde_json::from_str(&said.out).unwrap();
    assert_eq!((document["schema"].as_str(), document["undone"]["tau_s"].as_f64()), (Some("truegap.firmware/1"), Some(2.0)));
}

#[test]
fn what_cannot_be_written_is_refused_before_the_work() {
    let bench = bench();
    bench.file("mine.c", "/* mine */\n");
    bench.refuses(&["-q", "firmware", "augmented.toml", "-o", "mine.c"], &["mine.c", "no earlier result of `truegap firmware`"]);
    bench.refuses(&["-q", "firmware", "augmented.toml", "-o", "mine.c/deeper.c"], &["mine.c"]);
    bench.refuses(&["-q", "firmware", "augmented.toml", "--range", "temperature"], &["--range temperature", "LOW:HIGH"]);
    bench.refuses(&["-q", "firmware", "augmented.toml", "--bytes", "4"], &["--bytes is 4", "32 to 1048576"]);
    bench.refuses(&["-q", "firmware", "mine.c"], &["mine.c", "model file"]);
}
