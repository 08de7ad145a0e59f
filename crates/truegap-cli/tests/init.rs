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
        said.out.contains("Written: bench.toml")
            && said.out.contains("Found: time = `Elapsed (s)`, force = `Load cell [N]`, response = `reading [mV]`")
            && said.out.contains("Left to you: what the recording is compared with"),
        "{}",
        said.out
    );
    // "entity already exists", and a full disk was advised to move what is there
    bench.refuses(&["init", "bench.csv"], &["bench.toml: is there already, and was left as it is; move it"]);
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

/// `init -` wrote a file called `-.toml`, and `/dev/stdin` was refused where it is a pipe.
#[test]
fn a_table_on_standard_input_is_diagnosed_and_described() {
    let bench = Bench::new();
    let rows: String = (0..60).map(|i| format!("{:02}/01/2026 12:00,{},{}\n", i % 12 + 1, i % 7, 3 * (i % 7) + i % 2)).collect();
    bench.file("dates.csv", &format!("time,force_n,response_mm\n{rows}"));
    let rows: String = (0..60).map(|i| format!("{i},{},{}\n", i % 7, 3 * (i % 7) + i % 2)).collect();
    bench.file("bench.csv", &format!("time_s,force_n,response_mm\n{rows}"));
    let packed = std::process::Command::new("gzip").args(["-k", "bench.csv"]).current_dir(bench.path("")).status();
    let packed = packed.is_ok_and(|status| status.success());
    let streams =
        [("bench.csv", "-", true), ("bench.csv", "-", false), ("bench.csv", "/dev/stdin", true), ("bench.csv.gz", "-", true)];
    for (input, name, piped) in streams.into_iter().filter(|(input, ..)| packed || !input.ends_with("gz")) {
        if name != "-" && !cfg!(unix) {
            continue;
        }
        let said = bench.run_with(input, piped, &["-q", "--json", "diagnose", name, "--base", "linear", "-o", "out"]);
        assert!(said.code < 2 && said.out.contains("\"rows\":60"), "{input} {name}: {}{}", said.out, said.err);
        let said = bench.run_with(input, piped, &["init", name]);
        assert!(said.code == 0 && said.out.contains("file = \"-\"") && said.out.contains("force = \"force_n\""), "{}", said.out);
        assert!(
            said.err.contains("put its name in place of `-`") && !bench.names().contains(&"-.toml".to_owned()),
            "{}",
            said.err
        );
    }
    // the order of dates is looked for in all rows, and a stream is there once
    let said = bench.run_with("dates.csv", true, &["init", "-"]);
    assert!(said.code == 0 && said.out.contains("# dayfirst = true"), "{}{}", said.out, said.err);
}
