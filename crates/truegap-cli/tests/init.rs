//! `truegap init` on the command line, and a program as base model of what it wrote.

#![allow(clippy::unwrap_used)]

mod common;

use common::Bench;

#[test]
fn a_header_becomes_a_toml_that_is_diagnosed_once_its_base_is_named() {
    let bench = Bench::new();
    let row = |i: usize| {
        format!("{i},{},{}\n", 2.0 + (i as f64 / 9.0).sin(), 3.0 + (i as f64 / 9.0).sin() + 1e-3 * ((i * 37 % 11) as f64))
    };
    let rows: String = (0..120).map(row).collect();
    bench.file("bench.csv", &format!("Elapsed (s),Load cell [N],reading [mV]\n{rows}"));
    let said = bench.run(&["init", "bench.csv"]);
    assert_eq!((said.code, bench.names()), (0, vec!["bench.csv".to_owned(), "bench.toml".to_owned()]), "{}", said.err);
    assert!(
        said.out.contains("Written: bench.toml") && said.out.contains("Left to you: what the recording is compared with"),
        "{}",
        said.out
    );
    bench.refuses(&["init", "bench.csv"], &["bench.toml", "cannot be written"]);
    bench.refuses(&["-q", "diagnose", "bench.toml"], &["bench.toml", "--base linear"]);
    let text = std::fs::read_to_string(bench.path("bench.toml")).unwrap();
    // the line of the model without its table
    bench.file("bench.toml", &format!("{text}\nmodel = \"linear\"\n"));
    bench.refuses(&["-q", "diagnose", "bench.toml"], &["[units] has no key `model`", "under [base]"]);
    bench.file("bench.toml", &format!("{text}\n[base]\nmodel = \"linear\"\n"));
    let said = bench.run(&["-q", "--json", "diagnose", "bench.toml", "-o", "out"]);
    assert!(said.code < 2 && said.out.contains("\"unit\":\"mV\""), "{}{}", said.out, said.err);
    bench.file("bench.toml", &format!("{text}\n[base]\nmodel = \"command\"\nrun = [\"./no-such-program\"]\n"));
    bench.refuses(&["-q", "diagnose", "bench.toml", "-o", "none"], &["./no-such-program", "cannot be started"]);
}
