//! `truegap audit` from the command line.

#![allow(clippy::unwrap_used)]

mod common;

use common::Bench;
use serde_json::Value;

#[test]
fn an_audit_writes_its_rows_and_says_that_there_is_something_to_look_at() {
    let bench = Bench::new();
    let arguments =
        ["audit", "--only", "TAIL-PARALLEL-PLATE,MIXING-PARALLEL", "--cache", "cache", "-o", "out", "--json", "--quiet"];
    let said = bench.run(&arguments);
    assert_eq!(said.code, 1, "{}", said.err);
    let printed: Value = serde_json::from_str(&said.out).unwrap();
    let written: Value = serde_json::from_str(&std::fs::read_to_string(bench.path("out/audit.json")).unwrap()).unwrap();
    assert_eq!(printed, written);
    assert_eq!(written["schema"], "truegap.audit/1");
    let rows = written["assumptions"].as_array().unwrap();
    assert_eq!(rows.len(), 2);
    for row in rows {
        for key in ["id", "says", "analytic", "fem", "relative_error", "verdict", "reason", "effect_on", "measure"] {
            assert!(!row[key].is_null(), "{key} is missing");
        }
        assert!(row["fem"]["error_estimate"].as_f64().unwrap() < 1e-2 * row["fem"]["value"].as_f64().unwrap());
        assert!(row["effect_on"]["k_baseline_pct"].is_number());
    }
    let page = std::fs::read_to_string(bench.path("out/report.html")).unwrap();
    assert!(page.contains("MIXING-PARALLEL") && page.contains("<svg") && !page.contains("https://"));
    // Remembered: the second run reads two files and says the same.
    assert_eq!(std::fs::read_dir(bench.path("cache")).unwrap().count(), 2);
    assert_eq!(bench.run(&arguments).out, said.out);
}

/// The audit kept its findings elsewhere than everything else that may be computed again.
#[test]
fn findings_are_kept_where_truegap_cache_says() {
    let bench = Bench::new();
    let mut command = std::process::Command::new(env!("CARGO_BIN_EXE_truegap"));
    command.args(["-q", "audit", "--only", "POLYIMIDE-UNIFORM-STRESS", "--no-scene"]).current_dir(bench.path("."));
    let output =
        command.env("TRUEGAP_CACHE", bench.path("kept")).env("XDG_CACHE_HOME", bench.path("elsewhere")).output().unwrap();
    assert!(output.status.success(), "{output:?}");
    assert_eq!(std::fs::read_dir(bench.path("kept/audit")).unwrap().count(), 1);
    assert!(!bench.path("elsewhere").exists());
}

#[test]
fn what_holds_is_fine() {
    let bench = Bench::new();
    let said = bench.run(&["audit", "--only", "POLYIMIDE-UNIFORM-STRESS", "--no-cache", "--quiet"]);
    assert_eq!(said.code, 0, "{}{}", said.out, said.err);
    assert!(said.out.contains("0 broken, 0 strained, 1 hold"), "{}", said.out);
}

#[test]
fn an_assumption_that_is_not_there_is_answered_with_the_register() {
    Bench::new().refuses(&["audit", "--only", "NO-FRINGES", "--no-cache"], &["NO-FRINGES", "NO-FRINGING", "BIMETAL-STRIP"]);
    Bench::new().refuses(&["audit", "--sensor", "singletact-s15-45n", "--no-cache"], &["singletact-s15-4.5n"]);
}

const SPACE: &str = r#"
schema = "truegap.space/1"
sensor = "singletact-s15-4.5n"
designs = 6
seed = 3
only = ["TAIL-PARALLEL-PLATE", "MIXING-PARALLEL"]
[axes]
height = "150 um:210 um"
conductor = "10 um,17 um,34 um"
bead_count = "50:70"
"#;

#[test]
fn a_space_in_shards_is_the_space_in_one() {
    let bench = Bench::new();
    bench.file("space.toml", SPACE);
    let audit = |more: &[&str]| bench.run(&[&["audit", "--space", "space.toml", "--quiet"], more].concat());
    assert_eq!(audit(&["-o", "whole"]).code, 1);
    // Out of order, and one of them twice.
    for shard in ["2/3", "1/3", "3/3", "1/3"] {
        let said = audit(&["-o", "parts", "--shard", shard]);
        assert_eq!(said.code, 0, "{}{}", said.out, said.err);
    }
    assert_eq!(bench.run(&["merge", "parts"]).code, 1);
    for name in ["audit-space.json", "audit-space.csv", "report.html"] {
        let read = |folder: &str| std::fs::read(bench.path(folder).join(name)).unwrap();
        assert_eq!(read("whole"), read("parts"), "{name}");
        assert!(read("whole").len() > 500);
    }
    let text = std::fs::read_to_string(bench.path("whole/audit-space.csv")).unwrap();
    // Two rows a design; designs whose gap closes have none.
    assert!(text.lines().count() % 2 == 1 && text.lines().count() >= 7, "{text}");
}

#[test]
fn a_space_that_cannot_be_read_says_what_to_write() {
    let bench = Bench::new();
    bench.file("a.toml", &SPACE.replace("space/1", "space/9"));
    bench.refuses(&["audit", "--space", "a.toml", "-o", "x"], &["a.toml", "truegap.space/9", "truegap.space/1"]);
    bench.file("b.toml", &SPACE.replace("height", "hight"));
    bench.refuses(&["audit", "--space", "b.toml", "-o", "x"], &["hight"]);
    bench.refuses(&["audit", "--space", "nowhere.toml", "-o", "x"], &["nowhere.toml"]);
}
