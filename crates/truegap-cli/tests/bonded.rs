//! A recording that finite elements have made, set against the paper's model: what is missing was computed beforehand, and is found at its computed size.

#![allow(clippy::unwrap_used)]

mod common;

use common::Bench;
use serde_json::Value;

const RECORDING: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../validation/recordings/bonded");
/// Modulus of the silicone that the finite elements were given, Pa: 1.06 of that in the sensor's file.
const TRUE_YOUNG: f64 = 1.06 * 1_075_000.0;

#[test]
fn what_finite_elements_foresee_is_found_in_a_recording_that_they_made() {
    let bench = Bench::new();
    let said = bench.run(&["-q", "diagnose", RECORDING, "-o", "out"]);
    assert_eq!(said.code, 1, "{}{}", said.out, said.err);
    let diagnosis: Value = serde_json::from_str(&std::fs::read_to_string(bench.path("out/diagnosis.json")).unwrap()).unwrap();
    let number = |value: &Value| value.as_f64().unwrap();

    assert_eq!(diagnosis["verdict"], "explained", "{}", diagnosis["says"]);
    let findings = diagnosis["findings"].as_array().unwrap();
    let mut named: Vec<&str> = findings.iter().map(|f| f["effect"].as_str().unwrap()).collect();
    named.sort_unstable();
    assert_eq!(named, ["bonded_layers", "held_warp"]);
    // no number of the curves was fitted: the share is 1 within three of its own deviations, and those are below a tenth
    for finding in findings {
        let share = &finding["parameters"][0];
        let (value, sd) = (number(&share["value"]), number(&share["sd"]));
        assert!((value - 1.0).abs() < 3.0 * sd && sd < 0.1, "{finding}");
    }
    let young = |key: &str| {
        let list = diagnosis["base"][key].as_array().unwrap();
        let own = list.iter().find(|p| p["name"] == "young_rtv").unwrap();
        (number(&own["value"]), number(&own["sd"]))
    };
    // calibration alone makes the silicone several times stiffer; with the physics in the model it is what it was
    assert!(young("parameters").0 > 3.0 * TRUE_YOUNG, "{:?}", young("parameters"));
    let right = young("parameters_after");
    assert!((right.0 - TRUE_YOUNG).abs() < 3.0 * right.1 && right.1 < 0.05 * TRUE_YOUNG, "{right:?}");
    // a base model that bends all its numbers, by least squares, still misses by half the noise more; 1440 rows: the noise is known to 2 %
    let (fit, floor) = (&diagnosis["fit"]["held_out"], number(&diagnosis["fit"]["noise_floor"]));
    assert!(number(&fit["rmse_before"]) > 1.4 * floor && number(&fit["rmse_after"]) < 1.06 * floor, "{fit}");
}
