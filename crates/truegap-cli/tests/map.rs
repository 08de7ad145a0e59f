//! Columns named on the command line in place of a TOML.

#![allow(clippy::unwrap_used)]

mod common;

use common::Bench;
use serde_json::Value;

/// A straight line of a reading in a load, in columns that no default name fits.
fn bench() -> Bench {
    let bench = Bench::new();
    let load = |i: usize| 2.0 + (i as f64 / 9.0).sin();
    let row = |i: usize| format!("{i},{},{}\n", load(i), 3.0 + load(i) + 1e-3 * ((i * 37 % 11) as f64));
    let rows: String = (0..120).map(row).collect();
    bench.file("bench.csv", &format!("Elapsed,Load cell: left,C_measured\n{rows}"));
    bench
}

const TYPED: [&str; 6] = ["-q", "diagnose", "bench.csv", "--base", "linear", "--map"];

/// The only way without a TOML was to rename the columns in the file.
#[test]
fn columns_are_named_with_their_units_where_no_toml_is() {
    let bench = bench();
    let map = ["response=C_measured:fF", "--map", "force=Load cell: left:mN", "--map", "time=Elapsed:s", "-o", "out"];
    let said = bench.run(&[&TYPED[..], &map].concat());
    assert!(said.code < 2, "{}", said.err);
    let json: Value = serde_json::from_str(&std::fs::read_to_string(bench.path("out/diagnosis.json")).unwrap()).unwrap();
    let first = std::fs::read_to_string(bench.path("out/prediction.csv")).unwrap().lines().take(2).collect::<Vec<_>>().join("\n");
    assert_eq!(json["recording"]["rows"], 120);
    // 2 mN and 5 fF, in newton and picofarad
    assert!(first.contains("0.002") && first.contains("0.005"), "{first}");
}

#[test]
fn what_is_mapped_to_what_is_not_there_is_told_with_what_is() {
    let bench = bench();
    let refuses = |map: &str, parts: &[&str]| bench.refuses(&[&TYPED[..], &[map, "-o", "out"]].concat(), parts);
    refuses("response=C_mesured:pF", &["`C_mesured`", "did you mean `C_measured`", "`Elapsed`, `Load cell: left`", "--map"]);
    refuses("response=C_measured:PF", &["--map response", "`PF`", "pF"]);
    // clap refuses what is no map before anything is read
    let said = bench.run(&[&TYPED[..], &["forse=Elapsed"]].concat());
    assert!(said.code == 2 && said.err.contains("did you mean `force`"), "{}", said.err);
    let said = bench.run(&[&TYPED[..], &["force"]].concat());
    assert!(said.code == 2 && said.err.contains("ROLE=COLUMN:UNIT"), "{}", said.err);
}

#[test]
fn a_map_goes_before_the_toml() {
    let bench = bench();
    let toml = "schema = \"truegap.recording/1\"\nfile = \"bench.csv\"\n[columns]\nforce = \"Elapsed\"\nresponse = \"C_measured\"\n[units]\nforce = \"kN\"\nresponse = \"pF\"\n[base]\nmodel = \"linear\"\n";
    bench.file("bench.toml", toml);
    let typed = ["--json", "-q", "diagnose", "bench.toml", "--map", "force=Load cell: left:N", "-o", "out"];
    let said = bench.run(&typed);
    let slope = said.out.contains("\"verdict\":\"agrees\"");
    assert!(said.code == 0 && slope, "{}{}", said.out, said.err);
}
