//! The example from a CSV to a verdict says what its CSV was made with.

#![allow(clippy::unwrap_used)]

#[path = "../examples/diagnose_csv.rs"]
#[allow(dead_code)] // its `main` prints
mod example;

use truegap_diagnose::Verdict;

/// `force_gauge.csv` was made with a lag of 4 s; a lag of the electronics and one of the gauge itself look the same in it.
#[test]
fn the_lag_in_the_csv_is_found_and_its_time_constant_agrees() {
    let found = example::diagnosed(concat!(env!("CARGO_MANIFEST_DIR"), "/examples/force_gauge.csv")).unwrap();
    assert_eq!(found.verdict, Verdict::Ambiguous, "{}", found.says);
    assert!(found.ambiguity.iter().any(|set| ["readout_lag", "slow_response"].iter().all(|lag| set.iter().any(|id| id == lag))));
    let tau = &found.findings[0].parameters[0];
    assert!((tau.value - 4.0).abs() < 3.0 * tau.sd && tau.sd < 0.1, "{} s (sd {})", tau.value, tau.sd);
}
