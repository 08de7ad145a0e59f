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
