//! A fit that nothing can be said against, and that is wrong: its residual is the noise, and its modulus is off by a third.

#![allow(clippy::unwrap_used)]

mod common;

use common::Bench;
use serde_json::Value;

const RECORDING: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../validation/recordings/concealed");
/// Modulus of the silicone of the sensor that was recorded, Pa (README of the recording).
const TRUE_YOUNG: f64 = 1_010_270.0;

#[test]
fn a_perfect_fit_with_a_wrong_modulus_is_not_believed() {
    let bench = Bench::new();
    let said = bench.run(&["-q", "diagnose", RECORDING, "-o", "out"]);
    assert_eq!(said.code, 1, "{}{}", said.out, said.err);
    let diagnosis: Value = serde_json::from_str(&std::fs::read_to_string(bench.path("out/diagnosis.json")).unwrap()).unwrap();

    // the calibrated base model leaves noise, and nothing else
    let columns = std::fs::read_to_string(bench.path("out/prediction.csv")).unwrap();
    let rows: Vec<Vec<f64>> = columns.lines().skip(1).map(|line| line.split(',').map(|v| v.parse().unwrap()).collect()).collect();
    let mean = rows.iter().map(|r| r[4]).sum::<f64>() / rows.len() as f64;
    let left: f64 = rows.iter().map(|r| (r[4] - r[5]).powi(2)).sum();
    let all: f64 = rows.iter().map(|r| (r[4] - mean).powi(2)).sum();
    assert!(1.0 - left / all > 0.9999, "R^2 = {}", 1.0 - left / all);
    let fit = &diagnosis["fit"];
    let number = |value: &Value| value.as_f64().unwrap();
    assert!(number(&fit["in_sample"]["rmse_before"]) < 1.02 * number(&fit["noise_floor"]), "{fit}");

    // and yet: the modulus is off by a third, the tool says so, and knows why
    let young = |key: &str| {
        let list = diagnosis["base"][key].as_array().unwrap();
        let own = list.iter().find(|p| p["name"] == "young_rtv").unwrap();
        (number(&own["value"]), number(&own["sd"]))
    };
    let (wrong, right) = (young("parameters"), young("parameters_after"));
    assert!(wrong.0 > 1.33 * TRUE_YOUNG, "{wrong:?}");
    assert!((right.0 - TRUE_YOUNG).abs() < 3.0 * right.1 && right.1 < 0.05 * TRUE_YOUNG, "{right:?}");
    assert_eq!(diagnosis["concealed"], true);
    let conflicts = diagnosis["conflicts"].as_array().unwrap();
    assert!(conflicts.iter().any(|c| c["parameter"] == "young_rtv" && number(&c["z"]) > 5.0), "{conflicts:?}");
    assert_eq!(diagnosis["verdict"], "explained");
    let named: Vec<&str> = diagnosis["findings"].as_array().unwrap().iter().map(|f| f["effect"].as_str().unwrap()).collect();
    assert_eq!(named, ["permittivity_temperature"]);
}
